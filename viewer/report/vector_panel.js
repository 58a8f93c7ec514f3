// One posture in one finger plane: measured and predicted force arrows from a common origin, as
// SVG.

import { ellipse, shaft } from "./arrow_shapes.js";
import { svg } from "./dom.js";
import { formatNumber, tickLabels } from "../numbers/format.js";
import { cssColor } from "./palette.js";
import { linear, ticks } from "../numbers/ticks.js";
import { describe } from "./tooltip.js";
import { isPoint, misfit } from "./vectors_model.js";

const MARGIN = { left: 46, right: 8, top: 24, bottom: 38 }; // [px]

/// Pixel position of a force, for a plane's range and a scale in pixels per unit.
function projection([xs, ys], scale) {
  const width = scale * (xs[1] - xs[0]);
  const height = scale * (ys[1] - ys[0]);
  return {
    x: linear(xs, [MARGIN.left, MARGIN.left + width]),
    y: linear(ys, [MARGIN.top + height, MARGIN.top]),
    width,
    height,
  };
}

function frame({ x, y, width, height }, [xs, ys], plane) {
  const count = (span) => Math.max(2, Math.round(span / 32));
  const bottom = MARGIN.top + height;
  const line = (kind, x1, y1, x2, y2) => svg("line", { class: kind, x1, y1, x2, y2 });
  const across = ticks(...xs, count(width));
  const up = ticks(...ys, count(height));
  const names = [tickLabels(across), tickLabels(up)];
  const vertical = across.flatMap((v, i) => [
    line(v === 0 ? "zero" : "grid", x(v), MARGIN.top, x(v), bottom),
    svg("text", { x: x(v), y: bottom + 13, "text-anchor": "middle" }, names[0][i]),
  ]);
  const horizontal = up.flatMap((v, i) => [
    line(v === 0 ? "zero" : "grid", MARGIN.left, y(v), MARGIN.left + width, y(v)),
    svg("text", { x: MARGIN.left - 5, y: y(v) + 3.5, "text-anchor": "end" }, names[1][i]),
  ]);
  return [
    ...vertical,
    ...horizontal,
    svg(
      "text",
      { class: "label", x: MARGIN.left + width / 2, y: bottom + 29, "text-anchor": "middle" },
      plane.x_label ?? "",
    ),
    svg(
      "text",
      {
        class: "label",
        "text-anchor": "middle",
        transform: `translate(11 ${MARGIN.top + height / 2}) rotate(-90)`,
      },
      plane.y_label ?? "",
    ),
  ];
}

const told = (tip, sd) =>
  (isPoint(tip) ? `(${formatNumber(tip[0])}, ${formatNumber(tip[1])})` : "n/a") +
  (isPoint(sd) ? `, sd (${formatNumber(sd[0])}, ${formatNumber(sd[1])})` : "");

const words = (a, title) => [
  `${a.group}, ${title}`,
  `measured ${told(a.measured, a.sd)}`,
  `predicted ${told(a.predicted, a.predicted_sd)}`,
  `difference ${formatNumber(misfit(a))}`,
];

function pair(a, index, at, title) {
  const origin = [at.x(0), at.y(0)];
  const arrow = (kind, tip) =>
    isPoint(tip) ? shaft(kind, origin, [at.x(tip[0]), at.y(tip[1])]) : [];
  const wide = (tip) =>
    isPoint(tip)
      ? [
          svg("line", {
            class: "catch",
            x1: origin[0],
            y1: origin[1],
            x2: at.x(tip[0]),
            y2: at.y(tip[1]),
          }),
        ]
      : [];
  const group = svg(
    "g",
    {
      class: "pair",
      "data-group": a.group,
      style: `color: ${cssColor(index)}`,
      tabindex: 0,
      role: "img",
    },
    ...ellipse("interval", at, a.measured, a.sd),
    ...ellipse("interval dashed", at, a.predicted, a.predicted_sd),
    ...arrow("measured", a.measured),
    ...arrow("predicted", a.predicted),
    ...wide(a.measured),
    ...wide(a.predicted),
  );
  return describe(group, words(a, title));
}

/// The SVG of one panel; `index` gives each tendon its colour.
export function vectorPanel(panel, plane, range, scale, index) {
  const at = projection(range, scale);
  const width = at.width + MARGIN.left + MARGIN.right;
  const height = at.height + MARGIN.top + MARGIN.bottom;
  return svg(
    "svg",
    { class: "plot vector-panel", width, height, viewBox: `0 0 ${width} ${height}` },
    svg("text", { class: "title", x: MARGIN.left, y: 14 }, panel.title),
    ...frame(at, range, plane),
    ...panel.arrows.map((a) => pair(a, index.get(a.group), at, panel.title)),
  );
}
