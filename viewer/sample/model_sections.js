// The fitted axes in space, and the price of each method.

import { noise, round } from "./random.js";

// A middle finger slightly flexed, joint centres in the frame of the metacarpal; x radial, y
// distal, z dorsal [mm].
export const CHAIN = [
  [0, -45, 2],
  [0, 0, 0],
  [1, 43, -12],
  [1, 62, -33],
  [1, 66, -52],
];
const JOINTS = ["MCP", "PIP", "DIP"];

const bones = {
  name: "bones",
  color: "#b9a98c",
  items: [0, 1, 2, 3].map((i) => ({
    kind: "segment",
    a: CHAIN[i],
    b: CHAIN[i + 1],
    radius: [6, 5.2, 4.4, 3.8][i],
  })),
};

const axesOf = (name, color, tilt, visible = true) => ({
  name,
  color,
  visible,
  items: JOINTS.map((joint, i) => ({
    kind: "axis",
    point: CHAIN[i + 1],
    direction: [1, tilt[i], 0.5 * tilt[i]],
    length: 38,
    label: `${joint} ${name}`,
  })),
});

const beside = (offset) => CHAIN.map(([x, y, z], i) => [x, y + 0.12 * offset[i], z + offset[i]]);

const tendons = {
  name: "tendons",
  color: "#0072b2",
  items: [
    { kind: "line", positions: beside([-9, -10, -7, -6, -4]), value: 4.2, width: 5 },
    { kind: "line", positions: beside([9, 10, 8, 6, 4]), dashed: true, color: "#8a8f99" },
  ],
};

const FRAME = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const surface = (shape, center, size) => ({ kind: "surface", shape, center, size, axes: FRAME });

const surfaces = {
  name: "surfaces",
  color: "#56b4e9",
  items: [surface("sphere", CHAIN[1], [8]), surface("capsule", CHAIN[2], [5, 3])],
};

const tip = {
  name: "tip force",
  color: "#cc79a7",
  items: [{ kind: "arrow", from: CHAIN[4], vector: [0, -22, -24], label: "FDP 2.9 N" }],
};

/// An octahedron around a point: the hull of the forces that a finger can make is of this kind.
function hull([x, y, z], [a, b, c]) {
  const vertices = [
    [a, 0, 0],
    [-a, 0, 0],
    [0, b, 0],
    [0, -b, 0],
    [0, 0, c],
    [0, 0, -c],
  ].map(([u, v, w]) => [round(x + u), round(y + v), round(z + w)]);
  return {
    kind: "hull",
    vertices,
    faces: [
      [0, 2, 4],
      [2, 1, 4],
      [1, 3, 4],
      [3, 0, 4],
      [2, 0, 5],
      [1, 2, 5],
      [3, 1, 5],
      [0, 3, 5],
    ],
  };
}

const cloud = {
  name: "posterior of axis points",
  color: "#e69f00",
  items: [
    {
      kind: "points",
      radius: 0.6,
      positions: CHAIN.slice(1, 4).flatMap(([x, y, z]) =>
        Array.from({ length: 60 }, () => [
          round(x + 15 + noise(2)),
          round(y + noise(1.5)),
          round(z + noise(1.5)),
        ]),
      ),
    },
  ],
};

const scene = (caption, layers, link, color_scale) => ({
  type: "scene",
  caption,
  unit: "mm",
  up: [0, 0, 1],
  view: [1.2, 0.5, 0.6],
  link,
  color_scale,
  layers,
});

export const axes = () => ({
  id: "axes",
  title: "Joint axes",
  text: "Axes point to the side of positive flexion by the right-hand rule.",
  blocks: [
    scene(
      "Fitted axes of the middle finger against the axes of the starting model.",
      [
        bones,
        axesOf("fitted", "#d55e00", [0.1, -0.12, 0.2]),
        axesOf("start", "#009e73", [0, 0, 0], false),
        surfaces,
        tendons,
        tip,
        cloud,
      ],
      undefined,
      { label: "tension [N]", low: 0, high: 5, dashed: "slack" },
    ),
    {
      type: "row",
      blocks: [
        scene(
          "Forces the human finger can make at its tip, 1 N drawn as 5 mm.",
          [
            bones,
            { name: "feasible forces", color: "#0072b2", items: [hull(CHAIN[4], [16, 26, 34])] },
          ],
          "tip",
        ),
        scene(
          "The same for a robot finger with four motors.",
          [
            bones,
            { name: "feasible forces", color: "#d55e00", items: [hull(CHAIN[4], [24, 18, 20])] },
          ],
          "tip",
        ),
      ],
    },
  ],
});

const METHODS = {
  "product of exponentials": [0.13, 2e-15],
  "AVX2 lanes": [0.5, 1e-15],
  "multibody rebuild": [140, 3e-12],
  "finite differences": [4.1, 3e-7],
  "tabulated arms": [0.08, 4e-4],
};

const costs = () => ({
  type: "lines",
  caption: "Error against time of five ways to the same fingertip force. Lower left is better.",
  log_x: true,
  log_y: true,
  x_label: "time per call [\u00b5s]",
  y_label: "relative error [1]",
  series: [
    ...Object.entries(METHODS).map(([name, [x, y]]) => ({ name, x: [x], y: [y], style: "points" })),
    {
      name: "fixed step, by number of steps",
      style: "both",
      x: [0.2, 0.8, 3.2, 12.8],
      y: [1e-2, 6e-4, 4e-5, 2.4e-6],
      labels: ["4", "16", "64", "256"],
    },
  ],
});

const qualities = () => ({
  type: "bars",
  caption:
    "Grasp quality of four hands on three objects, with the spread over starting poses. The task needs at least the dashed value.",
  x_label: "largest resisted wrench [N]",
  groups: ["cup", "pen", "ball"].map((name, i) => ({
    name,
    values: ["rigid", "soft pads", "real joints", "robot"].map((series, j) => {
      const value = round(2.2 + 0.8 * j - 0.7 * i + noise(0.3), 3);
      return i === 1 && j === 3
        ? { series, value: null }
        : { series, value, low: round(value - 0.3), high: round(value + 0.4) };
    }),
  })),
  reference_lines: [{ label: "task", value: 2 }],
});

const wide = () => ({
  type: "table",
  caption: "A wide table becomes denser, and on a phone its rows become cards.",
  best: "highest",
  highlight_best: 2,
  columns: [
    { name: "method" },
    { name: "converged" },
    { name: "runs per second", unit: "1/s", digits: 0 },
    ...Array.from({ length: 9 }, (_, i) => ({
      name: `residual norm ${i + 1}`,
      unit: "N",
      digits: 4,
    })),
  ],
  rows: Object.entries(METHODS).map(([name, [x]], r) => [
    name,
    r !== 3,
    Math.round(1e6 / x),
    ...Array.from({ length: 9 }, () => round(Math.abs(noise(0.01 ** (r / 4))))),
  ]),
});

export const speed = () => ({
  id: "speed",
  title: "Speed, accuracy and use",
  text: "",
  blocks: [
    costs(),
    wide(),
    {
      type: "text",
      text: "A method is worth its time only if no other is both faster and more exact. Of the five, two are on that front.",
    },
    qualities(),
  ],
});
