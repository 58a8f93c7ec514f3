// Tests for report/table_model.js and report/csv.js.

import assert from "node:assert/strict";
import test from "node:test";
import { csvOf } from "../report/csv.js";
import { bestRows, isNumeric, matching, sortedBy } from "../report/table_model.js";

const rows = [
  ["b", 2],
  ["a", null],
  ["c", 1],
  ["d", 1],
];
const block = { columns: [{ name: "id" }, { name: "error", unit: "N" }], rows };

test("the best value is the lowest, and may be shared", () =>
  assert.deepEqual([...bestRows({ ...block, highlight_best: 1 })], [rows[2], rows[3]]));

test("the best value may be the highest", () =>
  assert.deepEqual([...bestRows({ ...block, highlight_best: 1, best: "highest" })], [rows[0]]));

test("nothing is best where nothing was asked for", () => assert.equal(bestRows(block).size, 0));

test("a column with missing values is still one of numbers", () => {
  assert.equal(isNumeric(block, 1), true);
  assert.equal(isNumeric(block, 0), false);
});

test("missing values come last in either order", () => {
  const ids = (descending) =>
    sortedBy(rows, { column: 1, descending })
      .map(([id]) => id)
      .join("");
  assert.equal(ids(false), "cdba");
  assert.equal(ids(true), "bcda");
});

test("numbers inside names sort as numbers", () => {
  const sorted = sortedBy([["joint 10"], ["joint 9"]], { column: 0, descending: false });
  assert.deepEqual(sorted, [["joint 9"], ["joint 10"]]);
});

test("the search ignores case", () => assert.deepEqual(matching(rows, " A"), [rows[1]]));

test("CSV quotes what it must and leaves missing cells empty", () => {
  const text = csvOf({
    columns: block.columns,
    rows: [
      ['a,"b"', 0.1],
      ["c", null],
    ],
  });
  assert.equal(text, 'id,error [N]\r\n"a,""b""",0.1\r\nc,\r\n');
});
