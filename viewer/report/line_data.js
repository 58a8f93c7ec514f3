// Series with their own x values as the one table of columns that uPlot draws. Without the browser.

import { isNumber } from "../numbers/format.js";

const drawable = (value, log) => isNumber(value) && (!log || value > 0);

/// A series in order of x; what a logarithmic axis cannot show becomes a gap.
function ordered(series, { log_x, log_y }) {
  const points = series.x.map((x, i) => ({
    x,
    y: drawable(series.y[i], log_y) ? series.y[i] : null,
    low: bandValue(series.band_low, i, log_y),
    high: bandValue(series.band_high, i, log_y),
    label: series.labels?.[i],
    hint: series.hints?.[i],
  }));
  return points.filter(({ x }) => drawable(x, log_x)).sort((a, b) => a.x - b.x);
}

const bandValue = (band, i, log) => (band && drawable(band[i], log) ? band[i] : null);

/// Every x as often as the series that repeats it most.
function unionX(all) {
  const most = new Map();
  for (const points of all) {
    const count = new Map();
    for (const { x } of points) count.set(x, (count.get(x) ?? 0) + 1);
    for (const [x, n] of count) most.set(x, Math.max(n, most.get(x) ?? 0));
  }
  return [...most].sort(([a], [b]) => a - b).flatMap(([x, n]) => Array(n).fill(x));
}

/// One value per union x: undefined where the series has no point (drawn over), null where it is
/// missing (a gap).
function column(points, xs, key) {
  let next = 0;
  return xs.map((x) =>
    next < points.length && points[next].x === x ? points[next++][key] : undefined,
  );
}

function columnsOf(points, xs, hasBand) {
  return (hasBand ? ["y", "low", "high"] : ["y"]).map((key) => column(points, xs, key));
}

/// `data` are uPlot's columns; `plan` says which series and part each column after the first is;
/// `lost` counts the points no axis can show.
export function lineData(block) {
  const all = block.series.map((series) => ordered(series, block));
  const xs = unionX(all);
  const data = [xs];
  const plan = [];
  let lost = 0;
  block.series.forEach((series, s) => {
    const hasBand = Boolean(series.band_low && series.band_high);
    data.push(...columnsOf(all[s], xs, hasBand));
    plan.push(
      { series: s, part: "y" },
      ...(hasBand
        ? [
            { series: s, part: "low" },
            { series: s, part: "high" },
          ]
        : []),
    );
    lost += series.x.length - all[s].filter(({ y }) => y !== null).length;
  });
  return { data, plan, points: all, lost };
}
