// A disc about the axis of a joint, or an arrow along one that slides: dragged, it moves the joint. The
// ends of its arc are the joint's limits, its needle goes with the body.

import {
  BoxGeometry,
  ConeGeometry,
  CylinderGeometry,
  DoubleSide,
  Group,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  RingGeometry,
  TorusGeometry,
  Vector3,
} from "three";
import { clamped } from "../link/quantities.js";
import { across, follow } from "../link/turning.js";

const RADIUS = 84; // of the disc on the screen [px]
const COLORS = { range: "#0072b2", end: "#d55e00", needle: "#e69f00" };
const FULL = 2 * Math.PI;

const paint = (color, opacity = 1) =>
  new MeshBasicMaterial({
    ...{ color, opacity, transparent: true, depthTest: false, depthWrite: false, side: DoubleSide },
  });

function part(geometry, material, order = 10) {
  const mesh = new Mesh(geometry, material);
  mesh.renderOrder = order;
  return mesh;
}

/// A short bar across the rim at an angle.
function endMark(angle) {
  const mark = part(new BoxGeometry(0.3, 0.05, 0.02), paint(COLORS.end), 12);
  mark.position.set(0.95 * Math.cos(angle), 0.95 * Math.sin(angle), 0);
  mark.rotation.z = angle;
  return mark;
}

/// The disc of unit radius about z; what belongs to the limits turns back as the joint turns.
function disc({ lower, upper }) {
  const group = new Group();
  const range = new Group();
  const width = Math.min(FULL, upper - lower);
  range.add(part(new RingGeometry(0.82, 1, 64, 1, lower, width), paint(COLORS.range, 0.55)));
  range.add(part(new RingGeometry(0, 0.82, 64, 1, lower, width), paint(COLORS.range, 0.12)));
  if (width < FULL) range.add(endMark(lower), endMark(upper));
  group.add(part(new RingGeometry(0.9, 0.92, 64), paint(COLORS.range, 0.5)));
  const needle = part(new BoxGeometry(1.1, 0.06, 0.02), paint(COLORS.needle), 13);
  needle.position.x = 0.55;
  const grip = new Mesh(new TorusGeometry(0.91, 0.16, 8, 48));
  grip.visible = false;
  group.add(range, needle, grip);
  return { group, grip, turn: (value) => (range.rotation.z = -value) };
}

/// An arrow of unit length both ways along z; the bar of the range is in metres.
function slider({ lower, upper }) {
  const group = new Group();
  const range = new Group();
  const bar = part(new BoxGeometry(0.08, 0.08, 1), paint(COLORS.range, 0.55));
  range.add(bar);
  const heads = [1, -1].map((side) => {
    const head = part(new ConeGeometry(0.16, 0.36, 16), paint(COLORS.needle), 13);
    head.rotation.x = (side * Math.PI) / 2;
    head.position.z = 0.9 * side;
    return head;
  });
  const shaft = part(new CylinderGeometry(0.04, 0.04, 1.6, 8), paint(COLORS.needle), 13);
  shaft.rotation.x = Math.PI / 2;
  const grip = new Mesh(new CylinderGeometry(0.22, 0.22, 2.2, 8).rotateX(Math.PI / 2));
  grip.visible = false;
  group.add(range, shaft, ...heads, grip);
  const turn = (value, radius) => {
    bar.scale.z = (upper - lower) / radius;
    bar.position.z = ((upper + lower) / 2 - value) / radius;
  };
  return { group, grip, turn };
}

/// The joint's frame in the world: its point, z along the axis, x with the body.
function frameOf(joint, body) {
  const axis = new Vector3(...joint.axis).normalize();
  const mesh = body.userData.mesh;
  const middle = mesh ? mesh.geometry.boundingSphere.center.toArray() : [0, 0, 0];
  const wish = middle.map((m, i) => m - joint.point[i]);
  const x = new Vector3(...across(joint.axis, wish));
  const local = new Matrix4().makeBasis(x, new Vector3().crossVectors(axis, x), axis);
  local.setPosition(...joint.point);
  return local.premultiply(body.matrixWorld);
}

/// The handle of the joint that is selected; `move(joint, value)` is asked for a value within the limits.
export function makeJointHandle(stage, move) {
  let held = null; // { joint, body, shape, value, radius }

  function place() {
    if (!held) return;
    const { joint, body, shape } = held;
    if (body.userData.mesh)
      body.userData.mesh.geometry.boundingSphere ??
        body.userData.mesh.geometry.computeBoundingSphere();
    const { camera, width } = stage;
    held.radius = (RADIUS * (camera.right - camera.left)) / (width * camera.zoom);
    const at = new Vector3();
    const turn = new Quaternion();
    frameOf(joint, body).decompose(at, turn, new Vector3());
    shape.group.position.copy(at);
    shape.group.quaternion.copy(turn);
    shape.group.scale.setScalar(held.radius);
    shape.turn(held.value, held.radius);
    shape.group.updateMatrixWorld();
  }
  stage.preparing.push(place);

  function show(joint, body, value) {
    if (held) held.shape.group.removeFromParent();
    held = joint
      ? { joint, body, value, shape: joint.slides ? slider(joint) : disc(joint), radius: 1 }
      : null;
    if (held) stage.scene.add(held.shape.group);
    if (held) place();
    stage.draw();
  }

  /// A ray of three.js's raycaster as turning.js takes it.
  const rayOf = ({ ray }) => ({ from: ray.origin.toArray(), way: ray.direction.toArray() });

  /// Begins a drag if the raycaster hits the handle; returns a function of later raycasters, or null.
  function grab(raycaster) {
    if (!held || raycaster.intersectObject(held.shape.grip).length === 0) return null;
    const { joint, body, value, radius } = held;
    const frame = frameOf(joint, body);
    const axis = new Vector3().setFromMatrixColumn(frame, 2).normalize().toArray();
    const point = new Vector3().setFromMatrixPosition(frame).toArray();
    const turned = follow({ axis, point, slides: joint.slides }, rayOf(raycaster), radius);
    return (next) => move(joint, clamped(value + turned(rayOf(next)), joint.lower, joint.upper));
  }

  /// Points of the rim in the world, at angles from the needle: where a pointer can take hold.
  const rim = (angle) => {
    const local = held.joint.slides
      ? new Vector3(0, 0, 0.9 + angle)
      : new Vector3(0.91 * Math.cos(angle), 0.91 * Math.sin(angle), 0);
    return local.applyMatrix4(held.shape.group.matrixWorld);
  };

  const tell = (value) => {
    if (held) held.value = value;
  };
  return { show, tell, grab, rim, held: () => held };
}
