// Horizontal bars in groups, as SVG.

import { svg } from "./dom.js";
import { figure } from "./figure.js";
import { fluid } from "./fluid.js";
import { legend } from "./legend.js";
import { formatNumber, isNumber, MISSING, sizeOf } from "../numbers/format.js";
import { cssColor, indexByName } from "./palette.js";
import { extent, linear, ticks } from "../numbers/ticks.js";
import { describe } from "./tooltip.js";
import { axisBelow, references, textWidth } from "./svg_axis.js";

const BAR = 15;
const GAP = 12;
const HEAD = 18; // of a group whose name stands above its bars
const NARROW = 520; // where names have no room beside the bars
const VALUE = 56; // that numbers need at the right
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

/// Where the columns of a chart of this width stand.
function layoutOf(block, width) {
  const names = 14 + Math.max(60, ...block.groups.map((g) => textWidth(g.name)));
  const narrow = width < NARROW || width - names < NARROW / 2;
  const left = narrow ? 12 : names;
  const range = rangeOf(block);
  const x = linear(range, [left, width - VALUE]);
  const count = Math.min(6, Math.max(2, Math.floor((width - VALUE - left) / 70)));
  return { x, range, left, narrow, width, count };
}

/// Bars of one group below each other, its name at their left; in a narrow chart above them.
function group(g, top, { x, left, narrow }, color, size) {
  const middle = top + (g.values.length * BAR) / 2 + 4;
  const name = narrow
    ? { x: left, y: top + HEAD - 5 }
    : { x: left - 8, y: middle, "text-anchor": "end" };
  const first = top + (narrow ? HEAD : 0);
  return [
    svg("text", { class: "name", ...name }, g.name),
    ...g.values.map((v, i) => bar(v, g.name, x, first + i * BAR, color(v.series), size)),
  ];
}

/// @param hidden  names of series that are not shown
function chart(block, index, hidden, width) {
  const at = layoutOf(block, width);
  const { x, range, left, count } = at;
  const size = sizeOf(block.groups.flatMap((g) => g.values.map((v) => v.value)));
  let top = TOP;
  const rows = block.groups.flatMap((g) => {
    const drawn = group(g, top, at, (name) => cssColor(index.get(name)), size);
    top += (at.narrow ? HEAD : 0) + g.values.length * BAR + GAP;
    return drawn;
  });
  rows
    .filter((node) => hidden.has(node.dataset.group))
    .forEach((node) => (node.style.display = "none"));
  return svg(
    "svg",
    {
      class: "plot",
      width,
      height: top + BOTTOM,
      viewBox: `0 0 ${width} ${top + BOTTOM}`,
      role: "group",
      "aria-label": block.caption ?? "Bars",
    },
    ...axisBelow(x, ticks(...range, count), TOP - 4, top, block.x_label, (left + width - VALUE) / 2),
    ...rows,
    ...references(x, block.reference_lines ?? [], TOP - 4, top),
  );
}

export function drawBars(block) {
  const names = block.groups.flatMap((g) => g.values.map((v) => v.series));
  const index = indexByName(names);
  const hidden = new Set();
  const frame = fluid({ class: "chart" }, (width) => [chart(block, index, hidden, width)]);
  const toggle = (name, shown) => {
    if (shown) hidden.delete(name);
    else hidden.add(name);
    frame.redraw();
  };
  const entries = [...index].map(([name, i]) => ({ name, color: cssColor(i) }));
  return figure(
    "figure",
    block.caption,
    entries.length > 1 ? legend(entries, toggle) : null,
    frame,
  );
}
