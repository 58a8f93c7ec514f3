// Pointers on discs of joints, and how quantities read.

import assert from "node:assert/strict";
import test from "node:test";
import { QUANTITIES, told, typed } from "../live/link/quantities.js";
import { across, follow } from "../live/link/turning.js";

const near = (a, b, tolerance = 1e-9) =>
  assert.ok(Math.abs(a - b) < tolerance, `${a} against ${b}`);

/// A ray straight down onto (x, y).
const down = (x, y) => ({ from: [x, y, 5], way: [0, 0, -1] });
const at = (angle) => down(1 + 2 * Math.cos(angle), 2 * Math.sin(angle));

test("a pointer that goes about the axis turns the joint as far", () => {
  const joint = { axis: [0, 0, 1], point: [1, 0, 0], slides: false };
  const turn = follow(joint, at(0.3), 1);
  near(turn(at(1.3)), 1);
  near(turn(at(0.1)), -0.2);
});

test("more than half a turn is counted on", () => {
  const joint = { axis: [0, 0, -1], point: [1, 0, 0], slides: false };
  const turn = follow(joint, at(0), 1);
  let last = 0;
  for (let angle = 0; angle <= 5; angle += 0.25) last = turn(at(angle));
  near(last, -5);
});

test("a disc seen from its edge turns as its near side goes", () => {
  const joint = { axis: [0, 1, 0], point: [0, 0, 0], slides: false };
  const turn = follow(joint, down(0, 0), 0.5);
  // At the near side (0, 0, 0.5) a turn by +q about y moves towards +x: 0.5 m each radian.
  near(turn(down(0.1, 0)), 0.2);
  near(turn(down(-0.1, 0.3)), -0.2);
});

test("a joint that slides follows the pointer along its axis", () => {
  const joint = { axis: [1, 0, 0], point: [0, 0, 0], slides: true };
  const slide = follow(joint, down(0.2, 0.1), 1);
  near(slide(down(0.5, -0.4)), 0.3);
});

test("a direction across an axis is across it, also where the wish lies along it", () => {
  for (const wish of [
    [1, 2, 3],
    [0, 0, 4],
    [0, 0, 0],
  ]) {
    const v = across([0, 0, 2], wish);
    near(Math.hypot(...v), 1);
    near(v[2], 0);
  }
});

test("quantities are shown with their unit and typed back", () => {
  assert.equal(told(Math.PI / 6, QUANTITIES.angle), "30.0\u00b0");
  assert.equal(told(-0.0125, QUANTITIES.length), "\u221212.5\u202fmm");
  assert.equal(told(NaN, QUANTITIES.force), "n/a");
  assert.equal(told(-1e-9, QUANTITIES.angle), "0.0\u00b0");
  near(typed("\u221230", QUANTITIES.angle), -Math.PI / 6);
  near(typed("12,5", QUANTITIES.length), 0.0125);
  assert.equal(typed("abc", QUANTITIES.angle), null);
  assert.equal(typed(" ", QUANTITIES.angle), null);
});
