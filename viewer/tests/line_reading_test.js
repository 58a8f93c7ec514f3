// Tests for report/line_reading.js and report/line_places.js.

import assert from "node:assert/strict";
import test from "node:test";
import { clearPlace, freePlace, pointsAlong } from "../report/line_places.js";
import { curveXs, nearestOf, nearestPoint, pointsAt } from "../report/line_reading.js";

const points = [
  [
    { x: 0, y: 1 },
    { x: 1, y: null },
    { x: 2, y: 3 },
  ],
  [
    { x: 0, y: 5 },
    { x: 2, y: 2 },
  ],
  [{ x: 9, y: 9 }],
];
const block = { series: [{ style: "lines" }, { style: "both" }, { style: "points" }] };
const all = [true, true, true];

test("all curves are told at one x, the highest first, hidden ones left out", () => {
  const told = (shown, x) => pointsAt(points, shown, x).map(({ s, y }) => [s, y]);
  assert.deepEqual(told(all, 0), [
    [1, 5],
    [0, 1],
  ]);
  assert.deepEqual(told([true, false, true], 2), [[0, 3]]);
  assert.deepEqual(told(all, 1), []);
});

test("the x of curves leave out gaps and scattered points", () =>
  assert.deepEqual(curveXs(block, points, all), [0, 2]));

test("the nearest value of a list", () => {
  assert.deepEqual(
    [-5, 0.9, 1.1, 7].map((x) => nearestOf([0, 2, 4], x)),
    [0, 0, 2, 4],
  );
  assert.equal(nearestOf([3], 100), 3);
  assert.equal(nearestOf([], 1), undefined);
});

test("the nearest point is within reach, shown, and has a value", () => {
  const from = (x) => (p) => Math.abs(p.x - x);
  assert.equal(nearestPoint(points, all, from(8.5), 1).s, 2);
  assert.equal(nearestPoint(points, [true, true, false], from(8.5), 1), null);
  assert.equal(nearestPoint(points, all, from(1.2), 2).x, 2);
});

test("a curve is followed a few pixels at a time, gaps left open", () => {
  const along = pointsAlong([[0, 0], [20, 0], null, [100, 0]]);
  assert.deepEqual(
    along.map(([x]) => x),
    [0, 5, 10, 15, 20, 100],
  );
});

const box = { left: 0, top: 0, width: 200, height: 100 };
const size = { width: 60, height: 10 };

test("words of a line stand where no curve runs", () => {
  const line = { axis: "y", at: 50 };
  const free = clearPlace(line, size, box, [], []);
  assert.ok(free.left < 10 && free.bottom <= 50, "at the left, above, if all is free");
  const curve = pointsAlong([
    [0, 40],
    [90, 40],
  ]);
  const place = clearPlace(line, size, box, curve, []);
  for (const [x, y] of curve)
    assert.ok(!(x > place.left && x < place.right && y > place.top && y < place.bottom));
});

test("words of an upright line at the right edge stand at its left", () => {
  const place = clearPlace({ axis: "x", at: 195 }, size, box, [], []);
  assert.ok(place.right <= 195);
});

test("words do not cover words", () => {
  const first = clearPlace({ axis: "y", at: 50 }, size, box, [], []);
  const second = clearPlace({ axis: "y", at: 52 }, size, box, [], [first]);
  assert.ok(second.left >= first.right || second.top >= first.bottom || second.bottom <= first.top);
});

test("a point without room for its name has none", () => {
  const everything = { left: -1e3, top: -1e3, right: 1e3, bottom: 1e3 };
  assert.equal(freePlace([50, 50], size, box, [everything]), undefined);
  assert.ok(freePlace([50, 50], size, box, []).left > 50);
  assert.ok(freePlace([190, 50], size, box, []).right < 190, "left of a point at the right edge");
});
