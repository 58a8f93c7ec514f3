// Tells values of a chart under the pointer, or under the arrow keys.

import { el } from "./dom.js";
import { curveXs, nearestOf, nearestPoint, pointsAt } from "./line_reading.js";
import { formatNumber, sizeOf } from "../numbers/format.js";
import { seriesLooks } from "./palette.js";
import { hideTooltip, readingRow, showTooltip } from "./tooltip.js";

const REACH = 28; // of the pointer, to the point it tells about [px]
const MOST = 14; // lines of one tooltip

const nameOf = (block, p) => {
  const { name } = block.series[p.s];
  return (p.label ?? p.hint) ? `${name}: ${p.label ?? p.hint}` : name;
};

/// Writes y values: what rounding leaves of zero is zero, except on a logarithmic axis.
function writer(block, points) {
  const size = block.log_y ? 0 : sizeOf(points.flat().map(({ y }) => y));
  return (p) => {
    const value = (y) => formatNumber(y, undefined, size);
    const band = p.low !== null && p.high !== null;
    return band ? `${value(p.y)} (${value(p.low)} to ${value(p.high)})` : value(p.y);
  };
}

/// One point alone, as in a scatter chart.
const pointWords = (block, p, write) => [
  nameOf(block, p),
  `${block.x_label ?? "x"}: ${formatNumber(p.x)}`,
  `${block.y_label ?? "y"}: ${write(p)}`,
];

/// Every curve at one x; that of the point `near` stands out.
function rowsAt(block, found, near, looks, write) {
  const kept = found.slice(0, MOST);
  const rows = kept.map((p) => readingRow(looks[p.s], nameOf(block, p), write(p), near?.s === p.s));
  const more = found.length - kept.length;
  return [
    `${block.x_label ?? "x"}: ${formatNumber(found[0].x)}`,
    ...rows,
    ...(more ? [`and ${more} more`] : []),
  ];
}

/// What stands at (left, top) of the plot's inside: { words, at: the point to ring, or null }.
function reading(plot, block, points, shown, looks, write, left, top) {
  const distance = (p) => Math.hypot(plot.valToPos(p.x, "x") - left, plot.valToPos(p.y, "y") - top);
  const near = nearestPoint(points, shown, distance, REACH);
  const xs = curveXs(block, points, shown);
  if (!xs.length) return near && { words: pointWords(block, near, write), at: near };
  const x = near ? near.x : nearestOf(xs, plot.posToVal(left, "x"));
  const found = pointsAt(points, shown, x);
  return { words: rowsAt(block, found, near, looks, write), at: near ?? found[0] };
}

/// Tells values at the pointer, and rings the point they belong to. With the focus on the chart,
/// left and right go from value to value, escape ends it.
export function followPointer(frame, plot, block, points, shown) {
  const ring = plot.over.appendChild(el("span", { class: "ring", hidden: true }));
  const looks = seriesLooks(block.series);
  const write = writer(block, points);
  const leave = () => {
    ring.hidden = true;
    hideTooltip();
  };
  const tell = (event, left, top) => {
    const told = reading(plot, block, points, shown, looks, write, left, top);
    if (!told) return leave();
    ring.hidden = false;
    ring.style.left = `${plot.valToPos(told.at.x, "x")}px`;
    ring.style.top = `${plot.valToPos(told.at.y, "y")}px`;
    showTooltip(event, told.words);
  };
  plot.over.addEventListener("pointerleave", leave);
  plot.over.addEventListener("pointermove", (event) => {
    const box = plot.over.getBoundingClientRect();
    tell(event, event.clientX - box.left, event.clientY - box.top);
  });
  let place = -1;
  frame.addEventListener("blur", leave);
  frame.addEventListener("keydown", (event) => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (event.key === "Escape") leave();
    if (!by) return;
    event.preventDefault();
    const all = points.flatMap((list, s) => (shown[s] ? list.filter((p) => p.y !== null) : []));
    const xs = [...new Set(all.map(({ x }) => x))].sort((a, b) => a - b);
    if (!xs.length) return;
    place = Math.min(xs.length - 1, Math.max(0, place + by));
    const [p] = pointsAt(points, shown, xs[place]);
    const [left, top] = [plot.valToPos(p.x, "x"), plot.valToPos(p.y, "y")];
    const box = plot.over.getBoundingClientRect();
    tell({ clientX: box.left + left, clientY: box.top + top }, left, top);
  });
}
