// Chart whose data change while it is shown.

import uPlot from "uplot";
import { el } from "../../report/dom.js";
import { figure } from "../../report/figure.js";
import { legend } from "../../report/legend.js";
import { lineData } from "../../report/line_data.js";
import { followPointer } from "../../report/line_hover.js";
import { chartOptions } from "../../report/line_options.js";
import { lineSvg } from "../../report/line_svg.js";
import { seriesLooks } from "../../report/palette.js";
import { withSaving } from "../../report/save.js";
import { whenShown } from "../../report/when_shown.js";

const LONG = 1 / 60; // of the span of x: where samples are farther apart they are marked

/// Which samples have a neighbour so far off that the line between them says little: their indices.
export function sparse(xs, values) {
  const here = xs.map((_, i) => i).filter((i) => Number.isFinite(values[i]));
  const least = LONG * (xs.at(-1) - xs[0]);
  const far = (a, b) => a === undefined || b === undefined || xs[b] - xs[a] > least;
  return here.filter((i, k) => far(here[k - 1], i) || far(i, here[k + 1]));
}

/// uPlot's options of a live chart: lines, with points where samples are far apart.
function liveOptions(block, model, shown, width) {
  const options = chartOptions(block, model, shown, width);
  for (const { points } of options.series.slice(1)) {
    points.size = 5;
    points.filter = (plot, s) => sparse(plot.data[0], plot.data[s]);
  }
  return options;
}

/// Draws a block of the kind "lines" as viewer/README.md has it. Returns { figure, update(block) }, where
/// the new block has series of the same names.
export function liveChart(given) {
  const block = { ...given, type: "lines" };
  const model = lineData(block);
  const shown = block.series.map(() => true);
  const frame = el("div", {
    ...{ class: "chart", role: "img", tabindex: 0 },
    "aria-label": `${block.caption}: ${block.y_label} over ${block.x_label}; arrow keys tell values`,
  });
  let plot = null;
  const toggle = (name, on) =>
    block.series.forEach((series, s) => {
      if (series.name !== name) return;
      shown[s] = on;
      plot?.setSeries(1 + model.plan.findIndex((column) => column.series === s), { show: on });
    });
  whenShown(frame, () => {
    plot = new uPlot(liveOptions(block, model, shown, frame.clientWidth), model.data, frame);
    followPointer(frame, plot, block, model.points, shown);
    new ResizeObserver(() => {
      const width = frame.clientWidth;
      if (width && width !== plot.width) plot.setSize({ width, height: plot.height });
    }).observe(frame);
    frame.toSvg = () => lineSvg(plot, block, model.points, shown);
    frame.redraw = () => plot.redraw(false, true);
  });
  const looks = seriesLooks(block.series);
  const entries = block.series.map(({ name }, s) => ({ name, ...looks[s], mark: "line" }));
  const drawn = figure("figure", block.caption, legend(entries, toggle), frame);
  const update = (next) => {
    Object.assign(block, next);
    const made = lineData(block);
    model.points.splice(0, model.points.length, ...made.points);
    model.data = made.data;
    if (plot) plot.setData(made.data);
  };
  return { figure: withSaving(block, drawn), update };
}
