// A posterior: chains that do not agree, what was learnt, axes as clouds, predictions, calibration.

import { chain, chainEntry, CHAINS, DRAWS, sd } from "./chain_shapes.js";
import { CHAIN } from "./model_sections.js";
import { noise, round } from "./random.js";

const times = (count, make) => Array.from({ length: count }, (_, i) => make(i));

/// Chains of each quantity [unit]; a ridge, two peaks of which one chain sees but one, a funnel.
function draw() {
  const ridge = times(CHAINS, () => chain(0.6));
  const across = times(CHAINS, () => chain(0.3));
  const slow = times(CHAINS, () => chain(0.93));
  const peaks = times(CHAINS, (c) => slow[c].map((v) => (c === 3 || v > -0.5 ? 1 : -1)));
  const noises = times(CHAINS, () => chain(0.5));
  const mix = (parts, f) =>
    times(CHAINS, (c) => times(DRAWS, (i) => f(...parts.map((p) => p[c][i]))));
  const free = times(4, () => times(CHAINS, () => chain(0.4)));
  return [
    // Name, unit, chains, draws that a chain remembers, mean and sd of the prior.
    ["axis/MCP3_FE/direction/1", "deg", mix([ridge], (a) => 2 + 4 * a), 4, 0, 12],
    [
      "axis/MCP3_FE/point/1",
      "mm",
      mix([ridge, across], (a, b) => -1 - 1.5 * a + 0.12 * b),
      4,
      0,
      4,
    ],
    ["axis/PIP3_FE/direction/2", "deg", mix([peaks, across], (p, b) => 6 * p + 1.2 * b), 26, 0, 10],
    ["path/FDP/2/dorsal", "mm", mix([noises, free[0]], (v, b) => Math.exp(0.6 * v) * b), 3, 0, 3],
    ["noise/H01", "1", mix([noises], (v) => Math.exp(0.25 * v)), 3, 1.1, 0.5],
    ["H01: arm/FDS/PIP3_FE", "mm", mix([free[1]], (v) => 8.3 + 0.4 * v), 2.3, 7.5, 2.5],
    ["hood/EDC/central", "1", mix([free[2]], (v) => 0.2 + 0.7 * v), 2.3, 0, 1],
    ["friction/FDP", "1", mix([free[3]], (v) => 0.05 + 0.01 * Math.abs(v)), 2.3, 0.05, 0.03],
    ["angle/DIP3_FE/hook", "deg", mix([across, free[1]], (a, b) => 2.9 * a + 0.3 * b), 1.9, 0, 3],
  ];
}

const once = (make) => {
  let made;
  return () => (made ??= make());
};
const drawn = once(draw);
const byRHat = once(() =>
  drawn()
    .map(([name, unit, chains, tau]) => chainEntry(name, unit, chains, tau))
    .sort((a, b) => b.r_hat - a.r_hat),
);

const banners = () => [
  {
    type: "banner",
    ok: false,
    title: "This run has NOT converged",
    reasons: [
      `R-hat of ${byRHat()[0].name} is ${byRHat()[0].r_hat}, wanted at most 1.01`,
      "bulk ESS of axis/PIP3_FE/direction/2 is 37, wanted at least 400",
      "12 of 960 draws diverged, wanted none",
    ],
    text:
      "No number of this posterior may be relied on: chains that disagree, or remember too long, " +
      "do not describe the distribution they were sent to. nuts, 4 chains of 240 draws, 12 s.",
  },
  {
    type: "banner",
    ok: true,
    title: "The chains agree",
    text: "Largest R-hat 1.0034, least bulk ESS 1893, least tail ESS 1712. The quiet line of a run that has converged.",
  },
];

const agreement = () => ({
  type: "chains",
  caption:
    "Chains after warm-up, the largest R-hat first. Left the draws in order; right how many of each chain's ranks among all draws fall into each twentieth, over the band that holds 95 % of such counts; below how long a chain remembers.",
  chains: times(CHAINS, (c) => `chain ${c + 1}`),
  draws: times(DRAWS, (i) => 4 * i + 1),
  quantities: byRHat(),
});

function corner() {
  const every = 2;
  return {
    type: "corner",
    caption:
      "Densities of single quantities and of pairs: regions that hold 50 and 90 % of the draws, and the draws outside.",
    shown: [0, 1, 2, 3, 4, 5],
    quantities: drawn().map(([name, unit, chains, , center, prior]) => {
      const all = chains.flat();
      return {
        name,
        unit: unit === "1" ? undefined : unit,
        draws: all.filter((_, i) => i % every === 0).map((v) => round(v)),
        prior: times(150, () => round(center + noise(prior))),
        truth: name.startsWith("axis") ? round(all[100]) : undefined,
      };
    }),
  };
}

/// A value with the digits that its sd leaves it.
function told(value, spread, unit, share) {
  const digits = Math.max(0, 1 - Math.floor(Math.log10(spread)));
  const [mean, sd_] = [value, spread].map((v) => v.toFixed(digits).replace("-", "\u2212"));
  return `${mean} \u00b1 ${sd_}${unit === "1" ? "" : ` ${unit}`}; ${Math.round(100 * share)} % learnt`;
}

function learnt() {
  const rows = drawn().map(([name, unit, chains, , center, prior]) => {
    const rising = chains
      .flat()
      .map((v) => (v - center) / prior)
      .sort((a, b) => a - b);
    const at = (share) => round(rising[Math.floor(share * (rising.length - 1))]);
    const spread = sd(chains.flat());
    return {
      name,
      estimate: at(0.5),
      low: at(0.05),
      high: at(0.95),
      inner_low: at(0.25),
      inner_high: at(0.75),
      prior_low: -1.645,
      prior_high: 1.645,
      prior_inner_low: -0.674,
      prior_inner_high: 0.674,
      display: told(center + prior * at(0.5), spread, unit, Math.max(0, 1 - spread / prior)),
      learnt: 1 - spread / prior,
    };
  });
  return {
    type: "interval",
    caption:
      "50 % (thick) and 90 % (thin) intervals in prior sds over the prior's (grey), the best known first. At the right median and sd; learnt is by how much the sd shrank.",
    x_label: "distance from the prior mean [prior sds]",
    rows: rows.sort((a, b) => b.learnt - a.learnt).map(({ learnt: _, ...row }) => row),
  };
}

/// Lines about the joints: ends of `count` drawn axes each.
const cloud = (name, color, spread, count) => ({
  name,
  color,
  items: CHAIN.slice(1, 4).map(([x, y, z], joint) => ({
    kind: "lines",
    opacity: 0.12,
    positions: times(count, () => {
      const tilt = [noise(spread * (1 + joint)), noise(spread)];
      const shift = [noise(4 * spread), noise(4 * spread)];
      return [-1, 1].map((s) => [
        round(x + 19 * s),
        round(y + shift[0] + 19 * s * tilt[0]),
        round(z + shift[1] + 19 * s * tilt[1]),
      ]);
    }).flat(),
  })),
});

const axisLayer = (name, color, tilt, labelled) => ({
  name,
  color,
  items: ["MCP", "PIP", "DIP"].map((joint, i) => ({
    kind: "axis",
    point: CHAIN[i + 1],
    direction: [1, tilt, 0.5 * tilt],
    length: 38,
    ...(labelled ? { label: joint } : {}),
  })),
});

const clouds = () => ({
  type: "scene",
  caption:
    "Every line is an axis at one draw, through the point nearest to the bones; the axes before the fit are named.",
  up: [0, 0, 1],
  view: [0.5, 0.5, 0.9],
  layers: [
    {
      name: "bones",
      color: "#b8a48a",
      items: [0, 1, 2, 3].map((i) => ({
        kind: "segment",
        a: CHAIN[i],
        b: CHAIN[i + 1],
        radius: 4,
      })),
    },
    axisLayer("axes before", "#777777", 0, true),
    cloud("population", "#0072b2", 0.16, 120),
    cloud("H01", "#d55e00", 0.06, 120),
    axisLayer("true axes", "#009e73", 0.05, false),
  ],
});

function predicted() {
  const forces = { FDS: 1.4, FDP: 2.4, EDC: -0.5, LU: 0.2, RI: 0.5, UI: 0.45 };
  return {
    type: "predictive",
    caption:
      "H01, in sample. Measured force components (dots) over posterior predictive 50 % (thick) and 95 % (thin) intervals, noise included.",
    unit: "N",
    components: ["proximal", "dorsal", "radial"],
    groups: ["minor flexion", "major flexion", "hyperextension", "hook"].map((name) => ({
      name,
      rows: Object.entries(forces).map(([tendon, size]) => ({
        name: tendon,
        values: [0.6, -1, 0.2].map((share) => {
          const median = round(share * size + noise(0.05));
          const wide = 0.05 + 0.08 * Math.abs(share * size);
          return {
            measured: round(median + noise(1.3 * wide)),
            median,
            low: round(median - 1.96 * wide),
            inner_low: round(median - 0.674 * wide),
            inner_high: round(median + 0.674 * wide),
            high: round(median + 1.96 * wide),
          };
        }),
      })),
    })),
  };
}

function paretoShapes() {
  const k = times(72, () => round(0.25 + noise(0.17), 3));
  k[37] = 0.83;
  const name = (i) => `H01 ${["minor", "major", "hyper", "hook"][i % 4]} trial ${i + 1}`;
  const pick = (ok) => times(72, (i) => i).filter((i) => ok(k[i]));
  const series = (title, key, chosen) => ({
    name: title,
    style: "points",
    x: chosen.map((i) => i + 1),
    y: chosen.map((i) => k[i]),
    [key]: chosen.map(name),
  });
  return {
    type: "lines",
    caption:
      "Pareto k of each of 72 observations left out in turn. Expected log predictive density 41.2 \u00b1 7.9, effective number of parameters 11.3.",
    x_label: "observation",
    y_label: "Pareto k [1]",
    series: [
      series(
        "trusted",
        "hints",
        pick((v) => v <= 0.7),
      ),
      series(
        "not to be trusted",
        "labels",
        pick((v) => v > 0.7),
      ),
    ].filter(({ x }) => x.length),
    reference_lines: [{ value: 0.7, label: "0.7: above, not to be trusted" }],
  };
}

function calibration() {
  const ranks = times(41, (i) => i / 40);
  const band = ranks.map((r) => round(2.9 * Math.sqrt((r * (1 - r)) / 200)));
  const bridge = (bias) => {
    const steps = ranks.map(() => noise(0.0112));
    const sum = steps.reduce((a, b) => a + b, 0);
    let at = 0;
    return ranks.map((r, i) => {
      at += steps[i] - sum / ranks.length;
      return round(r === 0 || r === 1 ? 0 : at + bias * r * (1 - r));
    });
  };
  const line = (name, bias, more) => ({ name, x: ranks, y: bridge(bias), ...more });
  const hints = (name) => ranks.map(() => name);
  return {
    type: "lines",
    caption:
      "Calibration by 200 simulated experiments: empirical distribution of the true values' ranks among the draws, less the uniform one. 1 of 7 curves leaves the band that holds 95 % of curves.",
    x_label: "rank of the true value, as a fraction",
    y_label: "difference of distributions [1]",
    series: [
      {
        name: "95 % band",
        x: ranks,
        y: ranks.map(() => 0),
        band_low: band.map((v) => -v),
        band_high: band,
        faint: true,
      },
      ...times(6, (i) => line("within the band", 0, { faint: true, hints: hints(drawn()[i][0]) })),
      line("noise/H01", -0.55),
    ],
  };
}

function samplers() {
  const course = (name, rate, warm, floor = 0) => {
    const x = times(9, (i) => round(warm + 0.4 * 2 ** i, 3));
    const y = x.map((t) =>
      round((rate / Math.sqrt(t - 0.9 * warm)) * Math.exp(noise(0.15)) + floor, 3),
    );
    return { name, style: "both", x, y };
  };
  return {
    type: "lines",
    caption:
      "Error of the posterior mean over wall time, warm-up included. Lower left is better; a line that stays high has not found the posterior.",
    log_x: true,
    log_y: true,
    x_label: "wall time [s]",
    y_label: "RMS error of the mean [posterior sds]",
    series: [
      course("nuts", 0.03, 0.5),
      course("hmc", 0.05, 0.5),
      course("dream-zs", 0.3, 1.5),
      course("adaptive-metropolis", 0.5, 1),
      course("stretch", 0.2, 1, 0.4),
    ],
  };
}

export const posterior = () => [
  {
    id: "posterior-convergence",
    title: "Posterior: may the draws be believed?",
    text: "",
    blocks: [...banners(), agreement()],
  },
  {
    id: "posterior-learnt",
    title: "Posterior: what was learnt",
    text: "",
    blocks: [learnt(), corner()],
  },
  { id: "posterior-axes", title: "Posterior: axes in space", text: "", blocks: [clouds()] },
  {
    id: "posterior-predictions",
    title: "Posterior: measured and predicted forces",
    text: "",
    blocks: [predicted(), { type: "row", blocks: [paretoShapes(), calibration()] }, samplers()],
  },
];
