// Colours of a quantity: an item with a `value` gets its colour from the scale of its scene.

// Equal steps of "plasma" (Smith and van der Walt, matplotlib, CC0) without its ends, which are
// hard to see on a dark and on a light page.
const STOPS = ["#4c02a1", "#7e03a8", "#a82296", "#cb4679", "#e56b5d", "#f89441", "#fdc328"];

const channels = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

/// The colour at `fraction`, which is clamped to 0..1, as "#rrggbb".
function colorAt(fraction) {
  const place = Math.min(1, Math.max(0, fraction)) * (STOPS.length - 1);
  const below = Math.min(Math.floor(place), STOPS.length - 2);
  const [from, to] = [channels(STOPS[below]), channels(STOPS[below + 1])];
  const mixed = from.map((c, i) => Math.round(c + (place - below) * (to[i] - c)));
  return `#${mixed.map((c) => c.toString(16).padStart(2, "0")).join("")}`;
}

/// The colour of a value on a scale { low, high }.
export const colorOf = (value, { low, high }) =>
  colorAt(high > low ? (value - low) / (high - low) : 0);

/// The scale from low to high as a CSS gradient, left to right.
export const cssGradient = () => `linear-gradient(to right, ${STOPS.join(", ")})`;

/// Layers whose items with a value have the colour of it.
export function colored(layers, scale) {
  if (!scale) return layers;
  const paint = (item) =>
    Number.isFinite(item.value) ? { color: colorOf(item.value, scale), ...item } : item;
  return layers.map((layer) => ({ ...layer, items: layer.items.map(paint) }));
}

const STEPS = 600; // of the search along the scale
const NEAR = 12; // of a colour, in bytes of each channel, within which it is one of the scale

/// The value that a colour [r, g, b] in bytes of sRGB stands for on a scale { low, high }, to a
/// 600th of it; null for colours that are not of the scale.
export function valueOf(color, { low, high }) {
  let best = { apart: Infinity };
  for (let i = 0; i <= STEPS; ++i) {
    const there = channels(colorAt(i / STEPS));
    const apart = Math.max(...there.map((c, k) => Math.abs(c - color[k])));
    if (apart < best.apart) best = { apart, fraction: i / STEPS };
  }
  return best.apart <= NEAR ? low + best.fraction * (high - low) : null;
}
