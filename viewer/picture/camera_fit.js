// Where the camera stands. The projection is orthographic, so that one scale bar holds for the
// whole picture.

import { Box3, OrthographicCamera, Vector3 } from "three";

const MARGIN = 1.12;

/// A direction that shows three sides, for a given up.
export function slanted(up) {
  const side = Math.abs(up.x) < 0.9 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
  side.addScaledVector(up, -side.dot(up)).normalize();
  return new Vector3()
    .crossVectors(side, up)
    .multiplyScalar(1.0)
    .addScaledVector(side, 0.7)
    .addScaledVector(up, 0.6)
    .normalize();
}

export function makeCamera(up) {
  const camera = new OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
  camera.up.copy(up);
  return camera;
}

/// The eight corners of a box.
const corners = ({ min, max }) =>
  [0, 1, 2, 3, 4, 5, 6, 7].map(
    (i) => new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z),
  );

/// Half of the box's width and height as the camera sees them.
function seenHalfSize(camera, box, center) {
  const right = new Vector3();
  const up = new Vector3();
  camera.matrixWorld.extractBasis(right, up, new Vector3());
  const reach = (axis) =>
    Math.max(...corners(box).map((corner) => Math.abs(corner.sub(center).dot(axis))));
  return { x: reach(right), y: reach(up) };
}

/// Keeps the picture undistorted when the canvas changes its shape; `half` is half the smaller side
/// in scene units.
export function setAspect(camera, aspect) {
  const half = camera.userData.half ?? { x: 1, y: 1 };
  const y = Math.max(half.y, half.x / aspect);
  Object.assign(camera, { left: -y * aspect, right: y * aspect, top: y, bottom: -y });
  camera.updateProjectionMatrix();
}

/// Looks at the whole box from `direction` (from the box towards the camera); returns the point
/// looked at.
export function fitCamera(camera, box, aspect, direction) {
  const filled = box.isEmpty() ? new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1)) : box;
  const center = filled.getCenter(new Vector3());
  const radius = filled.getSize(new Vector3()).length() / 2 || 1;
  camera.position.copy(center).addScaledVector(direction ?? slanted(camera.up), 4 * radius);
  camera.near = 0.01 * radius;
  camera.far = 20 * radius;
  camera.zoom = 1;
  camera.lookAt(center);
  camera.updateMatrixWorld();
  const seen = seenHalfSize(camera, filled, center);
  camera.userData.half = { x: MARGIN * seen.x, y: MARGIN * seen.y };
  setAspect(camera, aspect);
  return center;
}
