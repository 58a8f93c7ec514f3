// Frames and meshes as the server sends them, written here by hand from the description of the format.

import assert from "node:assert/strict";
import test from "node:test";
import { decodeFrame, decodeMesh } from "../live/link/frame.js";

/// A frame of two bodies, one joint, one line of two points, one contact, one arrow.
function sample() {
  const size = 52 + 2 * 28 + 4 + 4 + 44 + 24 + 2 * 6;
  const view = new DataView(new ArrayBuffer(size));
  [..."THF1"].forEach((letter, i) => view.setUint8(i, letter.charCodeAt(0)));
  view.setUint32(4, 7, true);
  view.setUint32(8, 42, true);
  view.setFloat64(16, 1.25, true);
  [2, 1, 1, 1, 1, 2].forEach((n, i) => view.setUint16(24 + 2 * i, n, true));
  [0.5, -0.25, 2].forEach((v, i) => view.setFloat32(40 + 4 * i, v, true));
  let at = 52;
  const put = (...values) => values.forEach((v) => (view.setFloat32(at, v, true), (at += 4)));
  put(1, 2, 3, 1, 0, 0, 0);
  put(-1, -2, -3, 0, 1, 0, 0);
  put(0.75);
  put(NaN);
  view.setUint16(at, 1, true);
  view.setUint16(at + 2, 0xffff, true);
  at += 4;
  put(0.1, 0.2, 0.3, 0, 0, 1, 0, 0, 5, 0.8);
  put(0, 0, 1, 0, 2, 0);
  [100, 0, -100, 32767, -32768, 1].forEach((v) => (view.setInt16(at, v, true), (at += 2)));
  assert.equal(at, size);
  return view.buffer;
}

const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-6, `${a} against ${b}`);

test("a frame is read as it was written", () => {
  const frame = decodeFrame(sample());
  assert.equal(frame.revision, 7);
  assert.equal(frame.sequence, 42);
  assert.equal(frame.time, 1.25);
  assert.deepEqual([...frame.bodies], [1, 2, 3, 1, 0, 0, 0, -1, -2, -3, 0, 1, 0, 0]);
  assert.deepEqual([...frame.joints], [0.75]);
  assert.ok(Number.isNaN(frame.tensions[0]));
  const [contact] = frame.contacts;
  assert.equal(contact.a, 1);
  assert.equal(contact.b, -1);
  near(contact.point[2], 0.3);
  near(contact.force[2], 5);
  near(contact.friction, 0.8);
  assert.deepEqual([...frame.arrows], [0, 0, 1, 0, 2, 0]);
  near(frame.points[0], 0.501);
  near(frame.points[2], 1.999);
  near(frame.points[3], 0.5 + 0.32767);
  near(frame.points[4], -0.25 - 0.32768);
});

test("points of lines are counted in the step that the frame names", () => {
  const buffer = sample();
  new DataView(buffer).setUint16(36, 25, true); // in 1e-6 m
  const { points } = decodeFrame(buffer);
  near(points[0], 0.5 + 100 * 25e-6);
  near(points[3], 0.5 + 32767 * 25e-6);
  near(points[4], -0.25 - 32768 * 25e-6);
});

test("frames that are cut off, too long or of another kind are refused", () => {
  const whole = sample();
  for (const length of [0, 3, 51, 52, whole.byteLength - 1])
    assert.throws(() => decodeFrame(whole.slice(0, length)), /wanted|at least/);
  const long = new Uint8Array(whole.byteLength + 2);
  long.set(new Uint8Array(whole));
  assert.throws(() => decodeFrame(long.buffer), /wanted a frame of/);
  const other = whole.slice(0);
  new Uint8Array(other)[3] = 0x32;
  assert.throws(() => decodeFrame(other), /THF2/);
});

/// A mesh of one triangle as the server sends it.
function meshOf(vertices, corners, Corners) {
  const buffer = new ArrayBuffer(8 + 12 * vertices + 3 * Corners.BYTES_PER_ELEMENT);
  new Uint32Array(buffer, 0, 2).set([vertices, 1]);
  new Float32Array(buffer, 8, 9).set([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  new Corners(buffer, 8 + 12 * vertices, 3).set(corners);
  return buffer;
}

test("a mesh is read, and one that names missing corners is refused", () => {
  const { positions, triangles } = decodeMesh(meshOf(3, [0, 1, 2], Uint16Array));
  assert.deepEqual([...positions], [0, 0, 0, 1, 0, 0, 0, 1, 0]);
  assert.deepEqual([...triangles], [0, 1, 2]);
  assert.throws(() => decodeMesh(meshOf(3, [0, 1, 3], Uint16Array)), /beyond the 3/);
  assert.throws(() => decodeMesh(meshOf(3, [0, 1, 2], Uint16Array).slice(0, 40)), /wanted a mesh/);
});

test("meshes of more than 65536 vertices count them by four bytes", () => {
  assert.deepEqual([...decodeMesh(meshOf(65536, [0, 1, 65535], Uint16Array)).triangles], [0, 1, 65535]);
  assert.deepEqual([...decodeMesh(meshOf(65537, [0, 1, 65536], Uint32Array)).triangles], [0, 1, 65536]);
  assert.throws(() => decodeMesh(meshOf(65537, [0, 1, 2], Uint16Array)), /wanted a mesh/);
});
