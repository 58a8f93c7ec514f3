// Marching squares: where a grid is higher than a level.

// Of a cell, by which corners are inside (1, 2, 4, 8 anticlockwise from the lower left): edges from
// and to which its border runs, the inside at its left. Edges: below 0, right 1, above 2, left 3.
const RUNS = {
  1: [[0, 3]],
  2: [[1, 0]],
  3: [[1, 3]],
  4: [[2, 1]],
  5: [
    [0, 3],
    [2, 1],
  ],
  6: [[2, 0]],
  7: [[2, 3]],
  8: [[3, 2]],
  9: [[0, 2]],
  10: [
    [1, 0],
    [3, 2],
  ],
  11: [[1, 2]],
  12: [[3, 1]],
  13: [[0, 1]],
  14: [[3, 0]],
};

const CORNERS = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
];
const EDGES = [
  [0, 1],
  [1, 2],
  [3, 2],
  [0, 3],
]; // corners at the ends of each edge, always in the same sense

/// Height at a node; nothing beyond the grid.
const heightOf = ({ cells, side }, i, j) =>
  i < 0 || j < 0 || i >= side || j >= side ? 0 : cells[j * side + i];

/// Where the level crosses an edge of the cell (i, j), and a name of that edge, the same in both
/// cells that share it.
function crossing(grid, level, i, j, edge) {
  const [p, q] = EDGES[edge].map((c) => [i + CORNERS[c][0], j + CORNERS[c][1]]);
  const [a, b] = [heightOf(grid, ...p), heightOf(grid, ...q)];
  const share = (level - a) / (b - a);
  return {
    name: `${p}:${q}`,
    point: [0, 1].map((k) => grid.low[k] + grid.step[k] * (p[k] + share * (q[k] - p[k]))),
  };
}

function runs(grid, level) {
  const next = new Map();
  for (let j = -1; j < grid.side; ++j)
    for (let i = -1; i < grid.side; ++i) {
      const inside = CORNERS.reduce(
        (bits, [a, b], k) => bits | (heightOf(grid, i + a, j + b) >= level ? 1 << k : 0),
        0,
      );
      for (const [from, to] of RUNS[inside] ?? []) {
        const start = crossing(grid, level, i, j, from);
        next.set(start.name, { point: start.point, to: crossing(grid, level, i, j, to).name });
      }
    }
  return next;
}

/// Closed rings around all places at least as high as `level` (> 0), outer ones anticlockwise and
/// holes clockwise. `grid` has `cells` row by row, `side` nodes a row, the place `low` of its first
/// node, and a `step` in both directions.
export function regionOf(grid, level) {
  const next = runs(grid, level);
  const rings = [];
  while (next.size) {
    const ring = [];
    let [name] = next.keys();
    while (next.has(name)) {
      const { point, to } = next.get(name);
      next.delete(name);
      ring.push(point);
      name = to;
    }
    rings.push(ring);
  }
  return rings;
}
