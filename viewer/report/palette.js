// Colours that most colour-blind readers can tell apart. Source: Okabe and Ito, Color Universal
// Design, 2008. Their black follows the text colour, so that it is also seen on a dark page;
// yellow, weak on white, comes last.

const NAMES = ["blue", "vermillion", "green", "purple", "orange", "sky", "ink", "yellow"];

const HEX = {
  blue: "#0072b2",
  vermillion: "#d55e00",
  green: "#009e73",
  purple: "#cc79a7",
  orange: "#e69f00",
  sky: "#56b4e9",
  ink: "#777777",
  yellow: "#c9b900",
};

/// For CSS and SVG: follows the colour scheme by itself.
export const cssColor = (index) => `var(--${NAMES[index % NAMES.length]})`;

/// Colours of series: faint ones are grey and take none from the others.
export function seriesColors(series) {
  let next = 0;
  return series.map(({ faint }) => (faint ? "var(--muted)" : cssColor(next++)));
}

/// For WebGL, which has no colour scheme.
export const hexColor = (index) => HEX[NAMES[index % NAMES.length]];

/// A number to each name, in order of first appearance.
export function indexByName(names) {
  const index = new Map();
  for (const name of names) if (!index.has(name)) index.set(name, index.size);
  return index;
}
