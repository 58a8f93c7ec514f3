// Where words of a scene stand, so that none covers another. Without the browser; all in pixels.

const ROW = 14; // height of a line of words
const GAP = 6; // between a point and its words
const ROWS = [0, -1, 1, -2, 2, -3, 3, -4, 4]; // away from the point, the nearest first

const overlaps = (a, b) =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/// Places of words right and left of a point, the nearest first.
function around({ x, y, width }) {
  return ROWS.flatMap((row) =>
    [x + GAP, x - GAP - width].map((left) => ({
      left,
      right: left + width,
      top: y + (row - 0.5) * ROW,
      bottom: y + (row + 0.5) * ROW,
      far: row !== 0,
    })),
  );
}

/// A place for each of `labels`, which are { x, y: of the point, width, depth: from the eye }: near
/// ones choose first, and who finds no room within a picture of this size is left out. `taken` are
/// boxes { left, right, top, bottom } to keep clear. Returns { label, place }, where `place.far`
/// asks for a line from the words to the point.
export function placeLabels(labels, { width, height }, taken = []) {
  const used = [...taken];
  const inside = ({ left, right, top, bottom }) =>
    left >= 2 && right <= width - 2 && top >= 1 && bottom <= height - 1;
  return [...labels]
    .sort((a, b) => a.depth - b.depth)
    .flatMap((label) => {
      const place = around(label).find(
        (one) => inside(one) && !used.some((other) => overlaps(one, other)),
      );
      if (!place) return [];
      used.push(place);
      return [{ label, place }];
    });
}
