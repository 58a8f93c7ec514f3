// How quantities of the server, SI and radians, are shown and typed: angles in degrees, lengths in mm.

import { formatNumber } from "../../numbers/format.js";

const DEGREE = Math.PI / 180;

/// { unit, scale: SI of one unit, digits, step, big: steps of keys and sliders in the unit }.
export const QUANTITIES = {
  angle: { unit: "\u00b0", scale: DEGREE, digits: 1, step: 1, big: 10 },
  length: { unit: "mm", scale: 1e-3, digits: 1, step: 1, big: 10 },
  force: { unit: "N", scale: 1, digits: 2, step: 0.5, big: 5 },
  share: { unit: "", scale: 1, digits: 2, step: 0.01, big: 0.1 },
};

/// The quantity of a joint's value.
export const quantityOf = ({ slides }) => (slides ? QUANTITIES.length : QUANTITIES.angle);

/// "12.5 mm", "30.0°": with its unit, which for degrees follows without a space.
export function told(value, quantity) {
  if (!Number.isFinite(value)) return "n/a";
  const { unit, scale, digits } = quantity;
  const shown = value / scale;
  const rounded = Math.abs(shown) < 0.5 * 10 ** -digits ? 0 : shown;
  const text = formatNumber(rounded, digits);
  return unit === "" ? text : unit === "\u00b0" ? `${text}${unit}` : `${text}\u202f${unit}`;
}

/// What was typed, back in SI; null where it is no number.
export function typed(text, { scale }) {
  const value = Number(String(text).trim().replace("\u2212", "-").replace(",", "."));
  return String(text).trim() === "" || !Number.isFinite(value) ? null : value * scale;
}

/// A value within its limits.
export const clamped = (value, lower, upper) => Math.min(upper, Math.max(lower, value));
