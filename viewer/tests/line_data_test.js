// Tests for report/line_data.js.

import assert from "node:assert/strict";
import test from "node:test";
import { lineData } from "../report/line_data.js";

const series = (name, x, y, more = {}) => ({ name, x, y, ...more });

test("series share the union of their x", () => {
  const { data } = lineData({ series: [series("a", [1, 3], [10, 30]), series("b", [2], [5])] });
  assert.deepEqual(data, [
    [1, 2, 3],
    [10, undefined, 30],
    [undefined, 5, undefined],
  ]);
});

test("a missing value is a gap, not a bridge", () => {
  const { data, lost } = lineData({ series: [series("a", [1, 2, 3], [1, null, 3])] });
  assert.deepEqual(data[1], [1, null, 3]);
  assert.equal(lost, 1);
});

test("points come in order of x", () => {
  const { data } = lineData({ series: [series("a", [3, 1, 2], [30, 10, 20])] });
  assert.deepEqual(data, [
    [1, 2, 3],
    [10, 20, 30],
  ]);
});

test("repeated x keep all their points", () => {
  const { data } = lineData({ series: [series("a", [1, 1, 2], [5, 6, 7]), series("b", [1], [9])] });
  assert.deepEqual(data, [
    [1, 1, 2],
    [5, 6, 7],
    [9, undefined, undefined],
  ]);
});

test("a logarithmic axis cannot show zero or less", () => {
  const block = { log_x: true, log_y: true, series: [series("a", [0, 1, 10], [1, 0, 2])] };
  const { data, lost } = lineData(block);
  assert.deepEqual(data, [
    [1, 10],
    [null, 2],
  ]);
  assert.equal(lost, 2);
});

test("a band adds its two edges after its series", () => {
  const band = { band_low: [0, 1], band_high: [2, null] };
  const { data, plan } = lineData({ series: [series("a", [1, 2], [1, 2], band)] });
  assert.deepEqual(data, [
    [1, 2],
    [1, 2],
    [0, 1],
    [2, null],
  ]);
  assert.deepEqual(
    plan.map(({ part }) => part),
    ["y", "low", "high"],
  );
});
