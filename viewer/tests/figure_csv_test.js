// Tests for report/figure_csv.js.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { csvOf } from "../report/csv.js";
import { figureTable, fileName } from "../report/figure_csv.js";

const sample = JSON.parse(readFileSync(join(import.meta.dirname, "../sample/report.json"), "utf8"));

test("curves become a row a point, in full precision", () => {
  const series = [
    { name: "a", x: [0, 1], y: [0.1234567890123, null] },
    { name: "b", x: [2], y: [3], band_low: [2], band_high: [4], labels: ["here"] },
  ];
  const text = csvOf(
    figureTable({ type: "lines", x_label: "time [s]", y_label: "force [N]", series }),
  );
  assert.deepEqual(text.split("\r\n"), [
    "series,time [s],force [N],band_low,band_high,label",
    "a,0,0.1234567890123,,,",
    "a,1,,,,",
    "b,2,3,2,4,here",
    "",
  ]);
});

test("every chart of the sample has as many cells in a row as columns, and rows", () => {
  const open = (block) => [block, ...(block.blocks ?? []).flatMap(open)];
  const blocks = sample.sections.flatMap((section) => section.blocks.flatMap(open));
  const tables = blocks.map(figureTable).filter(Boolean);
  assert.ok(tables.length >= 7);
  for (const { columns, rows } of tables)
    assert.ok(rows.length > 0 && rows.every((row) => row.length === columns.length));
});

test("texts and scenes have no numbers to save", () =>
  assert.equal(figureTable({ type: "text", text: "a" }), null));

test("a file is named after the caption", () => {
  assert.equal(fileName("Tension of the slips, [N]", "lines"), "tension-of-the-slips-n");
  assert.equal(fileName(undefined, "lines"), "lines");
});
