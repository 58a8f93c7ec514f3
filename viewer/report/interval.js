// A forest plot: estimates with their intervals, over what was believed before.

import { el, svg } from "./dom.js";
import { figure } from "./figure.js";
import { key } from "./legend.js";
import { formatNumber, isNumber } from "../numbers/format.js";
import { extent, linear, ticks } from "../numbers/ticks.js";
import { describe } from "./tooltip.js";
import { axisBelow, references, textWidth } from "./svg_axis.js";

const ROW = 24;
const WIDTH = 900;
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

function marks(row, x, y) {
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
  if (isNumber(row.low) && isNumber(row.high))
    drawn.push(svg("line", { class: "whisker", x1: x(row.low), x2: x(row.high), y1: y, y2: y }));
  if (isNumber(row.estimate))
    drawn.push(
      svg("circle", { class: row.null ? "hollow" : "estimate", cx: x(row.estimate), cy: y, r: 5 }),
    );
  if (isNumber(row.truth))
    drawn.push(svg("path", { class: "truth", d: `M${x(row.truth)} ${y - 8}v16` }));
  return drawn;
}

const words = (row) => [
  row.name,
  rowText(row),
  ...(row.null ? ["not identifiable"] : []),
  ...(isNumber(row.prior_low)
    ? [`prior ${formatNumber(row.prior_low)} to ${formatNumber(row.prior_high)}`]
    : []),
  ...(isNumber(row.truth) ? [`truth ${formatNumber(row.truth)}`] : []),
];

function line(row, y, x, left, right) {
  const group = svg(
    "g",
    { class: `interval-row ${row.null ? "null" : ""}`, style: `color: ${INK}`, role: "img" },
    svg("rect", { class: "catch", x: 0, y: y - ROW / 2, width: WIDTH, height: ROW }),
    svg("text", { class: "name", x: left - 10, y: y + 4, "text-anchor": "end" }, row.name),
    ...marks(row, x, y),
    svg("text", { class: row.null ? "note" : "", x: right + 12, y: y + 4 }, sideText(row)),
  );
  return describe(group, words(row));
}

function chart(block) {
  const { rows } = block;
  const values = rows
    .flatMap((r) => [r.estimate, r.low, r.high, r.prior_low, r.prior_high, r.truth])
    .filter(isNumber);
  const range = extent([...values, ...(block.reference_lines ?? []).map((r) => r.value)], 0.04);
  const left = 18 + Math.max(60, ...rows.map((r) => textWidth(r.name)));
  const right = WIDTH - 24 - Math.max(...rows.map((r) => textWidth(sideText(r))), 60);
  const x = linear(range, [left, right]);
  const bottom = TOP + rows.length * ROW;
  return svg(
    "svg",
    {
      class: "plot",
      viewBox: `0 0 ${WIDTH} ${bottom + BOTTOM}`,
      role: "group",
      "aria-label": block.caption ?? "Intervals",
    },
    ...axisBelow(x, ticks(...range, 6), TOP - 4, bottom, block.x_label, (left + right) / 2),
    ...references(x, block.reference_lines ?? [], TOP - 4, bottom),
    ...rows.map((row, i) => line(row, TOP + (i + 0.5) * ROW, x, left, right)),
  );
}

function keyOf({ rows }) {
  const entries = [{ name: "estimate and interval", color: INK, mark: "dot" }];
  if (rows.some((r) => isNumber(r.prior_low)))
    entries.push({ name: "prior", color: "var(--prior)", mark: "box" });
  if (rows.some((r) => isNumber(r.truth)))
    entries.push({ name: "truth", color: "var(--vermillion)", mark: "line" });
  if (rows.some((r) => r.null))
    entries.push({ name: "not identifiable", color: INK, mark: "ring" });
  return key(entries);
}

export const drawInterval = (block) =>
  figure("figure", block.caption, keyOf(block), el("div", { class: "chart" }, chart(block)));
