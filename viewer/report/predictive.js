// Measured values over what the posterior predicts, by group; one column for each component.

import { el, svg } from "./dom.js";
import { figure } from "./figure.js";
import { fluid } from "./fluid.js";
import { key } from "./legend.js";
import { panelSvg } from "./panel.js";
import { formatNumber, isNumber } from "../numbers/format.js";
import { axisBelow, textWidth } from "./svg_axis.js";
import { extent, linear, ticks } from "../numbers/ticks.js";
import { describe } from "./tooltip.js";

const ROW = 17;
const HEAD = 24; // of a group
const TOP = 26;
const BOTTOM = 40;
const WIDE = 620; // where the columns stand side by side [px]

/// Whether a measured value lies beyond the outer interval; null if that cannot be told.
export const isOutside = ({ measured, low, high }) =>
  [measured, low, high].every(isNumber) ? measured < low || measured > high : null;

function rangeOf(block, c) {
  const values = block.groups.flatMap((g) =>
    g.rows.flatMap(({ values: v }) => [v[c].measured, v[c].low, v[c].high]),
  );
  return extent([0, ...values.filter(isNumber)], 0.04);
}

function marks(v, x, y) {
  const span = (kind, low, high) =>
    isNumber(low) && isNumber(high)
      ? svg("line", { class: kind, x1: x(low), x2: x(high), y1: y, y2: y })
      : null;
  const dot = isNumber(v.measured)
    ? svg("circle", {
        class: isOutside(v) ? "measured-dot out" : "measured-dot",
        cx: x(v.measured),
        cy: y,
        r: isOutside(v) ? 4.2 : 3.2,
      })
    : null;
  return [span("outer", v.low, v.high), span("inner", v.inner_low, v.inner_high), dot];
}

function words(block, group, row, c) {
  const v = row.values[c];
  const unit = block.unit ?? "";
  return [
    `${row.name}, ${group.name}, ${block.components[c]}`,
    `measured ${formatNumber(v.measured)} ${unit}${isOutside(v) ? ", outside 95 %" : ""}`,
    `predicted ${formatNumber(v.median)} ${unit}`,
    `50 %: ${formatNumber(v.inner_low)} to ${formatNumber(v.inner_high)}`,
    `95 %: ${formatNumber(v.low)} to ${formatNumber(v.high)}`,
  ];
}

function column(block, c, width, names) {
  const left = names ? names : 8;
  const right = width - 10;
  const range = rangeOf(block, c);
  const x = linear(range, [left, right]);
  let y = TOP;
  const body = block.groups.flatMap((group) => {
    y += HEAD;
    const head = svg(
      "text",
      { class: "title", x: names ? 0 : left, y: y - 7 },
      names ? group.name : "",
    );
    const rows = group.rows.map((row) => {
      const middle = y + ROW / 2;
      y += ROW;
      return describe(
        svg(
          "g",
          { class: "predictive-row", role: "img" },
          svg("rect", { class: "catch", x: 0, y: middle - ROW / 2, width, height: ROW }),
          names
            ? svg(
                "text",
                { class: "name", x: left - 8, y: middle + 4, "text-anchor": "end" },
                row.name,
              )
            : null,
          ...marks(row.values[c], x, middle),
        ),
        words(block, group, row, c),
      );
    });
    return [head, ...rows];
  });
  const box = { width, height: y + BOTTOM };
  const values = ticks(...range, Math.max(2, Math.floor((right - left) / 60)));
  const label = `${block.components[c]}${block.unit ? ` [${block.unit}]` : ""}`;
  return panelSvg(
    box,
    `Measured and predicted ${label}`,
    svg("text", { class: "title", x: (left + right) / 2, y: 16, "text-anchor": "middle" }, label),
    ...axisBelow(x, values, TOP, y, "", 0),
    ...body,
  );
}

/// Columns side by side, the names only at the first; or one below the other.
function columns(block, width) {
  const longest = Math.max(
    ...block.groups.flatMap((g) => [...g.rows.map((r) => textWidth(r.name)), 40]),
  );
  const names = Math.min(180, longest) + 16;
  const count = block.components.length;
  if (width < WIDE) return block.components.map((_, c) => column(block, c, width, names));
  const room = Math.floor((width - names) / count);
  return block.components.map((_, c) => column(block, c, c ? room : room + names, c ? 0 : names));
}

const KEY = [
  { name: "measured", color: "var(--ink)", mark: "dot" },
  { name: "measured, outside 95 %", color: "var(--vermillion)", mark: "dot" },
  { name: "predicted 50 %", color: "var(--blue)", mark: "thick" },
  { name: "predicted 95 %", color: "var(--blue)", mark: "thin" },
];

export const drawPredictive = (block) =>
  figure(
    "figure",
    block.caption,
    key(KEY),
    fluid({ class: "predictive" }, (width) => columns(block, width)),
  );
