// The shapes of force panels in pixels: an arrow, and the ellipse around its tip.

import { svg } from "./dom.js";
import { ELLIPSE_RADIUS, isPoint } from "./vectors_model.js";

const HEAD = 7; // length of an arrow's head [px]

/// A line with a head; a dot where there is no length.
export function shaft(kind, from, to) {
  const dx = to[0] - from[0];
  const dy = to[1] - from[1];
  const length = Math.hypot(dx, dy);
  if (length < 0.5) return [svg("circle", { class: kind, cx: to[0], cy: to[1], r: 2 })];
  const head = Math.min(HEAD, 0.6 * length);
  const ux = dx / length;
  const uy = dy / length;
  const base = [to[0] - head * ux, to[1] - head * uy];
  const wing = (side) => `${base[0] - side * 0.4 * head * uy},${base[1] + side * 0.4 * head * ux}`;
  return [
    svg("line", { class: kind, x1: from[0], y1: from[1], x2: base[0], y2: base[1] }),
    svg("polygon", { class: kind, points: `${to[0]},${to[1]} ${wing(1)} ${wing(-1)}` }),
  ];
}

/// The region that holds 95 % of the forces; nothing if the standard deviations are not known.
export const ellipse = (kind, { x, y }, tip, sd) =>
  !isPoint(tip) || !isPoint(sd)
    ? []
    : [
        svg("ellipse", {
          class: kind,
          cx: x(tip[0]),
          cy: y(tip[1]),
          rx: ELLIPSE_RADIUS * Math.abs(x(sd[0]) - x(0)),
          ry: ELLIPSE_RADIUS * Math.abs(y(sd[1]) - y(0)),
        }),
      ];
