// Tests for report/check.js.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { BLOCK_TYPES, faults, isEmpty, reportFaults } from "../report/check.js";

const sample = JSON.parse(readFileSync(join(import.meta.dirname, "../sample/report.json"), "utf8"));

test("the sample has no faults", () => assert.deepEqual(reportFaults(sample), []));

test("the sample shows every block type", () => {
  const open = (block) => [block.type, ...(block.blocks ?? []).flatMap(open)];
  const shown = new Set(sample.sections.flatMap((section) => section.blocks.flatMap(open)));
  assert.deepEqual([...shown].sort(), [...BLOCK_TYPES].sort());
});

test("an unknown type is named", () => {
  assert.match(faults({ type: "pie" })[0], /^unknown block type "pie"; known are table/);
  assert.match(faults(null)[0], /unknown block type/);
});

test("a block without its content says what is wanted", () => {
  for (const type of BLOCK_TYPES) assert.ok(faults({ type }).length > 0, type);
  assert.match(faults({ type: "text" })[0], /^text: "text" must be a string/);
});

test("a ragged table names the row", () => {
  const block = { type: "table", columns: [{ name: "a" }, { name: "b" }], rows: [[1, 2], [3]] };
  assert.deepEqual(faults(block), ["table: row 1 has 1 cells, wanted 2"]);
});

test("a series of unequal lengths is refused", () => {
  const series = (more) => ({
    type: "lines",
    series: [{ name: "s", x: [1, 2], y: [1, 2], ...more }],
  });
  assert.equal(faults(series({})).length, 0);
  assert.equal(faults(series({ y: [1] })).length, 1);
  assert.equal(faults(series({ band_low: [0] })).length, 1);
});

test("an item of unknown kind, or without its coordinates, is refused", () => {
  const scene = (item) => ({ type: "scene", layers: [{ name: "l", items: [item] }] });
  assert.equal(faults(scene({ kind: "segment", a: [0, 0, 0], b: [0, 0, 1] })).length, 0);
  assert.equal(faults(scene({ kind: "segment", a: [0, 0, 0] })).length, 1);
  assert.equal(faults(scene({ kind: "torus" })).length, 1);
  const line = { kind: "line", positions: [[0, 0, 0]] };
  assert.equal(faults(scene({ ...line, color: "#12ab9F" })).length, 0);
  assert.equal(faults(scene({ ...line, color: "red" })).length, 1);
  const frame = [line.positions[0], line.positions[0], line.positions[0]];
  const ball = { kind: "surface", shape: "sphere", size: [1], center: [0, 0, 0], axes: frame };
  assert.equal(faults(scene(ball)).length, 0);
  assert.equal(faults(scene({ ...ball, shape: "cone" })).length, 1);
});

test("a colour scale needs its label and both ends", () => {
  const scene = (color_scale) => ({ type: "scene", layers: [], color_scale });
  assert.deepEqual(faults(scene({ label: "tension [N]", low: 0, high: 5 })), []);
  assert.equal(faults(scene({ label: "tension [N]", low: 0, high: null })).length, 1);
});

test("a chart without series is empty, not wrong", () => {
  assert.deepEqual(faults({ type: "lines", series: [] }), []);
  assert.equal(isEmpty({ type: "lines", series: [] }), true);
  assert.equal(isEmpty({ type: "text", text: "" }), false);
});

test("missing numbers are no fault", () => {
  const arrow = { group: "FDS", measured: [null, null], predicted: [1, 2] };
  const planes = [{ name: "p", panels: [{ title: "t", arrows: [arrow] }] }];
  assert.deepEqual(faults({ type: "vectors", planes }), []);
  assert.deepEqual(faults({ type: "interval", rows: [{ name: "r", estimate: null }] }), []);
});

test("faults inside a row are found, with their section", () => {
  const blocks = [{ type: "row", blocks: [{ type: "pie" }] }];
  const report = { title: "t", sections: [{ id: "s", title: "S", blocks }] };
  assert.match(reportFaults(report)[0], /^section "s": unknown block type "pie"/);
});

test("chains of unequal number or length are refused", () => {
  const quantity = (more) => ({
    name: "q",
    traces: [
      [1, 2],
      [3, 4],
    ],
    ranks: { counts: [[1], [1]], mean: 1, low: 0, high: 2 },
    autocorrelation: [[1], [1]],
    lag_step: 1,
    ...more,
  });
  const block = (q) => ({ type: "chains", chains: ["1", "2"], draws: [1, 2], quantities: [q] });
  assert.deepEqual(faults(block(quantity({}))), []);
  assert.equal(faults(block(quantity({ traces: [[1, 2]] }))).length, 1);
  assert.equal(faults(block(quantity({ traces: [[1], [2]] }))).length, 1);
  assert.equal(faults(block(quantity({ ranks: { counts: [[1], [1]] } }))).length, 1);
});

test("a corner plot wants equally many draws, and shows only what it has", () => {
  const corner = (a, b, shown) => ({
    type: "corner",
    shown,
    quantities: [
      { name: "a", draws: a },
      { name: "b", draws: b },
    ],
  });
  assert.deepEqual(faults(corner([1, 2, 3], [4, 5, 6], [1])), []);
  assert.equal(faults(corner([1, 2, 3], [4, 5])).length, 1);
  assert.equal(faults(corner([1, 2, 3], [4, 5, 6], [2])).length, 1);
});

test("a prediction has a value for each component", () => {
  const block = (values) => ({
    type: "predictive",
    components: ["x", "y"],
    groups: [{ name: "g", rows: [{ name: "r", values }] }],
  });
  assert.deepEqual(faults(block([{ measured: 1 }, { measured: null }])), []);
  assert.equal(faults(block([{ measured: 1 }])).length, 1);
});

test("a cloud of lines has two ends for each", () => {
  const scene = (positions) => ({
    type: "scene",
    layers: [{ name: "l", items: [{ kind: "lines", positions }] }],
  });
  const p = [0, 0, 0];
  assert.deepEqual(faults(scene([p, p, p, p])), []);
  assert.equal(faults(scene([p, p, p])).length, 1);
});

test("a banner says whether all is well", () => {
  assert.deepEqual(faults({ type: "banner", ok: true, title: "t" }), []);
  assert.deepEqual(faults({ type: "banner", ok: true, caution: true, title: "t" }), []);
  assert.equal(faults({ type: "banner", title: "t" }).length, 1);
});

test("a mesh that the report does not have is refused", () => {
  const scene = { type: "scene", layers: [{ name: "l", items: [{ kind: "mesh", mesh: "ball" }] }] };
  const report = (meshes) => ({ title: "t", meshes, sections: [{ id: "s", blocks: [scene] }] });
  const ball = { vertices: "", triangles: "", origin: [0, 0, 0], step: 1 };
  assert.equal(reportFaults(report({ ball })).length, 0);
  assert.equal(reportFaults(report({ cube: ball })).length, 1);
  assert.equal(reportFaults(report(undefined)).length, 1);
});

test("the times of still pictures are numbers", () => {
  const scene = (strip) => ({ type: "scene", layers: [{ name: "l", items: [] }], strip });
  assert.deepEqual(faults(scene([0, 0.5])), []);
  assert.match(faults(scene(["now"]))[0], /"strip" must be a list of times/);
});
