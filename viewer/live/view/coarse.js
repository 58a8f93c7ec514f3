// The same surface with fewer triangles, for pictures that are drawn while things move.

import { BufferAttribute, BufferGeometry } from "three";

const FEW = 600; // triangles of a surface that is left as it is
const WIDTH = 2.2; // of cells, in mean edges of the surface
const CELLS = 1 << 20; // along a side at most: keys of cells stay whole numbers

/// The mean length of edges.
function meanEdge(positions, triangles) {
  let sum = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b] = [3 * triangles[t], 3 * triangles[t + 1]];
    sum += Math.hypot(...[0, 1, 2].map((k) => positions[a + k] - positions[b + k]));
  }
  return sum / Math.max(1, triangles.length / 3);
}

/// The vertex that stands for each: the first that was met in the cell of a grid of this width.
function representatives(positions, cell) {
  const first = new Map();
  const count = positions.length / 3;
  const chosen = new Uint32Array(count);
  const place = (value) => (Math.floor(value / cell) + CELLS / 2) % CELLS;
  for (let i = 0; i < count; ++i) {
    const [x, y, z] = [0, 1, 2].map((k) => place(positions[3 * i + k]));
    // Two numbers name a cell; a third of 20 bits does not fit into a whole number.
    const plane = first.get(z) ?? new Map();
    first.set(z, plane);
    const key = x * CELLS + y;
    if (!plane.has(key)) plane.set(key, i);
    chosen[i] = plane.get(key);
  }
  return chosen;
}

/// Triangles between the vertices that stand for those of each cell; those that shrink to a line go.
/// Vertices move by less than the diagonal of a cell.
export function coarseTriangles(positions, triangles, cell) {
  const chosen = representatives(positions, cell);
  const kept = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => chosen[triangles[t + k]]);
    if (a !== b && b !== c && c !== a) kept.push(a, b, c);
  }
  return Uint32Array.from(kept);
}

/// A geometry over the same vertices, about a fifth of the triangles; the geometry itself where it has few or
/// sharp edges.
export function coarseOf(geometry) {
  const { index, attributes } = geometry;
  if (!index || index.count < 3 * FEW) return geometry;
  const positions = attributes.position.array;
  const cell = WIDTH * meanEdge(positions, index.array);
  const coarse = new BufferGeometry();
  for (const [name, attribute] of Object.entries(attributes)) coarse.setAttribute(name, attribute);
  coarse.setIndex(new BufferAttribute(coarseTriangles(positions, index.array, cell), 1));
  geometry.addEventListener("dispose", () => coarse.dispose());
  return coarse;
}
