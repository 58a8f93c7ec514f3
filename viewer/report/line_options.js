// How a chart of a report is put to uPlot: axes, ranges, series and bands.

import { drawMarks, marksOf } from "./line_marks.js";
import { formatNumber, isNumber, tickLabels } from "../numbers/format.js";
import { extent } from "../numbers/ticks.js";
import { seriesLooks } from "./palette.js";
import { themeColor } from "./theme.js";

const HEIGHT = 320; // [px]
const FONT = "12px system-ui, sans-serif";
const FLAT = 1e-4; // relative: a curve that varies less is drawn as the constant it is

function seriesOptions(block, { series: s, part }, color, dash) {
  const style = block.series[s].style ?? "lines";
  if (part !== "y") return { stroke: "transparent", width: 0, points: { show: false } };
  return {
    label: block.series[s].name,
    stroke: () => color(s) + (block.series[s].faint ? "a0" : ""),
    width: style === "points" ? 0 : block.series[s].faint ? 1 : 2,
    dash,
    paths: style === "points" ? () => null : undefined,
    points: {
      show: style === "points" || style === "both",
      size: 8,
      fill: () => color(s),
      stroke: () => color(s),
    },
  };
}

const bands = (plan, color) =>
  plan.flatMap(({ series, part }, i) =>
    part === "high" ? [{ series: [i + 1, i], fill: () => `${color(series)}33` }] : [],
  );

const axis = (label, log) => ({
  label,
  labelSize: 26,
  labelFont: FONT,
  font: FONT,
  stroke: () => themeColor("--ink"),
  grid: { stroke: () => themeColor("--faint"), width: 1 },
  ticks: { stroke: () => themeColor("--faint") },
  ...(log ? { splits: decades, filter: (_, splits) => splits } : {}),
  values: (_, splits) => (log ? splits.map((v) => formatNumber(v)) : tickLabels(splits)),
});

/// Ticks of a logarithmic axis: 1, 2, 5 within two decades, else every decade, or every few.
function decades(plot, axisIndex, low, high) {
  const first = Math.floor(Math.log10(low));
  const last = Math.ceil(Math.log10(high));
  const every = Math.ceil((last - first) / 9);
  const factors = last - first <= 2 ? [1, 2, 5] : [1];
  const values = [];
  for (let power = Math.ceil(first / every) * every; power <= last; power += every)
    values.push(...factors.map((f) => Number(`${f}e${power}`)));
  return values.filter((v) => v >= low && v <= high);
}

/// The data and the reference lines with some air, instead of uPlot's whole decades.
function range(log, references) {
  return (_, low, high) => {
    const all = [low, high, ...references].filter((v) => isNumber(v) && (!log || v > 0));
    const ends = extent(log ? all.map(Math.log10) : all, 0.06, FLAT);
    return log ? ends.map((v) => 10 ** v) : ends;
  };
}

/// uPlot's options; `shown` tells for each series whether the reader has it switched on.
export function chartOptions(block, model, shown, width) {
  const looks = seriesLooks(block.series);
  const color = (s) => themeColor(looks[s].color);
  const references = (name) =>
    (block.reference_lines ?? []).filter((r) => (r.axis ?? "y") === name).map((r) => r.value);
  return {
    width,
    height: block.height ?? HEIGHT,
    legend: { show: false },
    padding: [12, 16, 0, 0],
    cursor: { drag: { x: true, y: true, uni: 20 }, points: { show: false } },
    scales: {
      x: { time: false, distr: block.log_x ? 3 : 1, range: range(block.log_x, references("x")) },
      y: { distr: block.log_y ? 3 : 1, range: range(block.log_y, references("y")) },
    },
    axes: [
      { ...axis(block.x_label, block.log_x), size: 34 },
      { ...axis(block.y_label, block.log_y), size: 64 },
    ],
    series: [
      {},
      ...model.plan.map((column) => seriesOptions(block, column, color, looks[column.series].dash)),
    ],
    bands: bands(model.plan, color),
    hooks: {
      draw: [(plot) => drawMarks(plot, marksOf(plot, block, model.points, shown))],
    },
  };
}
