// A chart whose numbers change while it is looked at.

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
    plot = new uPlot(chartOptions(block, model, shown, frame.clientWidth), model.data, frame);
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
