// Normals and bounds of surfaces for three.js, in loops over plain arrays: a hand has 64,000 triangles.

import { Box3, BufferAttribute, BufferGeometry, Sphere, Vector3 } from "three";

/// Normals of corners: those of the triangles about each, weighted with their areas.
export function vertexNormals(positions, triangles) {
  const sums = new Float32Array(positions.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const [x, y, z] = [positions[b], positions[b + 1], positions[b + 2]];
    const [ux, uy, uz] = [positions[c] - x, positions[c + 1] - y, positions[c + 2] - z];
    const [vx, vy, vz] = [positions[a] - x, positions[a + 1] - y, positions[a + 2] - z];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const at of [a, b, c]) {
      sums[at] += nx;
      sums[at + 1] += ny;
      sums[at + 2] += nz;
    }
  }
  for (let i = 0; i < sums.length; i += 3) {
    const length = Math.hypot(sums[i], sums[i + 1], sums[i + 2]) || 1;
    sums[i] /= length;
    sums[i + 1] /= length;
    sums[i + 2] /= length;
  }
  return sums;
}

/// The box of points, and the ball about its middle that holds them.
export function boundsOf(positions) {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3)
    for (let k = 0; k < 3; ++k) {
      const value = positions[i + k];
      if (value < least[k]) least[k] = value;
      if (value > most[k]) most[k] = value;
    }
  const box = new Box3(new Vector3(...least), new Vector3(...most));
  const center = box.getCenter(new Vector3());
  let farthest = 0; // squared
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [
      positions[i] - center.x,
      positions[i + 1] - center.y,
      positions[i + 2] - center.z,
    ];
    farthest = Math.max(farthest, x * x + y * y + z * z);
  }
  return { box, ball: new Sphere(center, Math.sqrt(farthest)) };
}

/// A smooth surface, with normals and bounds.
export function smoothGeometry({ positions, triangles }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(vertexNormals(positions, triangles), 3));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  const { box, ball } = boundsOf(positions);
  geometry.boundingBox = box;
  geometry.boundingSphere = ball;
  return geometry;
}
