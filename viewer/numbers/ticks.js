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

/// Smallest interval that holds all finite values, widened by a share of itself on both sides.
export function extent(values, margin = 0) {
  const finite = values.filter(Number.isFinite);
  if (finite.length === 0) return [0, 1];
  const low = Math.min(...finite);
  const high = Math.max(...finite);
  const pad = high > low ? margin * (high - low) : 0.5 * (Math.abs(low) || 1);
  return [low - pad, high + pad];
}

/// Maps [low, high] to [start, end], linearly.
export const linear =
  ([low, high], [start, end]) =>
  (value) =>
    start + ((value - low) / (high - low)) * (end - start);
