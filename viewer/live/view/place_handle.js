// Arrows that move and discs that turn what is selected.

import { Matrix4, Object3D, Quaternion, Vector3 } from "three";
import { TransformControls } from "three/addons/controls/TransformControls.js";

const COLORS = ["#d55e00", "#009e73", "#0072b2", "#e69f00"]; // of x, y, z as in the triad; of what is held
const SPARE = ["E", "XYZE", "XYZ", "XY", "YZ", "XZ"]; // handles of three.js beyond arrows and discs
const STEPS = { move: 0.01, turn: Math.PI / 12 }; // with Shift [m], [rad]

/// Pose { position: [3], rotation: [w, x, y, z] } of an object.
const poseOf = ({ position, quaternion: { x, y, z, w } }) => ({
  position: position.toArray(),
  rotation: [w, x, y, z],
});

function setPose(object, { position, rotation: [w, x, y, z] }) {
  object.position.set(...position);
  object.quaternion.set(x, y, z, w).normalize();
  object.updateMatrixWorld();
}

/// Arrows or discs of a size; moved() hears of every drag.
function makeControls(stage, mode, size, moved) {
  const controls = new TransformControls(stage.camera, stage.canvas);
  controls.setMode(mode);
  controls.setSpace(mode === "rotate" ? "local" : "world");
  controls.setSize(size);
  controls.addEventListener("change", stage.draw);
  controls.addEventListener("dragging-changed", ({ value }) => {
    stage.controls.enabled = !value;
  });
  controls.addEventListener("objectChange", moved);
  controls.setColors(...COLORS);
  const spare = [];
  controls.getHelper().traverse((part) => SPARE.includes(part.name) && spare.push(part));
  for (const part of spare) part.removeFromParent();
  stage.scene.add(controls.getHelper());
  return controls;
}

/// Handles of stage.scene. show(pose, body) puts them at a pose that goes with a body, hide() away;
/// `move(pose)` is asked for where it is dragged.
export function makePlaceHandle(stage, move) {
  const proxy = new Object3D();
  stage.scene.add(proxy);
  let body = null;
  let relative = new Matrix4(); // from the body to what is placed
  const moved = () => move(poseOf(proxy));
  const both = []; // arrows and discs, once something is to be moved
  const make = () => {
    const arrows = makeControls(stage, "translate", 0.75, moved);
    const discs = makeControls(stage, "rotate", 0.95, moved);
    // Arrows stand before discs: where the pointer is on one, no disc is taken.
    arrows.addEventListener("axis-changed", ({ value }) => {
      if (!arrows.dragging) discs.enabled = body !== null && value === null;
    });
    both.push(arrows, discs);
  };
  const snap = (on) => {
    both[0]?.setTranslationSnap(on ? STEPS.move : null);
    both[1]?.setRotationSnap(on ? STEPS.turn : null);
  };
  for (const kind of ["keydown", "keyup"])
    addEventListener(kind, ({ key }) => key === "Shift" && snap(kind === "keydown"));

  const dragging = () => both.some((controls) => controls.dragging);
  const hide = () => {
    body = null;
    for (const controls of both) {
      controls.detach();
      controls.enabled = false;
    }
    stage.draw();
  };
  const show = (pose, carrier) => {
    if (both.length === 0) make();
    body = carrier;
    setPose(proxy, pose);
    relative = body.matrixWorld.clone().invert().multiply(proxy.matrixWorld);
    for (const controls of both) {
      controls.enabled = true;
      controls.attach(proxy);
    }
    stage.draw();
  };
  /// Goes with its body when the server moves that.
  const goAlong = () => {
    if (!body || dragging()) return;
    const at = body.matrixWorld.clone().multiply(relative);
    at.decompose(proxy.position, proxy.quaternion, new Vector3());
  };
  /// Moves by an offset in the world [m], or turns about a world axis [rad].
  const nudge = ({ by, about, angle }) => {
    if (!body) return null;
    if (by) proxy.position.add(new Vector3(...by));
    if (about)
      proxy.quaternion.premultiply(new Quaternion().setFromAxisAngle(new Vector3(...about), angle));
    proxy.updateMatrixWorld();
    const pose = poseOf(proxy);
    move(pose);
    return pose;
  };
  hide();
  const busy = () => both.some((controls) => controls.enabled && controls.axis !== null);
  return {
    show,
    hide,
    goAlong,
    nudge,
    busy,
    dragging,
    pose: () => poseOf(proxy),
    shown: () => body !== null,
  };
}
