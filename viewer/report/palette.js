// Colours that most colour-blind readers can tell apart: seven of Okabe and Ito (Color Universal
// Design, 2008), whose black follows the text colour so that it is also seen on a dark page, and
// three between them. Their yellow is left out: it is weak on white, and looks like orange to many.

const NAMES = [
  "blue",
  "vermillion",
  "green",
  "purple",
  "orange",
  "sky",
  "ink",
  "indigo",
  "brown",
  "wine",
];

/// Colours on a white page; for WebGL, where ink has to be seen on either page.
export const HEX = {
  blue: "#0072b2",
  vermillion: "#d55e00",
  green: "#009e73",
  purple: "#cc79a7",
  orange: "#e69f00",
  sky: "#56b4e9",
  ink: "#777777",
  indigo: "#222288",
  brown: "#664433",
  wine: "#993366",
};

// Dashes of lines once all colours are used up [px].
const DASHES = [undefined, [8, 4], [2, 3], [10, 3, 2, 3]];

/// For CSS and SVG: follows the colour scheme by itself.
export const cssColor = (index) => `var(--${NAMES[index % NAMES.length]})`;

/// The dashes of a line: none for the first ten, then those that tell it from lines of its colour.
export const dashOf = (index) => DASHES[Math.floor(index / NAMES.length) % DASHES.length];

/// { color, dash } of each series: faint ones are grey and take no colour from the others. Series of
/// one name look alike.
export function seriesLooks(series) {
  const index = indexByName(series.filter(({ faint }) => !faint).map(({ name }) => name));
  return series.map(({ name, faint }) =>
    faint
      ? { color: "var(--muted)", dash: undefined }
      : { color: cssColor(index.get(name)), dash: dashOf(index.get(name)) },
  );
}

/// For WebGL, which has no colour scheme.
export const hexColor = (index) => HEX[NAMES[index % NAMES.length]];

/// A number to each name, in order of first appearance.
export function indexByName(names) {
  const index = new Map();
  for (const name of names) if (!index.has(name)) index.set(name, index.size);
  return index;
}
