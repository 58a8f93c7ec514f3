// What a chart tells at a place: the nearest point, and every curve at one x. Without the browser.

/// The point nearest to a place, of the series that are shown; `distance(point)` in pixels. Null
/// beyond `reach`.
export function nearestPoint(points, shown, distance, reach) {
  let best = null;
  points.forEach((list, s) => {
    if (!shown[s]) return;
    for (const p of list) {
      if (p.y === null) continue;
      const d = distance(p);
      if (!best || d < best.d) best = { ...p, s, d };
    }
  });
  return best && best.d < reach ? best : null;
}

const isCurve = ({ style = "lines" }) => style !== "points";

/// All x at which a shown curve has a value, in order, each once.
export function curveXs(block, points, shown) {
  const xs = points.flatMap((list, s) =>
    shown[s] && isCurve(block.series[s])
      ? list.filter(({ y }) => y !== null).map(({ x }) => x)
      : [],
  );
  return [...new Set(xs)].sort((a, b) => a - b);
}

/// The value of an ordered list that is nearest to `x`; undefined of an empty list.
export function nearestOf(xs, x) {
  let low = 0;
  let high = xs.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (xs[middle] <= x) low = middle;
    else high = middle;
  }
  return Math.abs(xs[high] - x) < Math.abs(xs[low] - x) ? xs[high] : xs[low];
}

/// The points of all shown series at one x, the highest first as they are seen.
export function pointsAt(points, shown, x) {
  return points
    .flatMap((list, s) =>
      shown[s] ? list.filter((p) => p.x === x && p.y !== null).map((p) => ({ ...p, s })) : [],
    )
    .sort((a, b) => b.y - a.y);
}
