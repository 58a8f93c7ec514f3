// Curves and scatter charts, by uPlot.

import uPlot from "uplot";
import { el } from "./dom.js";
import { figure, remark } from "./figure.js";
import { legend } from "./legend.js";
import { lineData } from "./line_data.js";
import { chartOptions } from "./line_options.js";
import { formatNumber } from "../numbers/format.js";
import { seriesColors } from "./palette.js";
import { onThemeChange } from "./theme.js";
import { hideTooltip, showTooltip } from "./tooltip.js";

const REACH = 28; // of the pointer, to the point it tells about [px]

function nearest(plot, points, shown) {
  let best = null;
  const { left, top } = plot.cursor;
  points.forEach(
    (list, s) =>
      shown[s] &&
      list.forEach((p) => {
        if (p.y === null) return;
        const d = Math.hypot(plot.valToPos(p.x, "x") - left, plot.valToPos(p.y, "y") - top);
        if (!best || d < best.d) best = { ...p, s, d };
      }),
  );
  return best && best.d < REACH ? best : null;
}

function wordsOf(block, p) {
  const { name } = block.series[p.s];
  const band = p.low !== null && p.high !== null;
  return [
    (p.label ?? p.hint) ? `${name}: ${p.label ?? p.hint}` : name,
    `${block.x_label ?? "x"}: ${formatNumber(p.x)}`,
    `${block.y_label ?? "y"}: ${formatNumber(p.y)}`,
    ...(band ? [`band ${formatNumber(p.low)} to ${formatNumber(p.high)}`] : []),
  ];
}

/// Tells about the point nearest to the pointer, and rings it.
function followPointer(plot, block, points, shown) {
  const ring = plot.over.appendChild(el("span", { class: "ring", hidden: true }));
  const leave = () => {
    ring.hidden = true;
    hideTooltip();
  };
  plot.over.addEventListener("pointerleave", leave);
  plot.over.addEventListener("pointermove", (event) => {
    const p = nearest(plot, points, shown);
    if (!p) return leave();
    ring.hidden = false;
    ring.style.left = `${plot.valToPos(p.x, "x")}px`;
    ring.style.top = `${plot.valToPos(p.y, "y")}px`;
    showTooltip(event, wordsOf(block, p));
  });
}

function entries(block) {
  const colors = seriesColors(block.series);
  const all = block.series.map(({ name, style, band_low, faint }, s) => ({
    name,
    color: colors[s],
    mark: style === "points" ? "dot" : faint && band_low ? "box" : "line",
  }));
  // Series of one name are switched together.
  return all.filter(({ name }, s) => all.findIndex((other) => other.name === name) === s);
}

/// uPlot needs a width, which the frame has only once it is in the page.
function mount(frame, block, model, shown) {
  const plot = new uPlot(
    chartOptions(block, model, shown, frame.clientWidth || 640),
    model.data,
    frame,
  );
  followPointer(plot, block, model.points, shown);
  new ResizeObserver(() => plot.setSize({ width: frame.clientWidth, height: plot.height })).observe(
    frame,
  );
  onThemeChange(() => plot.redraw(false, true));
  return plot;
}

function lostWords(block, lost) {
  const or = block.log_x || block.log_y ? " or not positive on a logarithmic axis" : "";
  return lost ? `Not shown (n/a): ${lost} of the points, without a value${or}.` : "";
}

export function drawLines(block) {
  const model = lineData(block);
  const shown = block.series.map(() => true);
  const frame = el("div", {
    class: "chart",
    role: "img",
    "aria-label": `${block.caption ?? "Chart"}: ${block.y_label} over ${block.x_label}`,
  });
  let plot = null;
  requestAnimationFrame(() => {
    plot = mount(frame, block, model, shown);
  });
  const toggle = (name, on) =>
    block.series.forEach((series, s) => {
      if (series.name !== name) return;
      shown[s] = on;
      model.plan.forEach((column, i) => column.series === s && plot.setSeries(i + 1, { show: on }));
    });
  return figure(
    "figure",
    block.caption,
    legend(entries(block), toggle),
    frame,
    remark(lostWords(block, model.lost)),
  );
}
