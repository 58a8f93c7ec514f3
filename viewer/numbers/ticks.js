// Round numbers for axes, grids and scale bars.

/// The 1, 2 or 5 times a power of ten next above `rough` (> 0).
export function niceStep(rough) {
  const power = 10 ** Math.floor(Math.log10(rough));
  const factor = [1, 2, 5, 10].find((f) => f * power >= rough * (1 - 1e-9));
  return factor * power;
}

/// Round values within [low, high], about `count` of them.
export function ticks(low, high, count = 5) {
  if (!(high > low)) return [low];
  const step = niceStep((high - low) / count);
  const values = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
    values.push(Number((i * step).toPrecision(12)));
  return values;
}

const ROUND_OFF = 1e-12; // relative

/// Smallest interval that holds all finite values, widened by a share of itself on both sides.
/// Values whose differences are less than `flat` of the largest are taken for one value, which
/// stands in the middle.
export function extent(values, margin = 0, flat = ROUND_OFF) {
  const finite = values.filter(Number.isFinite);
  if (finite.length === 0) return [0, 1];
  const low = finite.reduce((a, b) => Math.min(a, b));
  const high = finite.reduce((a, b) => Math.max(a, b));
  const size = Math.max(Math.abs(low), Math.abs(high));
  const pad = high - low > flat * size ? margin * (high - low) : 0.5 * (size || 1);
  return [low - pad, high + pad];
}

/// Maps [low, high] to [start, end], linearly.
export const linear =
  ([low, high], [start, end]) =>
  (value) =>
    start + ((value - low) / (high - low)) * (end - start);
