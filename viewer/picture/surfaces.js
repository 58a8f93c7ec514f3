// Hulls as transparent surfaces with their edges, and lines such as tendons.

import {
  BufferGeometry,
  DoubleSide,
  EdgesGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  Vector3,
} from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";

export const HULL_OPACITY = 0.35;
export const LINES_OPACITY = 0.15;
export const LINE_WIDTH = 2.5; // [px]

function hullGeometry(vertices, faces) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(vertices.flat(), 3));
  geometry.setIndex(faces.flat());
  const flat = geometry.toNonIndexed();
  flat.computeVertexNormals();
  return flat;
}

/// `userData.hull` marks the material whose opacity the reader may change.
export function buildHull({ vertices, faces }, { color }) {
  const geometry = hullGeometry(vertices, faces);
  const group = new Group();
  const material = new MeshLambertMaterial({
    color,
    transparent: true,
    opacity: HULL_OPACITY,
    side: DoubleSide,
    depthWrite: false,
  });
  group.add(
    new Mesh(geometry, material),
    new LineSegments(new EdgesGeometry(geometry, 5), new LineBasicMaterial({ color })),
  );
  group.children[0].userData.hull = true;
  geometry.computeBoundingSphere();
  group.userData.labelAt = geometry.boundingSphere?.center ?? new Vector3();
  return group;
}

/// A polyline of constant width on the screen.
export function buildLine({ positions, dashed = false, width = LINE_WIDTH }, { color, size }) {
  if (positions.length < 2) return new Group();
  const material = new LineMaterial({
    color,
    linewidth: width * (globalThis.devicePixelRatio ?? 1),
    dashed,
    dashSize: 0.015 * size,
    gapSize: 0.01 * size,
  });
  const line = new Line2(new LineGeometry().setPositions(positions.flat()), material);
  line.computeLineDistances();
  line.userData.labelAt = new Vector3(...positions[Math.floor(positions.length / 2)]);
  return line;
}

/// Many straight lines, from every first position to the next: translucent, so that where most of
/// them lie is darkest.
export function buildLines({ positions, opacity = LINES_OPACITY }, { color }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(positions.flat(), 3));
  const material = new LineBasicMaterial({ color, transparent: true, opacity, depthWrite: false });
  const lines = new LineSegments(geometry, material);
  lines.userData.labelAt = new Vector3(...(positions[0] ?? [0, 0, 0]));
  return lines;
}
