// A small chart with its own axes, as SVG.

import { svg } from "./dom.js";
import { tickLabels } from "../numbers/format.js";
import { linear, ticks } from "../numbers/ticks.js";

const TICK_ROOM = { x: 70, y: 36 }; // least distance of two ticks [px]

const line = (kind, x1, y1, x2, y2) => svg("line", { class: kind, x1, y1, x2, y2 });

/// Maps of both axes, and the box between them. `margin` is { left, right, top, bottom } [px].
export function panelBox(width, height, margin, xs, ys) {
  const right = width - margin.right;
  const bottom = height - margin.bottom;
  return {
    width,
    height,
    left: margin.left,
    top: margin.top,
    right,
    bottom,
    x: linear(xs, [margin.left, right]),
    y: linear(ys, [bottom, margin.top]),
    xs,
    ys,
  };
}

/// Grid, ticks and labels of a box.
export function panelAxes(box, { x_label, y_label }) {
  const { left, right, top, bottom, x, y, xs, ys } = box;
  const count = (room, least) => Math.max(2, Math.floor(room / least));
  const across = ticks(...xs, count(right - left, TICK_ROOM.x));
  const up = ticks(...ys, count(bottom - top, TICK_ROOM.y));
  const names = [tickLabels(across), tickLabels(up)];
  return [
    ...across.flatMap((v, i) => [
      line("grid", x(v), top, x(v), bottom),
      svg("text", { x: x(v), y: bottom + 14, "text-anchor": "middle" }, names[0][i]),
    ]),
    ...up.flatMap((v, i) => [
      line("grid", left, y(v), right, y(v)),
      svg("text", { x: left - 5, y: y(v) + 4, "text-anchor": "end" }, names[1][i]),
    ]),
    svg(
      "text",
      { class: "label", x: (left + right) / 2, y: bottom + 30, "text-anchor": "middle" },
      x_label ?? "",
    ),
    svg(
      "text",
      {
        class: "label",
        "text-anchor": "middle",
        transform: `translate(12 ${(top + bottom) / 2}) rotate(-90)`,
      },
      y_label ?? "",
    ),
  ];
}

/// The SVG around it, with the name that a screen reader says.
export const panelSvg = (box, label, ...content) =>
  svg(
    "svg",
    {
      class: "plot panel",
      width: box.width,
      height: box.height,
      viewBox: `0 0 ${box.width} ${box.height}`,
      role: "img",
      "aria-label": label,
    },
    ...content,
  );

/// "M x y L x y ..." through points in pixels; a point that is not a number interrupts it.
export function pathThrough(points) {
  let pen = "M";
  return points
    .map(([x, y]) => {
      if (!Number.isFinite(x) || !Number.isFinite(y)) {
        pen = "M";
        return "";
      }
      const step = `${pen}${x.toFixed(1)} ${y.toFixed(1)}`;
      pen = "L";
      return step;
    })
    .join("");
}
