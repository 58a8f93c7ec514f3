// Where words on the live picture may stand.

import assert from "node:assert/strict";
import test from "node:test";
import { coveredBoxes } from "../live/view/covered.js";

// A narrow window with a sheet of 400 px over its lower half.
const stage = { width: 390, height: 800, insets: { left: 0, right: 0, top: 44, bottom: 400 } };
const covers = (boxes, x, y) =>
  boxes.some(({ left, right, top, bottom }) => left < x && x < right && top < y && y < bottom);

test("words keep off panels, triad and scale bar, which stand above the panels", () => {
  const boxes = coveredBoxes(stage);
  assert.ok(covers(boxes, 200, 20), "the bar");
  assert.ok(covers(boxes, 200, 500), "the sheet");
  assert.ok(covers(boxes, 30, 340), "the triad");
  assert.ok(covers(boxes, 350, 380), "the scale bar");
  assert.ok(!covers(boxes, 200, 340), "the picture between them");
  assert.ok(!covers(boxes, 30, 300), "the picture above the triad");
});

test("words keep off the legend where there is one", () => {
  const legend = { left: 10, right: 250, top: 290, bottom: 312 };
  assert.ok(!covers(coveredBoxes(stage), 100, 300));
  assert.ok(covers(coveredBoxes(stage, legend), 100, 300));
});
