// What a fit is judged by: forces against predictions, residuals, intervals, profiles.

import { noise, round } from "./random.js";

const TENDONS = {
  FDS: [-1.25, -1.7],
  FDP: [-1.9, -2.2],
  EDC: [0.35, 0.75],
  LU: [0.12, -0.2],
  RI: [0.5, -0.62],
  UI: [0.62, -0.5],
};
const POSTURES = { "minor flexion": 0, "major flexion": 0.25, hyperextension: -0.45, hook: 0.6 };

const turned = ([x, y], angle) => [
  x * Math.cos(angle) - y * Math.sin(angle),
  x * Math.sin(angle) + y * Math.cos(angle),
];
const shaken = (v, sd) => v.map((value) => round(value + noise(sd)));

function arrow(group, force, sd) {
  return {
    group,
    measured: shaken(force, 0.12),
    predicted: shaken(force, 0.1),
    sd: [round(sd), round(0.8 * sd)],
  };
}

function plane(name, x_label, y_label, flatten) {
  const panels = Object.entries(POSTURES).map(([title, angle]) => ({
    title,
    arrows: Object.entries(TENDONS).map(([group, force]) =>
      arrow(group, flatten(turned(force, angle), group), 0.05 + 0.03 * Math.hypot(...force)),
    ),
  }));
  return { name, x_label, y_label, panels };
}

function residualTable() {
  const rows = Object.keys(POSTURES).flatMap((posture) =>
    Object.keys(TENDONS).map((tendon) => {
      const force = 0.3 + Math.abs(noise(1));
      const error = Math.abs(noise(0.12));
      return [
        posture,
        tendon,
        round(force),
        round(error),
        round((100 * error) / force, 3),
        round(Math.abs(noise(6)), 3),
      ];
    }),
  );
  rows[5][4] = null;
  return {
    type: "table",
    caption:
      "Residuals of each loading; the lowest relative error is marked. A missing value means that the measured force was below the resolution of the sensor.",
    columns: [
      { name: "posture" },
      { name: "tendon" },
      { name: "measured force", unit: "N", digits: 2 },
      { name: "error", unit: "N", digits: 3 },
      { name: "relative error", unit: "%", digits: 1 },
      { name: "angle between", unit: "deg", digits: 1 },
    ],
    rows,
    highlight_best: 4,
    search: true,
  };
}

export function forces() {
  const side = { RI: 0.9, UI: -0.85, LU: 0.25, FDS: 0.1, FDP: -0.1, EDC: 0.05 };
  return {
    id: "forces",
    title: "Measured and predicted forces",
    text:
      "Each tendon was loaded by itself in four postures, and the force of the fingertip was measured in three directions. An arrow is one loading.\n\n" +
      "The prediction is that of the fitted axes; it has not seen the hook posture.",
    blocks: [
      {
        type: "vectors",
        caption:
          "Fingertip force of each tendon, measured (solid) and predicted (dashed). All panels share one scale. Ellipses hold 95 % of the repetitions.",
        planes: [
          plane(
            "Flexion plane",
            "distal \u2190 \u2192 proximal [N]",
            "palmar \u2190 \u2192 dorsal [N]",
            (v) => v,
          ),
          plane(
            "Abduction plane",
            "distal \u2190 \u2192 proximal [N]",
            "ulnar \u2190 \u2192 radial [N]",
            ([x], group) => [x, side[group]],
          ),
        ],
      },
      residualTable(),
    ],
  };
}

const PARAMETERS = [
  "MCP flexion axis, tilt",
  "MCP flexion axis, offset",
  "MCP abduction axis, tilt",
  "PIP axis, tilt",
  "PIP axis, offset",
  "DIP axis, tilt",
  "DIP axis, offset",
  "EDC band fraction",
];

function intervals() {
  const rows = PARAMETERS.map((name, i) => {
    const unit = name.includes("tilt") ? "deg" : name.includes("offset") ? "mm" : "";
    const spread = [0.2, 0.35, 0.3, 0.15, 0.5, 0.25, 0.9, 0.4][i];
    const estimate = round(noise(0.6));
    const row = {
      name,
      estimate,
      low: round(estimate - 1.96 * spread),
      high: round(estimate + 1.96 * spread),
      prior_low: -1.96,
      prior_high: 1.96,
      truth: round(estimate + noise(spread)),
    };
    return {
      ...row,
      null: i === 6,
      display:
        i === 6 ? undefined : `${round(3 * estimate, 3)} ${unit}`.replace("-", "\u2212").trim(),
    };
  });
  return {
    type: "interval",
    caption:
      "Estimates with 95 % intervals in units of the prior standard deviation, over the prior (grey). The values at the right are in their own units.",
    x_label: "parameter [prior sd]",
    rows,
    reference_lines: [{ label: "prior mean", value: 0 }],
  };
}

function profiles() {
  const x = Array.from({ length: 61 }, (_, i) => round(-6 + 0.2 * i));
  const curve = (center, width, power) =>
    x.map((v) => round(Math.abs((v - center) / width) ** power));
  return {
    type: "lines",
    caption:
      "Profile likelihoods of three axes. The DIP offset stays below the threshold everywhere: these data do not identify it.",
    x_label: "deviation from the estimate [deg or mm]",
    y_label: "2 (log L_max \u2212 log L) [1]",
    reference_lines: [{ axis: "y", label: "95 % (chi-squared, 1 degree of freedom)", value: 3.84 }],
    series: [
      { name: "MCP flexion tilt", x, y: curve(0, 1.6, 2) },
      { name: "PIP tilt", x, y: curve(0.3, 2.1, 2) },
      { name: "DIP offset", x, y: x.map((v) => round(1.8 * (1 - Math.exp((-v * v) / 9)))) },
    ],
  };
}

function residualBand() {
  const x = Array.from({ length: 40 }, (_, i) => -20 + 2.5 * i);
  const y = x.map((v) => round(-1.3 + 0.6 * Math.cos(v / 30) + noise(0.01)));
  return {
    type: "lines",
    caption:
      "Palmar force of FDP along the range of the PIP joint, with the 95 % posterior band and the measurements.",
    x_label: "PIP flexion [deg]",
    y_label: "palmar force [N]",
    series: [
      {
        name: "posterior mean",
        x,
        y,
        band_low: y.map((v, i) => round(v - 0.08 - 0.002 * i)),
        band_high: y.map((v, i) => round(v + 0.08 + 0.002 * i)),
      },
      {
        name: "measured",
        x: [0, 25, 25, 50, 65],
        y: [-0.71, -0.86, -0.93, -1.35, null],
        style: "points",
      },
    ],
  };
}

export const evidence = () => ({
  id: "evidence",
  title: "What the data say about each parameter",
  text: "A parameter is called not identifiable if its profile stays below the threshold on one side.",
  blocks: [intervals(), { type: "row", blocks: [profiles(), residualBand()] }],
});
