// Says what is wrong with a report before it is drawn. Knows nothing of the browser.

import { SHAPES } from "../picture/shapes.js";
import { withMeshes } from "./meshes.js";

const isArray = Array.isArray;
const isVector = (n) => (v) => isArray(v) && v.length === n;
const isNumber = Number.isFinite;
const isText = (v) => typeof v === "string";
const list = (inner) => (v) => isArray(v) && v.every(inner);
const shape = (keys) => (v) =>
  v !== null && typeof v === "object" && Object.entries(keys).every(([k, ok]) => ok(v[k]));

/// Of a mesh in its place; its name alone if the report has none of that name.
const isMesh = shape({ vertices: isText, triangles: isText, origin: isVector(3), step: isNumber });

const ITEMS = {
  segment: { a: isVector(3), b: isVector(3) },
  axis: { point: isVector(3), direction: isVector(3) },
  arrow: { from: isVector(3), vector: isVector(3) },
  hull: { vertices: list(isVector(3)), faces: list(isVector(3)) },
  points: { positions: list(isVector(3)) },
  line: { positions: list(isVector(3)) },
  lines: { positions: (v) => list(isVector(3))(v) && v.length % 2 === 0 },
  surface: {
    shape: (v) => SHAPES.includes(v),
    size: isArray,
    center: isVector(3),
    axes: (v) => isVector(3)(v) && v.every(isVector(3)),
  },
  mesh: { mesh: isMesh },
  cone: { tip: isVector(3), axis: isVector(3), radius: isNumber },
};
const isColor = (v) => v === undefined || /^#[0-9a-f]{6}$/i.test(v);
const isItem = (v) => v && v.kind in ITEMS && shape(ITEMS[v.kind])(v) && isColor(v.color);

const sameLength = (s) =>
  s.x.length === s.y.length &&
  [s.band_low, s.band_high, s.labels, s.hints].every(
    (extra) => !extra || extra.length === s.x.length,
  );
const isSeries = (s) => shape({ name: isText, x: isArray, y: isArray })(s) && sameLength(s);

const isArrow = shape({ group: isText, measured: isVector(2), predicted: isVector(2) });
const isPlane = shape({
  name: isText,
  panels: list(shape({ title: isText, arrows: list(isArrow) })),
});

const sameLists = (lists, wanted) => isArray(lists) && lists.every((v) => v?.length === wanted);

/// Every chain of every quantity has a trace as long as "draws", counts and autocorrelations.
const chainsAgree = (quantities, { chains, draws }) =>
  quantities.every(
    (q) =>
      [q.traces, q.ranks.counts, q.autocorrelation].every((v) => v?.length === chains?.length) &&
      sameLists(q.traces, draws?.length),
  );
const isRanks = shape({ counts: list(isArray), mean: isNumber, low: isNumber, high: isNumber });
const isChain = shape({ name: isText, traces: isArray, ranks: isRanks, autocorrelation: isArray });

const isDraws = (q) => shape({ name: isText, draws: isArray })(q) && q.draws.length > 2;
const drawsAgree = (quantities) =>
  sameLists(
    quantities.map((q) => q.draws),
    quantities[0]?.draws.length ?? 0,
  );
const namesShown = (v, { quantities }) =>
  v === undefined || (isArray(v) && v.every((i) => i in (quantities ?? [])));

const isPredicted = (row) => shape({ name: isText, values: list(shape({})) })(row);
const fits = (groups, { components }) =>
  groups.every((g) => g.rows.every((row) => row.values.length === components?.length));

// What each type of block must carry, and in words for the message.
const NEEDS = {
  table: {
    columns: [list(shape({ name: isText })), "a list of {name}"],
    rows: [list(isArray), "a list of lists"],
  },
  lines: { series: [list(isSeries), "a list of {name, x, y}, all of one length"] },
  vectors: {
    planes: [
      list(isPlane),
      "a list of {name, panels: [{title, arrows: [{group, measured: [2], predicted: [2]}]}]}",
    ],
  },
  scene: {
    layers: [
      list(shape({ name: isText, items: list(isItem) })),
      `a list of {name, items}, items of kind ${Object.keys(ITEMS).join(", ")} with coordinates`,
    ],
    color_scale: [
      (v) => v === undefined || (isText(v?.label) && [v.low, v.high].every(Number.isFinite)),
      "{label, low, high}",
    ],
    strip: [(v) => v === undefined || list(Number.isFinite)(v), "a list of times"],
  },
  bars: {
    groups: [
      list(shape({ name: isText, values: list(shape({ series: isText })) })),
      "a list of {name, values: [{series, value}]}",
    ],
  },
  interval: { rows: [list(shape({ name: isText })), "a list of {name, estimate, low, high}"] },
  banner: {
    ok: [(v) => typeof v === "boolean", "true or false"],
    caution: [(v) => v === undefined || typeof v === "boolean", "true or false"],
    title: [isText, "a string"],
    reasons: [(v) => v === undefined || list(isText)(v), "a list of strings"],
  },
  chains: {
    chains: [list(isText), "a list of names"],
    draws: [isArray, "a list of numbers"],
    quantities: [
      (v, block) => list(isChain)(v) && chainsAgree(v, block),
      "a list of {name, traces, ranks: {counts, mean, low, high}, autocorrelation}, a list in each for each chain",
    ],
  },
  corner: {
    quantities: [
      (v) => list(isDraws)(v) && drawsAgree(v),
      "a list of {name, draws}, equally many draws, at least 3",
    ],
    shown: [namesShown, "a list of indices of quantities"],
  },
  predictive: {
    components: [list(isText), "a list of names"],
    groups: [
      (v, block) => list(shape({ name: isText, rows: list(isPredicted) }))(v) && fits(v, block),
      "a list of {name, rows: [{name, values}]}, a value for each component",
    ],
  },
  text: { text: [isText, "a string"] },
  row: { blocks: [isArray, "a list of blocks"] },
};

// What is empty if the list of this name is.
const CONTENT = {
  lines: "series",
  vectors: "planes",
  scene: "layers",
  bars: "groups",
  interval: "rows",
  chains: "quantities",
  corner: "quantities",
  predictive: "groups",
};

/// Whether a faultless block has nothing to draw.
export const isEmpty = (block) => block[CONTENT[block.type]]?.length === 0;

export const BLOCK_TYPES = Object.keys(NEEDS);

function raggedRow(block) {
  const index = block.rows.findIndex((row) => row.length !== block.columns.length);
  return index < 0
    ? []
    : [`table: row ${index} has ${block.rows[index].length} cells, wanted ${block.columns.length}`];
}

/// What is wrong with one block, in words; empty if nothing is. Blocks inside a row answer for
/// themselves.
export function faults(block) {
  if (!block || !(block.type in NEEDS))
    return [`unknown block type "${block?.type}"; known are ${BLOCK_TYPES.join(", ")}`];
  const found = Object.entries(NEEDS[block.type])
    .filter(([key, [ok]]) => !ok(block[key], block))
    .map(([key, [, wanted]]) => `${block.type}: "${key}" must be ${wanted}`);
  return block.type === "table" && !found.length ? raggedRow(block) : found;
}

const isOpening = (v) =>
  v === undefined ||
  (v !== null &&
    typeof v === "object" &&
    ["asked", "done", "learnt"].every((key) => isText(v[key])));
const optional = (test) => (v) => v === undefined || test(v);

// What stands around the sections, if anything does.
const AROUND = {
  opening: [isOpening, "{asked, done, learnt}"],
  summary: [optional(list(shape({ text: isText }))), "a list of {text}"],
  pages: [optional(list(shape({ file: isText, title: isText }))), "a list of {file, title}"],
};

/// The same for a whole report, rows opened; each fault starts with its section.
export function reportFaults(report) {
  if (!isText(report?.title)) return ['report: "title" must be a string'];
  if (!isArray(report.sections)) return ['report: "sections" must be a list'];
  const around = Object.entries(AROUND)
    .filter(([key, [ok]]) => !ok(report[key]))
    .map(([key, [, wanted]]) => `report: "${key}" must be ${wanted}`);
  const deep = (block) =>
    block?.type === "row" && isArray(block.blocks) ? block.blocks.flatMap(deep) : faults(block);
  const inside = withMeshes(report).sections.flatMap((section) =>
    (section.blocks ?? []).flatMap(deep).map((fault) => `section "${section.id}": ${fault}`),
  );
  return [...around, ...inside];
}
