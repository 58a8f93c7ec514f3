// Tests for numbers/format.js and numbers/ticks.js.

import assert from "node:assert/strict";
import test from "node:test";
import { formatCell, formatNumber, sizeOf, tickLabels } from "../numbers/format.js";
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

test("what rounding leaves of zero is zero, beside numbers of a size or in a column of digits", () => {
  assert.equal(formatNumber(2.1e-12, undefined, 5), "0");
  assert.equal(formatNumber(-2.1e-12, 3, 5), "0.000");
  assert.equal(formatNumber(2.1e-12, 3), "0.000");
  assert.equal(formatNumber(2.1e-12), "2.1e\u221212");
  assert.equal(formatNumber(3e-9, undefined, 5), "3e\u22129");
});

test("the size of a list is that of its largest number", () => {
  assert.equal(sizeOf([1, -7, null, NaN, "9"]), 7);
  assert.equal(sizeOf([]), 0);
});

test("ticks of one axis have the decimals that tell them apart", () => {
  assert.deepEqual(tickLabels([0, 0.05, 0.1]), ["0.00", "0.05", "0.10"]);
  assert.deepEqual(tickLabels([3.9, 3.9001, 3.9002]), ["3.9000", "3.9001", "3.9002"]);
  assert.deepEqual(tickLabels([-50, 0, 50]), ["\u221250", "0", "50"]);
  assert.deepEqual(tickLabels([0, 2.5, 5]), ["0.0", "2.5", "5.0"]);
  assert.deepEqual(tickLabels([7]), ["7"]);
});

test("ticks of a very small or large axis share an exponent", () => {
  assert.deepEqual(tickLabels([0, 5e-6, 1e-5]), ["0", "0.5e\u22125", "1.0e\u22125"]);
  assert.deepEqual(tickLabels([1e6, 2e6]), ["1e6", "2e6"]);
});

test("a tick that rounding put beside zero is zero", () =>
  assert.deepEqual(tickLabels([-0.1, 1e-17, 0.1]), ["\u22120.1", "0.0", "0.1"]));

test("ticks of any range differ, and read as what they are", () => {
  for (const [low, high] of [
    [0, 1],
    [3.8999, 3.9003],
    [-2e-7, 9e-7],
    [1e5, 1.00003e5],
    [-4e8, 7e8],
  ]) {
    const values = ticks(low, high, 6);
    const labels = tickLabels(values);
    assert.equal(new Set(labels).size, values.length, labels.join());
    labels.forEach((label, i) => {
      const read = Number(label.replace(/\u2212/g, "-"));
      assert.ok(Math.abs(read - values[i]) < 1e-6 * (high - low), `${label} for ${values[i]}`);
    });
  }
});

test("values that differ less than their rounding are one value", () => {
  const [low, high] = extent([3.9, 3.9 + 1e-6, 3.9 - 2e-6], 0.06, 1e-4);
  assert.ok(low < 2 && high > 5.8);
  const [from, to] = extent([3.9, 3.95], 0, 1e-4);
  assert.deepEqual([from, to], [3.9, 3.95]);
  assert.deepEqual(extent([0, 1e-15], 0), [0, 1e-15]);
});
