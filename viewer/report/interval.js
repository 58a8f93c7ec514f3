// A forest plot: estimates with their intervals, over what was believed before.

import { svg } from "./dom.js";
import { figure } from "./figure.js";
import { fluid } from "./fluid.js";
import { key } from "./legend.js";
import { formatNumber, isNumber } from "../numbers/format.js";
import { extent, linear, ticks } from "../numbers/ticks.js";
import { describe } from "./tooltip.js";
import { axisBelow, references, textWidth } from "./svg_axis.js";

const ROW = 24;
const TALL_ROW = 44; // with its words above the marks
const NARROW = 620; // where there is no room for words beside the marks
const LEAST = 200; // that the marks need otherwise
const TOP = 26;
const BOTTOM = 42; // [px]
const INK = "var(--blue)";

/// What stands at the right of a row: its own words, or estimate and interval.
export function rowText(row) {
  if (row.display) return row.display;
  if (!isNumber(row.estimate)) return "n/a";
  const interval =
    isNumber(row.low) && isNumber(row.high)
      ? ` [${formatNumber(row.low)}, ${formatNumber(row.high)}]`
      : "";
  const unit = row.unit && row.unit !== "1" ? ` ${row.unit}` : "";
  return `${formatNumber(row.estimate)}${interval}${unit}`;
}

/// A parameter that the data do not determine has no number at its side; the tooltip still tells
/// it.
const sideText = (row) => (row.null ? "not identifiable" : rowText(row));

const isBeyond = (value, most) => isNumber(value) && value > most;

/// Whether some of a row lies beyond the end of the axis.
export const goesOn = (row, most) =>
  [row.estimate, row.high, row.prior_high, row.truth].some((value) => isBeyond(value, most));

function marks(row, x, y, most) {
  const drawn = [];
  if (isNumber(row.prior_low) && isNumber(row.prior_high))
    drawn.push(
      svg("rect", {
        class: "prior",
        x: x(row.prior_low),
        width: Math.max(1, x(row.prior_high) - x(row.prior_low)),
        y: y - 7,
        height: 14,
        rx: 3,
      }),
    );
  if (isNumber(row.prior_inner_low) && isNumber(row.prior_inner_high))
    drawn.push(
      svg("rect", {
        class: "prior inner-prior",
        x: x(row.prior_inner_low),
        width: Math.max(1, x(row.prior_inner_high) - x(row.prior_inner_low)),
        y: y - 7,
        height: 14,
      }),
    );
  if (isNumber(row.low) && isNumber(row.high))
    drawn.push(svg("line", { class: "whisker", x1: x(row.low), x2: x(row.high), y1: y, y2: y }));
  if (isNumber(row.inner_low) && isNumber(row.inner_high))
    drawn.push(
      svg("line", { class: "inner", x1: x(row.inner_low), x2: x(row.inner_high), y1: y, y2: y }),
    );
  if (isNumber(row.estimate) && !isBeyond(row.estimate, most))
    drawn.push(
      svg("circle", {
        class: row.null ? "hollow" : "estimate",
        cx: x(row.estimate),
        cy: y,
        r: isNumber(row.inner_low) ? 3.5 : 5,
      }),
    );
  if (isNumber(row.truth))
    drawn.push(svg("path", { class: "truth", d: `M${x(row.truth)} ${y - 8}v16` }));
  if (goesOn(row, most))
    drawn.push(svg("path", { class: "estimate", d: `M${x(most) + 2} ${y - 5}l8 5l-8 5z` }));
  return drawn;
}

const words = (row) => [
  row.name,
  rowText(row),
  ...(isNumber(row.inner_low)
    ? [`inner ${formatNumber(row.inner_low)} to ${formatNumber(row.inner_high)}`]
    : []),
  ...(isNumber(row.inner_low) && isNumber(row.low)
    ? [`outer ${formatNumber(row.low)} to ${formatNumber(row.high)}`]
    : []),
  ...(row.null ? ["not identifiable"] : []),
  ...(isNumber(row.prior_low)
    ? [`prior ${formatNumber(row.prior_low)} to ${formatNumber(row.prior_high)}`]
    : []),
  ...(isNumber(row.truth) ? [`truth ${formatNumber(row.truth)}`] : []),
];

/// One row; in a narrow chart its words stand above the marks.
function line(row, top, { x, most, left, right, width, narrow, row: height }) {
  const y = narrow ? top + 24 : top + height / 2;
  const text = narrow ? top + 14 : y + 4;
  const name = narrow ? { x: 2 } : { x: left - 10, "text-anchor": "end" };
  const side = narrow ? { x: width - 2, "text-anchor": "end" } : { x: right + 12 };
  const group = svg(
    "g",
    { class: `interval-row ${row.null ? "null" : ""}`, style: `color: ${INK}`, role: "img" },
    svg("rect", { class: "catch", x: 0, y: top, width, height }),
    ...marks(row, x, y, most),
    svg("text", { class: "name", y: text, ...name }, row.name),
    svg("text", { class: row.null ? "note" : "", y: text, ...side }, sideText(row)),
  );
  return describe(group, words(row));
}

/// Where the columns of a chart of this width stand.
function layoutOf({ rows, reference_lines = [], x_most: most = Infinity }, width) {
  const values = rows
    .flatMap((r) => [r.estimate, r.low, r.high, r.prior_low, r.prior_high, r.truth])
    .filter(isNumber)
    .map((value) => Math.min(value, most));
  const range = extent([...values, ...reference_lines.map((r) => r.value)], 0.04);
  const names = 18 + Math.max(60, ...rows.map((r) => textWidth(r.name)));
  const words = Math.max(...rows.map((r) => textWidth(sideText(r))), 60);
  const narrow = width < NARROW || width - names - words < LEAST;
  const left = narrow ? 8 : names;
  const right = width - (narrow ? 8 : 24 + words);
  const along = linear(range, [left, right]);
  const x = (value) => along(Math.min(value, most));
  return { range, most, left, right, width, narrow, x, row: narrow ? TALL_ROW : ROW };
}

function chart(block, width) {
  const at = layoutOf(block, width);
  const bottom = TOP + block.rows.length * at.row;
  const middle = (at.left + at.right) / 2;
  const count = Math.min(6, Math.max(2, Math.floor((at.right - at.left) / 60)));
  return svg(
    "svg",
    {
      class: "plot",
      width,
      height: bottom + BOTTOM,
      viewBox: `0 0 ${width} ${bottom + BOTTOM}`,
      role: "group",
      "aria-label": block.caption ?? "Intervals",
    },
    ...axisBelow(at.x, ticks(...at.range, count), TOP - 4, bottom, block.x_label, middle),
    ...references(at.x, block.reference_lines ?? [], TOP - 4, bottom),
    ...block.rows.map((row, i) => line(row, TOP + i * at.row, at)),
  );
}

function keyOf({ rows, key: words }) {
  const two = rows.some((r) => isNumber(r.inner_low));
  const interval = words ?? (two ? "estimate, inner and outer interval" : "estimate and interval");
  const entries = [{ name: interval, color: INK, mark: "dot" }];
  if (rows.some((r) => isNumber(r.prior_low)))
    entries.push({ name: "prior", color: "var(--prior)", mark: "box" });
  if (rows.some((r) => isNumber(r.truth)))
    entries.push({ name: "truth", color: "var(--vermillion)", mark: "line" });
  if (rows.some((r) => r.null))
    entries.push({ name: "not identifiable", color: INK, mark: "ring" });
  return key(entries);
}

export const drawInterval = (block) =>
  figure(
    "figure",
    block.caption,
    keyOf(block),
    fluid({ class: "intervals" }, (width) => [chart(block, width)]),
  );
