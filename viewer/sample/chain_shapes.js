// Invented chains, and what the C++ side would say of them.

import { noise, round } from "./random.js";

export const CHAINS = 4;
export const DRAWS = 240; // of each chain
const BINS = 20;
const LAGS = 40;

const mean = (x) => x.reduce((a, b) => a + b, 0) / x.length;
export const sd = (x) => Math.sqrt(mean(x.map((v) => (v - mean(x)) ** 2)));

/// A chain that remembers `phi` of its last step, of unit variance.
export function chain(phi) {
  let x = noise(1);
  return Array.from({ length: DRAWS }, () => (x = phi * x + noise(Math.sqrt(1 - phi * phi))));
}

/// Counts of the ranks of each chain among all draws.
function rankCounts(chains) {
  const all = chains.flatMap((x, c) => x.map((v) => ({ v, c }))).sort((a, b) => a.v - b.v);
  const counts = chains.map(() => Array(BINS).fill(0));
  all.forEach(({ c }, rank) => ++counts[c][Math.floor((rank / all.length) * BINS)]);
  return counts;
}

function autocorrelation(x) {
  const m = mean(x);
  const at = (lag) => x.slice(lag).reduce((s, v, i) => s + (v - m) * (x[i] - m), 0);
  return Array.from({ length: LAGS }, (_, lag) => round(at(lag) / at(0), 3));
}

/// Potential scale reduction of whole chains.
function rHat(chains) {
  const within = mean(chains.map((x) => sd(x) ** 2));
  const between = sd(chains.map(mean)) ** 2 * (chains.length / (chains.length - 1));
  return Math.sqrt(1 + between / within);
}

/// One entry of a block of chains; `tau` is how many draws a chain remembers.
export function chainEntry(name, unit, chains, tau) {
  const reach = 1.96 * Math.sqrt(tau * (DRAWS / BINS) * (1 - 1 / BINS) * (1 - 1 / CHAINS));
  return {
    name,
    unit,
    r_hat: round(rHat(chains)),
    bulk_ess: Math.round((CHAINS * DRAWS) / tau),
    tail_ess: Math.round((0.8 * CHAINS * DRAWS) / tau),
    traces: chains.map((x) => x.map((v) => round(v))),
    ranks: {
      counts: rankCounts(chains),
      mean: DRAWS / BINS,
      low: round(Math.max(0, DRAWS / BINS - reach), 3),
      high: round(DRAWS / BINS + reach, 3),
    },
    autocorrelation: chains.map(autocorrelation),
    lag_step: 1,
  };
}
