// Joint axes and force arrows: a shaft and a head.

import { ConeGeometry, CylinderGeometry, Group, Mesh, Vector3 } from "three";
import { lay } from "./solids.js";

/// A shaft from `from` to `to` whose last part is a head; radius and head length in scene units.
function shaftAndHead(from, to, radius, headLength, material) {
  const direction = to.clone().sub(from);
  const length = direction.length();
  const group = new Group();
  if (length === 0) return group;
  const head = Math.min(headLength, 0.5 * length);
  const neck = to.clone().addScaledVector(direction, -head / length);
  group.add(
    lay(new Mesh(new CylinderGeometry(radius, radius, length - head, 12), material), from, neck),
  );
  group.add(lay(new Mesh(new ConeGeometry(2.6 * radius, head, 16), material), neck, to));
  return group;
}

/// A force, or any vector in scene units.
export function buildArrow({ from, vector, radius }, { material, size }) {
  const start = new Vector3(...from);
  const end = start.clone().add(new Vector3(...vector));
  const group = shaftAndHead(start, end, radius ?? 0.005 * size, 0.035 * size, material);
  group.userData.labelAt = end;
  return group;
}

/// A joint axis, its point in the middle; the head shows the direction of positive rotation by the
/// right hand.
export function buildAxis({ point, direction, length }, { material, size }) {
  const half = new Vector3(...direction).normalize().multiplyScalar((length ?? 0.2 * size) / 2);
  const middle = new Vector3(...point);
  const end = middle.clone().add(half);
  const group = shaftAndHead(middle.clone().sub(half), end, 0.0035 * size, 0.025 * size, material);
  group.userData.labelAt = end;
  return group;
}
