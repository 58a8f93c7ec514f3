// A ball held by three fingertips: meshes, contacts with their friction cones, thumbnails.

const coded = (Kind, values) => Buffer.from(Kind.from(values).buffer).toString("base64");

/// A capsule along z of the given radius and half length, or a ball [mm].
function capsule(radius, half, around = 24, along = 16) {
  const corners = [];
  const triangles = [];
  for (let i = 0; i <= along; ++i) {
    const angle = (Math.PI * i) / along;
    const height = -radius * Math.cos(angle) + (2 * i < along ? -half : half);
    for (let k = 0; k < around; ++k) {
      const turn = (2 * Math.PI * k) / around;
      const out = radius * Math.sin(angle);
      corners.push(out * Math.cos(turn), out * Math.sin(turn), height);
    }
  }
  for (let i = 0; i < along; ++i)
    for (let k = 0; k < around; ++k) {
      const [a, b] = [i * around + k, i * around + ((k + 1) % around)];
      triangles.push(a, b, b + around, a, b + around, a + around);
    }
  const step = (radius + half) / 32767;
  return {
    origin: [0, 0, 0],
    step,
    vertices: coded(
      Int16Array,
      corners.map((value) => Math.round(value / step)),
    ),
    triangles: coded(Uint16Array, triangles),
  };
}

const BALL = 30; // [mm]
const TIP = 8; // [mm]
const COLORS = ["#d9a58c", "#56b4e9", "#009e73"];

const fingers = [0, 1, 2].map((i) => {
  const turn = (2 * Math.PI * i) / 3;
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  return { out: [c, s, 0], across: [-s, c, 0] };
});
const times = (v, factor) => v.map((value) => factor * value);

const tips = fingers.map(({ out, across }, i) => ({
  name: `finger ${i + 1}`,
  color: COLORS[i],
  items: [
    {
      kind: "mesh",
      mesh: "fingertip",
      rotation: [0, 1, 2].map((k) => [across[k], out[k], k === 2 ? 1 : 0]),
      position: [...times(out, BALL + TIP).slice(0, 2), 14],
    },
  ],
}));

const layers = [
  ...tips,
  { name: "ball", color: "#e69f00", items: [{ kind: "mesh", mesh: "ball", opacity: 0.6 }] },
  {
    name: "contacts",
    color: "#b3261e",
    items: fingers.flatMap(({ out }) => [
      { kind: "points", positions: [times(out, BALL)], radius: 1.2 },
      { kind: "cone", tip: times(out, BALL), axis: times(out, -14), radius: 7 },
    ]),
  },
];

export const MESHES = { ball: capsule(BALL, 0, 48, 32), fingertip: capsule(TIP, 22) };

const instants = [0, 0.05, 0.1, 0.15, 0.2]; // [s]

/// A ball that is thrown, and falls.
const motion = {
  type: "scene",
  caption: "The ball is let go.",
  strip: [0, 0.1, 0.2],
  layers: instants.map((time) => ({
    name: `${time} s`,
    time,
    color: "#e69f00",
    items: [{ kind: "mesh", mesh: "ball", position: [600 * time, 0, -4905 * time * time] }],
  })),
};

export const meshes = () => ({
  id: "grasp",
  title: "A grasp",
  text: "Meshes stand once in a report; scenes name them. Compact scenes are drawn when they come near the window.",
  blocks: [
    { type: "scene", caption: "Three fingertips hold a ball; cones are friction.", layers },
    {
      type: "row",
      narrow: true,
      blocks: [
        { type: "scene", compact: true, caption: "From above.", view: [0.2, 0, 1], layers },
        { type: "scene", compact: true, caption: "From the side.", view: [1, 1, 0.1], layers },
      ],
    },
    motion,
  ],
});
