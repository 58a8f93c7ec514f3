// The common scale of force panels, and the ellipses around their arrows. Without the browser.

import { isNumber } from "../numbers/format.js";
import { extent } from "../numbers/ticks.js";

/// Radius, in standard deviations, that holds 95 % of a normal distribution in the plane:
/// sqrt(chi2_2(0.95)).
export const ELLIPSE_RADIUS = 2.4477;

export const isPoint = (v) => Array.isArray(v) && v.every(isNumber);

/// All values that coordinate `k` (0 or 1) of a panel takes, ellipses and origin included.
function reach(panel, k) {
  const around = (tip, sd) =>
    !isPoint(tip)
      ? []
      : isPoint(sd)
        ? [tip[k] - ELLIPSE_RADIUS * sd[k], tip[k] + ELLIPSE_RADIUS * sd[k]]
        : [tip[k]];
  return [
    0,
    ...panel.arrows.flatMap((a) => [
      ...around(a.measured, a.sd),
      ...around(a.predicted, a.predicted_sd),
    ]),
  ];
}

/// The range that all panels of a plane share.
export const planeRange = (plane) =>
  [0, 1].map((k) =>
    extent(
      plane.panels.flatMap((panel) => reach(panel, k)),
      0.08,
    ),
  );

/// Pixels per unit of force, one for the whole block: the widest plane fills `width`, the tallest
/// stays within `height`.
export function commonScale(ranges, width, height) {
  const span = (k) => Math.max(...ranges.map((range) => range[k][1] - range[k][0]));
  return Math.min(width / span(0), height / span(1));
}

/// Length of the difference between measured and predicted; null if either is missing.
export const misfit = ({ measured: m, predicted: p }) =>
  isPoint(m) && isPoint(p) ? Math.hypot(m[0] - p[0], m[1] - p[1]) : null;

/// Tendons in order of first appearance.
export const groupsOf = (block) => [
  ...new Set(
    block.planes.flatMap((plane) =>
      plane.panels.flatMap((panel) => panel.arrows.map((a) => a.group)),
    ),
  ),
];
