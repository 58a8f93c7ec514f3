// Horizontal bars in groups, as SVG.

import { el, svg } from "./dom.js";
import { figure } from "./figure.js";
import { legend } from "./legend.js";
import { formatNumber, isNumber, MISSING, sizeOf } from "../numbers/format.js";
import { cssColor, indexByName } from "./palette.js";
import { extent, linear, ticks } from "../numbers/ticks.js";
import { describe } from "./tooltip.js";
import { axisBelow, references, textWidth } from "./svg_axis.js";

const BAR = 15;
const GAP = 12;
const WIDTH = 900;
const TOP = 26;
const BOTTOM = 42; // [px]

function rangeOf(block) {
  const values = block.groups.flatMap((g) => g.values.flatMap((v) => [v.value, v.low, v.high]));
  const [low, high] = extent(
    [0, ...values.filter(isNumber), ...(block.reference_lines ?? []).map((r) => r.value)],
    0.06,
  );
  return [values.some((v) => v < 0) ? low : 0, high];
}

function bar(v, name, x, y, color, size) {
  const told = (value) => formatNumber(value, undefined, size);
  const known = isNumber(v.value);
  const end = known ? x(v.value) : x(0);
  const right = Math.max(x(0), end, isNumber(v.high) ? x(v.high) : 0);
  const whisker =
    isNumber(v.low) && isNumber(v.high)
      ? [
          svg("line", {
            class: "whisker",
            x1: x(v.low),
            x2: x(v.high),
            y1: y + BAR / 2,
            y2: y + BAR / 2,
          }),
        ]
      : [];
  const group = svg(
    "g",
    { class: "bar", "data-group": v.series, style: `color: ${color}`, role: "img" },
    svg("rect", { x: Math.min(x(0), end), y: y + 1, width: Math.abs(end - x(0)), height: BAR - 2 }),
    ...whisker,
    svg("text", { x: right + 5, y: y + BAR - 4 }, known ? told(v.value) : MISSING),
  );
  const interval = whisker.length ? [`interval ${told(v.low)} to ${told(v.high)}`] : [];
  return describe(group, [`${name}, ${v.series}`, told(v.value), ...interval]);
}

/// Bars of one group below each other, its name at their left.
function group(g, top, x, left, color, size) {
  const middle = top + (g.values.length * BAR) / 2 + 4;
  return [
    svg("text", { class: "name", x: left - 8, y: middle, "text-anchor": "end" }, g.name),
    ...g.values.map((v, i) => bar(v, g.name, x, top + i * BAR, color(v.series), size)),
  ];
}

function chart(block, index) {
  const left = 14 + Math.max(60, ...block.groups.map((g) => textWidth(g.name)));
  const range = rangeOf(block);
  const x = linear(range, [left, WIDTH - 56]);
  const size = sizeOf(block.groups.flatMap((g) => g.values.map((v) => v.value)));
  let top = TOP;
  const rows = block.groups.flatMap((g) => {
    const drawn = group(g, top, x, left, (name) => cssColor(index.get(name)), size);
    top += g.values.length * BAR + GAP;
    return drawn;
  });
  return svg(
    "svg",
    {
      class: "plot",
      viewBox: `0 0 ${WIDTH} ${top + BOTTOM}`,
      role: "group",
      "aria-label": block.caption ?? "Bars",
    },
    ...axisBelow(x, ticks(...range, 6), TOP - 4, top, block.x_label, (left + WIDTH - 56) / 2),
    ...rows,
    ...references(x, block.reference_lines ?? [], TOP - 4, top),
  );
}

export function drawBars(block) {
  const names = block.groups.flatMap((g) => g.values.map((v) => v.series));
  const index = indexByName(names);
  const frame = el("div", { class: "chart" }, chart(block, index));
  const toggle = (name, shown) =>
    frame.querySelectorAll(".bar").forEach((node) => {
      if (node.dataset.group === name) node.style.display = shown ? "" : "none";
    });
  const entries = [...index].map(([name, i]) => ({ name, color: cssColor(i) }));
  return figure(
    "figure",
    block.caption,
    entries.length > 1 ? legend(entries, toggle) : null,
    frame,
  );
}
