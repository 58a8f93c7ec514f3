// Densities of draws: how wide to smooth, on a line and in a plane.

import { regionOf } from "./contours.js";

const BINS = 128; // of the histogram that is smoothed
const CELLS = 56; // a side of the grid of a pair

const mean = (values) => values.reduce((sum, v) => sum + v, 0) / values.length;
export const spreadOf = (values) => {
  const m = mean(values);
  const square = values.reduce((sum, v) => sum + (v - m) ** 2, 0);
  return Math.sqrt(square / Math.max(1, values.length - 1));
};

/// Shares of values in equal bins over [low, high].
function histogram(values, low, high, bins) {
  const share = new Float64Array(bins);
  for (const v of values) {
    const at = Math.floor(((v - low) / (high - low)) * bins);
    share[Math.min(bins - 1, Math.max(0, at))] += 1 / values.length;
  }
  return share;
}

/// Squares of half the cosine transform, without the constant.
function squaredCosines(share) {
  const n = share.length;
  const squares = [];
  for (let k = 1; k < n; ++k) {
    let sum = 0;
    for (let i = 0; i < n; ++i) sum += share[i] * Math.cos((Math.PI * k * (i + 0.5)) / n);
    squares.push(sum ** 2);
  }
  return squares;
}

/// Norm of the s-th derivative of the density smoothed for the time t.
function roughness(squares, s, t) {
  let sum = 0;
  squares.forEach((a, i) => {
    const k2 = (i + 1) ** 2;
    sum += k2 ** s * a * Math.exp(-k2 * Math.PI ** 2 * t);
  });
  return 2 * Math.PI ** (2 * s) * sum;
}

const STAGES = 7;

/// t less the time that the roughness at t asks for; its root is the answer.
function excess(squares, count, t) {
  let f = roughness(squares, STAGES, t);
  for (let s = STAGES - 1; s >= 2; --s) {
    let odd = 1;
    for (let k = 3; k < 2 * s; k += 2) odd *= k;
    const factor = ((1 + 0.5 ** (s + 0.5)) / 3) * (odd / Math.sqrt(2 * Math.PI));
    f = roughness(squares, s, ((2 * factor) / (count * f)) ** (2 / (3 + 2 * s)));
  }
  return t - (2 * count * Math.sqrt(Math.PI) * f) ** (-2 / 5);
}

/// Standard deviation of the normal kernel that suits draws of any shape, also of several peaks.
/// Source: Botev, Grotowski and Kroese 2010, the improved Sheather-Jones rule.
export function bandwidth(values) {
  const low = Math.min(...values);
  const high = Math.max(...values);
  const width = high - low;
  if (!(width > 0)) return 0;
  const from = low - 0.1 * width;
  const range = 1.2 * width;
  const squares = squaredCosines(histogram(values, from, from + range, BINS));
  let [a, b] = [1e-9, 0.1];
  const plain = 0.9 * spreadOf(values) * values.length ** -0.2; // Silverman's rule
  if (!(excess(squares, values.length, a) < 0 && excess(squares, values.length, b) > 0))
    return plain;
  for (let i = 0; i < 40; ++i) {
    const t = Math.sqrt(a * b);
    if (excess(squares, values.length, t) < 0) a = t;
    else b = t;
  }
  return Math.min(2 * plain, Math.sqrt(a) * range);
}

/// Normal weights at distances of whole cells.
function kernel(h, cell) {
  const reach = Math.max(1, Math.ceil((4 * h) / cell));
  const raw = Array.from({ length: 2 * reach + 1 }, (_, i) =>
    Math.exp(-0.5 * (((i - reach) * cell) / Math.max(h, 0.3 * cell)) ** 2),
  );
  const sum = raw.reduce((a, b) => a + b, 0);
  return { reach, weights: raw.map((w) => w / sum) };
}

function smooth(cells, at, count, { reach, weights }) {
  const out = new Float64Array(count);
  for (let i = 0; i < count; ++i) {
    const value = cells[at(i)];
    if (value === 0) continue;
    for (let k = -reach; k <= reach; ++k)
      if (i + k >= 0 && i + k < count) out[i + k] += value * weights[k + reach];
  }
  for (let i = 0; i < count; ++i) cells[at(i)] = out[i];
}

/// The density of finite draws as { x, y }, beyond their ends by three kernels.
export function density(values) {
  const h = bandwidth(values);
  if (!(h > 0)) return { x: [], y: [] };
  const low = Math.min(...values) - 3 * h;
  const high = Math.max(...values) + 3 * h;
  const bins = Math.min(512, Math.max(BINS, Math.ceil((3 * (high - low)) / h)));
  const cell = (high - low) / bins;
  const share = histogram(values, low, high, bins);
  smooth(share, (i) => i, bins, kernel(h, cell));
  return {
    x: Array.from(share, (_, i) => low + (i + 0.5) * cell),
    y: Array.from(share, (v) => v / cell),
  };
}

/// Coordinates in which a cloud is round: x = mean + L u with the Cholesky factor L of the
/// covariance, so that narrow ridges are smoothed along themselves, not across.
function whitening(xs, ys) {
  const [mx, my] = [mean(xs), mean(ys)];
  const l11 = spreadOf(xs);
  const covariance = xs.reduce((s, x, i) => s + (x - mx) * (ys[i] - my), 0) / (xs.length - 1);
  const l21 = covariance / l11;
  const l22 = Math.sqrt(Math.max(spreadOf(ys) ** 2 - l21 ** 2, 0));
  return {
    usable: l11 > 0 && l22 > 0,
    into: (x, y) => {
      const u = (x - mx) / l11;
      return [u, (y - my - l21 * u) / l22];
    },
    back: ([u, v]) => [mx + l11 * u, my + l21 * u + l22 * v],
  };
}

const reachOf = (values, h) => [Math.min(...values) - 4 * h, Math.max(...values) + 4 * h];

/// Smoothed shares of a grid over the draws; its rim is nearly empty.
function gridOf(us, vs) {
  const widen = us.length ** (1 / 5 - 1 / 6); // a plane wants wider kernels than a line
  const [hu, hv] = [us, vs].map((values) => widen * bandwidth(values));
  const [lu, hiu] = reachOf(us, hu);
  const [lv, hiv] = reachOf(vs, hv);
  const [du, dv] = [(hiu - lu) / CELLS, (hiv - lv) / CELLS];
  const cells = new Float64Array(CELLS * CELLS);
  us.forEach((u, i) => {
    const a = Math.floor((u - lu) / du);
    const b = Math.floor((vs[i] - lv) / dv);
    cells[b * CELLS + a] += 1;
  });
  const across = kernel(hu, du);
  const along = kernel(hv, dv);
  for (let k = 0; k < CELLS; ++k) smooth(cells, (i) => k * CELLS + i, CELLS, across);
  for (let k = 0; k < CELLS; ++k) smooth(cells, (i) => i * CELLS + k, CELLS, along);
  return { cells, side: CELLS, low: [lu + du / 2, lv + dv / 2], step: [du, dv] };
}

function heightAt({ cells, side, low, step }, u, v) {
  const a = Math.min(side - 1, Math.max(0, Math.round((u - low[0]) / step[0])));
  const b = Math.min(side - 1, Math.max(0, Math.round((v - low[1]) / step[1])));
  return cells[b * side + a];
}

/// The regions of highest density that hold these shares of the draws, each as closed rings of
/// [x, y]; and the draws outside all of them.
export function regions(xs, ys, shares) {
  const map = whitening(xs, ys);
  const all = xs.map((x, i) => [x, ys[i]]);
  if (!map.usable) return { rings: shares.map(() => []), outside: all };
  const flat = all.map(([x, y]) => map.into(x, y));
  const grid = gridOf(
    flat.map(([u]) => u),
    flat.map(([, v]) => v),
  );
  const heights = flat.map(([u, v]) => heightAt(grid, u, v));
  const falling = [...heights].sort((a, b) => b - a);
  const levels = shares.map((s) => falling[Math.min(xs.length - 1, Math.floor(s * xs.length))]);
  const lowest = Math.min(...levels);
  return {
    rings: levels.map((level) => regionOf(grid, level).map((ring) => ring.map(map.back))),
    outside: all.filter((_, i) => heights[i] < lowest),
  };
}

/// Pearson's coefficient of correlation; NaN where one does not vary.
export function correlation(xs, ys) {
  const [mx, my] = [mean(xs), mean(ys)];
  const sum = xs.reduce((s, x, i) => s + (x - mx) * (ys[i] - my), 0);
  return sum / ((xs.length - 1) * spreadOf(xs) * spreadOf(ys));
}
