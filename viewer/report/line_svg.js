// The same chart as uPlot shows, as SVG: to be saved.

import { svg } from "./dom.js";
import { marksOf } from "./line_marks.js";
import { pathThrough } from "./panel.js";
import { seriesLooks } from "./palette.js";
import { themeColor } from "./theme.js";

let clips = 0;

const line = (x1, y1, x2, y2, stroke, more = {}) =>
  svg("line", { x1, y1, x2, y2, stroke, ...more });

/// Grid lines and labels of both axes, where uPlot has them now.
function axes(plot, box, { x_label, y_label }) {
  const ink = themeColor("--ink");
  const faint = themeColor("--faint");
  const [xs, ys] = plot.axes.map(({ _splits, _values }) =>
    (_splits ?? []).map((value, i) => ({ value, text: _values[i] })),
  );
  const text = (attributes, words) =>
    svg("text", { style: `fill: ${ink}`, ...attributes }, words ?? "");
  return [
    ...xs.flatMap(({ value, text: words }) => [
      line(box.x(value), box.top, box.x(value), box.bottom, faint),
      text({ x: box.x(value), y: box.bottom + 18, "text-anchor": "middle" }, words),
    ]),
    ...ys.flatMap(({ value, text: words }) => [
      line(box.left, box.y(value), box.right, box.y(value), faint),
      text({ x: box.left - 8, y: box.y(value) + 4, "text-anchor": "end" }, words),
    ]),
    text({ x: (box.left + box.right) / 2, y: box.bottom + 46, "text-anchor": "middle" }, x_label),
    text(
      {
        "text-anchor": "middle",
        transform: `translate(14 ${(box.top + box.bottom) / 2}) rotate(-90)`,
      },
      y_label,
    ),
  ];
}

/// The band, the curve and the dots of one series.
function series({ style = "lines", faint }, list, { color, dash }, box) {
  const stroke = themeColor(color);
  const path = (key) =>
    pathThrough(list.map((p) => [box.x(p.x), p[key] === null ? NaN : box.y(p[key])]));
  const banded = list.filter(({ low, high }) => low !== null && high !== null);
  const edge = (key) => banded.map((p) => `${box.x(p.x).toFixed(1)} ${box.y(p[key]).toFixed(1)}`);
  return [
    banded.length > 1
      ? svg("path", {
          fill: stroke,
          "fill-opacity": 0.2,
          d: `M${[...edge("low"), ...edge("high").reverse()].join("L")}Z`,
        })
      : null,
    style === "points"
      ? null
      : svg("path", {
          fill: "none",
          stroke,
          "stroke-width": faint ? 1 : 2,
          "stroke-opacity": faint ? 0.63 : 1,
          "stroke-dasharray": dash?.join(" "),
          d: path("y"),
        }),
    ...(style === "lines"
      ? []
      : list
          .filter(({ y }) => y !== null)
          .map((p) => svg("circle", { fill: stroke, cx: box.x(p.x), cy: box.y(p.y), r: 4 }))),
  ];
}

/// The chart of a uPlot instance in its present range, with the series that are shown.
export function lineSvg(plot, block, points, shown) {
  const ratio = devicePixelRatio;
  const { left, top, width, height } = plot.bbox;
  const box = {
    left: left / ratio,
    top: top / ratio,
    right: (left + width) / ratio,
    bottom: (top + height) / ratio,
    x: (v) => plot.valToPos(v, "x", true) / ratio,
    y: (v) => plot.valToPos(v, "y", true) / ratio,
  };
  const looks = seriesLooks(block.series);
  const marks = marksOf(plot, block, points, shown);
  const muted = themeColor("--muted");
  const id = `chart-clip-${++clips}`;
  return svg(
    "svg",
    {
      class: "plot",
      width: plot.width,
      height: plot.height,
      viewBox: `0 0 ${plot.width} ${plot.height}`,
    },
    svg(
      "clipPath",
      { id },
      svg("rect", { x: box.left, y: box.top, width: width / ratio, height: height / ratio }),
    ),
    ...axes(plot, box, block),
    svg(
      "g",
      { "clip-path": `url(#${id})` },
      ...block.series.flatMap((one, s) => (shown[s] ? series(one, points[s], looks[s], box) : [])),
    ),
    ...marks.lines.map((ends) =>
      line(...ends.map((v) => v / ratio), muted, { "stroke-dasharray": "5 4" }),
    ),
    ...marks.texts.map(({ text, place, color }) =>
      svg(
        "text",
        {
          style: `fill: ${themeColor(color)}`,
          x: place.left / ratio,
          y: (place.top + place.bottom) / 2 / ratio + 4,
        },
        text,
      ),
    ),
  );
}
