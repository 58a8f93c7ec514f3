// Where words find room in a chart, clear of curves, points and other words. Without the browser;
// all in pixels.

const STEP = 5; // between the points that stand for a curve

const overlaps = (a, b) =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

const boxAt = ([left, top], { width, height }) => ({
  left,
  top,
  right: left + width,
  bottom: top + height,
});

const inside = (place, box) =>
  place.left >= box.left &&
  place.right <= box.left + box.width &&
  place.top >= box.top &&
  place.bottom <= box.top + box.height;

/// Points along a curve through `points` ([x, y], null is a gap), a few pixels apart.
export function pointsAlong(points) {
  const along = [];
  points.forEach((point, i) => {
    const last = points[i - 1];
    if (!point) return;
    const count = last ? Math.ceil(Math.hypot(point[0] - last[0], point[1] - last[1]) / STEP) : 0;
    for (let k = 1; k < count; ++k)
      along.push(last.map((value, axis) => value + (k / count) * (point[axis] - value)));
    along.push(point);
  });
  return along;
}

/// The first free place of words of a size beside a point: right, left, above, below; none if all
/// are taken.
export function freePlace([x, y], size, box, taken) {
  const gap = 0.7 * size.height;
  return [
    [x + gap, y - size.height / 2],
    [x - gap - size.width, y - size.height / 2],
    [x - size.width / 2, y - gap - size.height],
    [x - size.width / 2, y + gap],
  ]
    .map((corner) => boxAt(corner, size))
    .find((place) => inside(place, box) && !taken.some((other) => overlaps(place, other)));
}

/// Places beside a line across the chart: at its ends first, then between them.
function besideLine(axis, at, size, box, gap) {
  const room = axis === "y" ? box.width - size.width : box.height - size.height;
  const start = axis === "y" ? box.left : box.top;
  const along = [0, 1, 0.5, 0.25, 0.75].map((share) => start + gap + share * (room - 2 * gap));
  const across =
    axis === "y" ? [at - gap - size.height, at + gap] : [at + gap, at - gap - size.width];
  return along.flatMap((a) => across.map((b) => (axis === "y" ? [a, b] : [b, a])));
}

/// The place of a reference line's words that covers the fewest of `points` and none of the boxes
/// `taken`, if there is one. `axis` is "y" for a level line at the height `at`, "x" for an upright
/// one.
export function clearPlace({ axis, at }, size, box, points, taken) {
  const gap = 0.4 * size.height;
  const cost = (place) =>
    (inside(place, box) ? 0 : 1e6) +
    1e3 * taken.filter((other) => overlaps(place, other)).length +
    points.filter(
      ([x, y]) =>
        x > place.left - gap &&
        x < place.right + gap &&
        y > place.top - gap &&
        y < place.bottom + gap,
    ).length;
  return besideLine(axis, at, size, box, gap)
    .map((corner) => boxAt(corner, size))
    .reduce((best, place) => (cost(place) < cost(best) ? place : best));
}
