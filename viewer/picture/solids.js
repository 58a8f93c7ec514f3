// Segments of a digit as capsules, points as small spheres, friction as cones.

import {
  CapsuleGeometry,
  ConeGeometry,
  DoubleSide,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  SphereGeometry,
  Vector3,
} from "three";

const Y = new Vector3(0, 1, 0);

/// Lays a mesh that was made along y from `a` to `b`.
export function lay(mesh, a, b) {
  mesh.position.copy(a).add(b).multiplyScalar(0.5);
  mesh.quaternion.setFromUnitVectors(Y, b.clone().sub(a).normalize());
  return mesh;
}

export function buildSegment({ a, b, radius }, { material, size }) {
  const start = new Vector3(...a);
  const end = new Vector3(...b);
  const mesh = new Mesh(
    new CapsuleGeometry(radius ?? 0.02 * size, start.distanceTo(end), 8, 20),
    material,
  );
  lay(mesh, start, end);
  mesh.userData.labelAt = mesh.position.clone();
  return mesh;
}

export function buildPoints({ positions, radius }, { material, size }) {
  const mesh = new InstancedMesh(
    new SphereGeometry(radius ?? 0.008 * size, 12, 8),
    material,
    positions.length,
  );
  positions.forEach((p, i) => mesh.setMatrixAt(i, new Matrix4().makeTranslation(...p)));
  mesh.userData.labelAt = new Vector3(...(positions[0] ?? [0, 0, 0]));
  return mesh;
}

const CONE_OPACITY = 0.5;

/// A cone from its tip along `axis`, which is as long as it is high.
export function buildCone({ tip, axis, radius }, { color }) {
  const point = new Vector3(...tip);
  const base = point.clone().add(new Vector3(...axis));
  const material = new MeshLambertMaterial({
    color,
    transparent: true,
    opacity: CONE_OPACITY,
    side: DoubleSide,
    depthWrite: false,
  });
  const height = point.distanceTo(base);
  const mesh = lay(new Mesh(new ConeGeometry(radius, height, 28, 1, true), material), base, point);
  mesh.userData.labelAt = point;
  return mesh;
}
