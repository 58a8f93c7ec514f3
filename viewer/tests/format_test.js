// Tests for numbers/format.js and numbers/ticks.js.

import assert from "node:assert/strict";
import test from "node:test";
import { formatCell, formatNumber } from "../numbers/format.js";
import { extent, linear, niceStep, ticks } from "../numbers/ticks.js";

test("missing numbers read n/a", () => {
  for (const value of [null, undefined, NaN, Infinity]) assert.equal(formatNumber(value), "n/a");
  assert.equal(formatCell(null), "n/a");
});

test("without digits, four figures are significant", () => {
  assert.equal(formatNumber(1.23456), "1.235");
  assert.equal(formatNumber(123456), "123456");
  assert.equal(formatNumber(0.5), "0.5");
  assert.equal(formatNumber(100), "100");
  assert.equal(formatNumber(0), "0");
  assert.equal(formatNumber(0.000012345), "1.234e\u22125");
  assert.equal(formatNumber(2e7), "2e7");
});

test("digits count those after the point, and keep zeros so that columns align", () => {
  assert.equal(formatNumber(2, 3), "2.000");
  assert.equal(formatNumber(-1.005, 1), "\u22121.0");
});

test("a small number is not rounded to zero", () =>
  assert.equal(formatNumber(0.0004, 2), "4e\u22124"));

test("cells show text, and words for truth values", () => {
  assert.equal(formatCell("FDS"), "FDS");
  assert.equal(formatCell(false), "no");
});

test("steps are 1, 2 or 5 times a power of ten", () => {
  assert.equal(niceStep(0.013), 0.02);
  assert.equal(niceStep(3), 5);
  assert.equal(niceStep(10), 10);
});

test("ticks lie within the range", () => {
  assert.deepEqual(ticks(-1, 1, 4), [-1, -0.5, 0, 0.5, 1]);
  assert.deepEqual(ticks(0.1, 0.35, 3), [0.1, 0.2, 0.3]);
});

test("the extent of one value has room around it", () => assert.deepEqual(extent([2]), [1, 3]));

test("a linear map meets its ends", () => {
  const map = linear([1, 3], [10, 0]);
  assert.deepEqual([map(1), map(2), map(3)], [10, 5, 0]);
});
