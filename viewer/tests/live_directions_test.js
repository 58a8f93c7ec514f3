// Vectors of the server's frames beside a picture of the world.

import assert from "node:assert/strict";
import test from "node:test";
import { Quaternion, Vector3 } from "three";
import { rotated, rotatedWrench, rotationOf, wrenchWords } from "../live/link/directions.js";
import { axisFacts } from "../live/panels/fit_panel.js";
import { qualityFacts } from "../live/panels/grasp_panel.js";
import { restFacts } from "../live/panels/tendon_panel.js";

const HALF = Math.SQRT1_2;
const ABOUT_Z = [HALF, 0, 0, HALF]; // a quarter turn: x to y, y to -x

test("a quarter turn about z takes x to y and y to minus x", () => {
  const near = (a, b) => a.forEach((v, i) => assert.ok(Math.abs(v - b[i]) < 1e-15, `${a}`));
  near(rotated([1, 2, 3], ABOUT_Z), [-2, 1, 3]);
  near(rotatedWrench([1, 0, 0, 0, 1, 0], ABOUT_Z), [0, 1, 0, -1, 0, 0]);
});

test("vectors turn as three.js turns them", () => {
  for (let i = 1; i < 20; ++i) {
    const q = new Quaternion(Math.sin(i), Math.cos(3 * i), Math.sin(5 * i), 0.3).normalize();
    const v = [Math.cos(i), -i, Math.sin(7 * i)];
    const wanted = new Vector3(...v).applyQuaternion(q).toArray();
    rotated(v, [q.w, q.x, q.y, q.z]).forEach((c, k) => assert.ok(Math.abs(c - wanted[k]) < 1e-12));
  }
});

test("a tip force is told in the frame of the picture", () => {
  const facts = Object.fromEntries(restFacts({ tip_force: [2, 1, 0], rotation: ABOUT_Z }));
  assert.equal(facts["along x, y, z"], "\u22121.00, 2.00, 0.00 N");
});

test("the worst disturbance is told in the frame of the picture", () => {
  const quality = {
    closed: true,
    force_closure: true,
    epsilon: { lower: 0.1, upper: 0.1 },
    worst_wrench: [0, 0, -0.9, 0, 0.4, 0],
  };
  const words = (rotation) =>
    Object.fromEntries(qualityFacts(quality, rotation))["Worst disturbance"];
  assert.equal(words(ABOUT_Z), "force along \u2212z, torque about \u2212x");
  assert.equal(words(null), "force along \u2212z, torque about +y (the object's axes)");
});

test("small parts of a wrench are not named", () => {
  assert.equal(wrenchWords([1, 0.3, 0, 0, -0.4, 0]), "force along +x, torque about \u2212y");
  assert.equal(wrenchWords([0, 0, 0, 0, 0, 0]), "none");
});

test("a body's rotation follows its position in a frame", () => {
  const frame = { bodies: new Float32Array([1, 2, 3, 1, 0, 0, 0, 4, 5, 6, 0, 0, 0, 1]) };
  assert.deepEqual(rotationOf(frame, 1), [0, 0, 0, 1]);
  assert.equal(rotationOf(frame, 2), null);
  assert.equal(rotationOf(frame, -1), null);
});

test("axes of a fit are told in the frame of the picture", () => {
  const axis = { direction: [1, 0, 0], point: [0, 0.01, 0.02] };
  assert.deepEqual(axisFacts(axis, ABOUT_Z), [
    ["Direction", "0.00, 1.00, 0.00"],
    ["Point", "\u221210.00, 0.00, 20.00 mm"],
  ]);
});
