// Tests of the coarser surfaces that are drawn while things move.

import assert from "node:assert/strict";
import { test } from "node:test";
import { BufferGeometry, IcosahedronGeometry } from "three";
import { mergeVertices } from "three/addons/utils/BufferGeometryUtils.js";
import { coarseOf, coarseTriangles } from "../live/view/coarse.js";

/// A ball of radius 10 mm whose triangles share vertices.
function ball(detail) {
  const made = new IcosahedronGeometry(0.01, detail);
  for (const name of ["uv", "normal"]) made.deleteAttribute(name);
  return mergeVertices(made, 1e-6);
}

/// How often each edge is there in its direction, less how often in the other.
function edgeSums(triangles) {
  const sums = new Map();
  for (let t = 0; t < triangles.length; t += 3)
    for (const [i, j] of [
      [0, 1],
      [1, 2],
      [2, 0],
    ]) {
      const [a, b] = [triangles[t + i], triangles[t + j]];
      const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
      sums.set(key, (sums.get(key) ?? 0) + (a < b ? 1 : -1));
    }
  return [...sums.values()];
}

function volume(positions, triangles) {
  let six = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) =>
      positions.subarray(3 * triangles[t + k], 3 * triangles[t + k] + 3),
    );
    six += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]);
    six += a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return six / 6;
}

test("a coarse ball has a fourth of the triangles or less, no hole, and its volume", () => {
  const fine = ball(20);
  const coarse = coarseOf(fine);
  assert.equal(coarse.attributes.position, fine.attributes.position);
  const triangles = coarse.index.array;
  assert.ok(
    triangles.length < 0.25 * fine.index.count,
    `${triangles.length} of ${fine.index.count}`,
  );
  assert.ok(
    triangles.length > 0.05 * fine.index.count,
    `${triangles.length} of ${fine.index.count}`,
  );
  // Every edge is there as often one way as the other: the surface stays closed.
  assert.ok(edgeSums(triangles).every((sum) => sum === 0));
  const whole = (4 / 3) * Math.PI * 0.01 ** 3;
  const made = volume(fine.attributes.position.array, triangles);
  assert.ok(Math.abs(made - whole) < 0.08 * whole, `${made} of ${whole} m3`);
});

test("triangles within one cell go, those between cells stay", () => {
  // Two vertices in the cell from 0 to 1 mm, one in each of two others.
  const positions = Float32Array.from([1e-4, 0, 0, 2e-4, 0, 0, 1.5e-3, 0, 0, 0, -0.5e-3, 0]);
  const triangles = Uint32Array.from([0, 1, 2, 0, 2, 3, 1, 2, 3]);
  assert.deepEqual([...coarseTriangles(positions, triangles, 1e-3)], [0, 2, 3, 0, 2, 3]);
});

test("a surface of few triangles, or with sharp edges, is left", () => {
  const few = ball(2);
  assert.equal(coarseOf(few), few);
  const sharp = new BufferGeometry().copy(ball(20)).toNonIndexed();
  assert.equal(coarseOf(sharp), sharp);
});
