// Vectors in the frame of the picture, and the words for their directions.

const AXES = ["x", "y", "z"];
const NAMED = 1 / 3; // parts below this share of the largest are not named, as in the server's words

/// A vector (3) turned by a unit quaternion [w, x, y, z]: v + 2 u x (u x v + w v), u = (x, y, z).
export function rotated(v, [w, x, y, z]) {
  const u = [x, y, z];
  const cross = (a, b) => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
  ];
  const first = cross(u, v).map((c, i) => c + w * v[i]);
  return cross(u, first).map((c, i) => v[i] + 2 * c);
}

/// Both halves of a wrench (6), force first, turned alike.
export const rotatedWrench = (wrench, rotation) => [
  ...rotated(wrench.slice(0, 3), rotation),
  ...rotated(wrench.slice(3), rotation),
];

/// The quaternion [w, x, y, z] of a body of a frame; null where the body is not there.
export function rotationOf(frame, body) {
  if (!frame || body < 0 || 7 * body + 7 > frame.bodies.length) return null;
  return [...frame.bodies.subarray(7 * body + 3, 7 * body + 7)];
}

/// The large parts of a vector, as a sign and an axis each: ["+x"].
const largeParts = (vector, largest) =>
  vector.flatMap((part, i) =>
    largest > 0 && Math.abs(part) >= NAMED * largest
      ? [`${part > 0 ? "+" : "\u2212"}${AXES[i]}`]
      : [],
  );

/// A wrench (6), torques over a length, in words: "force along \u2212z, torque about +x".
export function wrenchWords(wrench) {
  const largest = Math.max(...wrench.map(Math.abs));
  const along = largeParts(wrench.slice(0, 3), largest).map((axis) => `force along ${axis}`);
  const about = largeParts(wrench.slice(3), largest).map((axis) => `torque about ${axis}`);
  return [...along, ...about].join(", ") || "none";
}

/// What rounding leaves of zero reads 0: less than 1e-9 of `scale`, the size of what went in.
export const steady = (value, scale) => (Math.abs(value) < 1e-9 * scale ? 0 : value);
