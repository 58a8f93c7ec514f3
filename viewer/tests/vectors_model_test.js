// Tests for report/vectors_model.js.

import assert from "node:assert/strict";
import test from "node:test";
import {
  commonScale,
  ELLIPSE_RADIUS,
  groupsOf,
  misfit,
  planeRange,
} from "../report/vectors_model.js";

const arrow = (group, measured, predicted, more) => ({ group, measured, predicted, ...more });
const planeOf = (...panels) => ({
  name: "p",
  panels: panels.map((arrows) => ({ title: "t", arrows })),
});

test("the ellipse holds 95 % of a normal distribution", () =>
  assert.ok(Math.abs(1 - Math.exp(-(ELLIPSE_RADIUS ** 2) / 2) - 0.95) < 1e-4));

test("a plane's range holds the origin and every arrow of every panel", () => {
  const [x, y] = planeRange(
    planeOf([arrow("A", [1, 2], [3, -1])], [arrow("A", [5, 0], [null, 0])]),
  );
  assert.ok(x[0] <= 0 && x[1] >= 5 && y[0] <= -1 && y[1] >= 2);
});

test("a plane's range holds the ellipses", () => {
  const [x] = planeRange(planeOf([arrow("A", [1, 0], [0, 0], { sd: [10, 1] })]));
  assert.ok(x[0] < 1 - 24 && x[1] > 1 + 24);
});

test("one scale serves the widest and the tallest plane", () => {
  const ranges = [
    [
      [0, 10],
      [0, 1],
    ],
    [
      [0, 1],
      [0, 20],
    ],
  ];
  assert.equal(commonScale(ranges, 100, 100), 5);
});

test("the misfit is a length, or missing", () => {
  assert.equal(misfit(arrow("A", [3, 0], [0, 4])), 5);
  assert.equal(misfit(arrow("A", [null, 0], [0, 4])), null);
});

test("tendons come in order of first appearance", () => {
  const planes = [planeOf([arrow("B"), arrow("A")], [arrow("B")])];
  assert.deepEqual(groupsOf({ planes }), ["B", "A"]);
});
