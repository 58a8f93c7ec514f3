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
    const x = positions[a] - positions[b];
    const y = positions[a + 1] - positions[b + 1];
    const z = positions[a + 2] - positions[b + 2];
    sum += Math.sqrt(x * x + y * y + z * z);
  }
  return sum / Math.max(1, triangles.length / 3);
}

/// The vertex that stands for each: the first that was met in the cell of a grid of this width.
function representatives(positions, cell) {
  const count = positions.length / 3;
  const cells = new Int32Array(positions.length);
  for (let i = 0; i < positions.length; ++i)
    cells[i] = (Math.floor(positions[i] / cell) + CELLS / 2) % CELLS;
  // A table of vertices by their cells, twice as large as need be; a place that is taken leads to the next.
  const places = 2 ** Math.ceil(Math.log2(2 * count + 1));
  const table = new Int32Array(places).fill(-1);
  const chosen = new Uint32Array(count);
  for (let i = 0; i < count; ++i) {
    const [x, y, z] = [cells[3 * i], cells[3 * i + 1], cells[3 * i + 2]];
    const hash = Math.imul(x, 73856093) ^ Math.imul(y, 19349663) ^ Math.imul(z, 83492791);
    let at = (hash ^ (hash >>> 15)) & (places - 1);
    let there = table[at];
    while (
      there >= 0 &&
      (cells[3 * there] !== x || cells[3 * there + 1] !== y || cells[3 * there + 2] !== z)
    ) {
      at = (at + 1) & (places - 1);
      there = table[at];
    }
    if (there < 0) table[at] = there = i;
    chosen[i] = there;
  }
  return chosen;
}

/// Triangles between the vertices that stand for those of each cell; those that shrink to a line go.
/// Vertices move by less than the diagonal of a cell.
export function coarseTriangles(positions, triangles, cell) {
  const chosen = representatives(positions, cell);
  const kept = [];
  for (let t = 0; t < triangles.length; t += 3) {
    const a = chosen[triangles[t]];
    const b = chosen[triangles[t + 1]];
    const c = chosen[triangles[t + 2]];
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
  coarse.boundingBox = geometry.boundingBox;
  coarse.boundingSphere = geometry.boundingSphere;
  geometry.addEventListener("dispose", () => coarse.dispose());
  return coarse;
}
