// Curves and scatter charts, by uPlot.

import uPlot from "uplot";
import { el } from "./dom.js";
import { figure, remark } from "./figure.js";
import { legend } from "./legend.js";
import { lineData } from "./line_data.js";
import { followPointer } from "./line_hover.js";
import { chartOptions } from "./line_options.js";
import { lineSvg } from "./line_svg.js";
import { seriesLooks } from "./palette.js";
import { onThemeChange } from "./theme.js";
import { whenShown } from "./when_shown.js";

function entries(block) {
  const looks = seriesLooks(block.series);
  const all = block.series.map(({ name, style, band_low, faint }, s) => ({
    name,
    ...looks[s],
    mark: style === "points" ? "dot" : faint && band_low ? "box" : "line",
  }));
  // Series of one name are switched together.
  return all.filter(({ name }, s) => all.findIndex((other) => other.name === name) === s);
}

/// uPlot needs a width, which the frame has only once it is in the page and not folded away.
function mount(frame, block, model, shown) {
  const options = chartOptions(block, model, shown, frame.clientWidth);
  const plot = new uPlot(options, model.data, frame);
  block.series.forEach((_, s) => shown[s] || showSeries(plot, model, s, false));
  followPointer(frame, plot, block, model.points, shown);
  new ResizeObserver(() => {
    const width = frame.clientWidth;
    if (width && width !== plot.width) plot.setSize({ width, height: plot.height });
  }).observe(frame);
  onThemeChange(() => plot.redraw(false, true));
  frame.toSvg = () => lineSvg(plot, block, model.points, shown);
  return plot;
}

const showSeries = (plot, model, s, show) =>
  model.plan.forEach((column, i) => column.series === s && plot.setSeries(i + 1, { show }));

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
    tabindex: 0,
    "aria-label": `${block.caption ?? "Chart"}: ${block.y_label} over ${block.x_label}; arrow keys tell values`,
  });
  let plot = null;
  whenShown(frame, () => {
    plot = mount(frame, block, model, shown);
  });
  const toggle = (name, on) =>
    block.series.forEach((series, s) => {
      if (series.name !== name) return;
      shown[s] = on;
      if (plot) showSeries(plot, model, s, on);
    });
  return figure(
    "figure",
    block.caption,
    legend(entries(block), toggle),
    frame,
    remark(lostWords(block, model.lost)),
  );
}
