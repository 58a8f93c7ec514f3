// Smooth surfaces that tendons slide on, translucent, in their own frame.

import {
  CapsuleGeometry,
  CylinderGeometry,
  DoubleSide,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from "three";

const SURFACE_OPACITY = 0.3;
const TO_Z = Math.PI / 2; // cylinders and capsules are made along y

const GEOMETRY = {
  cylinder: ([radius, half]) =>
    new CylinderGeometry(radius, radius, 2 * half, 40, 1, true).rotateX(TO_Z),
  sphere: ([radius]) => new SphereGeometry(radius, 32, 20),
  ellipsoid: ([x, y, z]) => new SphereGeometry(1, 32, 20).scale(x, y, z),
  capsule: ([radius, half]) => new CapsuleGeometry(radius, 2 * half, 12, 32).rotateX(TO_Z),
  torus: ([tube, ring]) => new TorusGeometry(ring, tube, 16, 48),
};

export const SHAPES = Object.keys(GEOMETRY);

/// How far a surface reaches from its centre, at most.
export function shapeReach({ shape, size: [a, b = 0, c = 0] }) {
  if (shape === "cylinder") return Math.hypot(a, b);
  return shape === "ellipsoid" ? Math.max(a, b, c) : shape === "sphere" ? a : a + b;
}

/// `axes` are the x, y and z of the surface's frame. `userData.hull` marks the material whose
/// opacity the reader may change.
export function buildSurface({ shape, size, center, axes }, { color }) {
  const material = new MeshLambertMaterial({
    color,
    transparent: true,
    opacity: SURFACE_OPACITY,
    side: DoubleSide,
    depthWrite: false,
  });
  const mesh = new Mesh(GEOMETRY[shape](size), material);
  const [x, y, z] = axes.map((axis) => new Vector3(...axis));
  mesh.applyMatrix4(new Matrix4().makeBasis(x, y, z).setPosition(...center));
  mesh.userData.hull = true;
  mesh.userData.labelAt = new Vector3(...center);
  return mesh;
}
