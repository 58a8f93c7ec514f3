// Keys of the whole page and of the picture; panels/dialogs.js tells them to readers.

import { Vector3 } from "three";
import { turnByKeys } from "../picture/controls.js";
import { clamped, quantityOf } from "./link/quantities.js";
import { ownersOf } from "./link/store.js";

const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
const ARROWS = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -10, ArrowUp: 10 }; // steps
const MOVE = 1e-3; // [m]
const TURN = Math.PI / 180; // [rad]
const TABS = ["pose", "grasp", "tendons", "fit", "time"];

/// Returns true if the focused element uses a key itself: text input, slider, choice.
const typing = ({ target }) =>
  target.matches?.("input, select, textarea") || document.querySelector("dialog[open]");

const plain = ({ ctrlKey, altKey, metaKey }) => !ctrlKey && !altKey && !metaKey;

/// Keys that work independently of the focus.
export function pageKeys(app) {
  const click = (id) => document.getElementById(id)?.click();
  const withControl = {
    z: (event) => click(event.shiftKey ? "redo" : "undo"),
    y: () => click("redo"),
    o: () => click("open"),
    s: () => click("save"),
  };
  const alone = {
    "?": () => app.help(),
    Escape: () => app.select(null),
    g: () => click("do-grasp"),
    o: () => click("do-open"),
    c: () => click("do-close"),
    ".": () => app.stepTime(1),
  };
  TABS.forEach((tab, i) => (alone[i + 1] = () => app.tabs.choose(tab)));
  addEventListener("keydown", (event) => {
    if (typing(event)) return;
    const controlled = (event.ctrlKey || event.metaKey) && !event.altKey;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const work = controlled ? withControl[key] : plain(event) ? alone[key] : null;
    if (work) {
      event.preventDefault();
      return work(event);
    }
    if (event.key === " " && !event.target.matches("button, summary, a")) {
      event.preventDefault();
      app.togglePlay();
    }
  });
}

/// The next thing of the world before or after the one that is selected.
function otherOwner(app, by) {
  const owners = ownersOf(app.store.scene ?? { bodies: [] });
  if (!owners.length) return;
  const at = owners.findIndex(({ name }) => name === app.store.selected?.owner);
  const next =
    at < 0 ? (by > 0 ? 0 : owners.length - 1) : (at + by + owners.length) % owners.length;
  app.select({ owner: owners[next].name });
}

/// The next joint of the hand that can be moved by itself.
function otherJoint(app, by) {
  const { scene, selected } = app.store;
  const hand = selected?.owner ?? scene?.joints[0]?.hand;
  const joints = (scene?.joints ?? []).filter((one) => one.hand === hand && !one.led_by);
  if (!joints.length) return;
  const at = joints.findIndex(({ name }) => name === selected?.joint);
  const next =
    at < 0 ? (by > 0 ? 0 : joints.length - 1) : (at + by + joints.length) % joints.length;
  app.select({ owner: hand, joint: joints[next].name });
}

/// Turns the joint that is selected by steps of 1 degree or 1 mm.
function stepJoint(app, steps) {
  const { scene, frame, selected } = app.store;
  const index = scene.joints.findIndex(
    (j) => j.hand === selected.owner && j.name === selected.joint,
  );
  const joint = scene.joints[index];
  if (!joint || !frame) return;
  const from = app.wanted?.joint === joint ? app.wanted.value : frame.joints[index];
  const { scale } = quantityOf(joint);
  app.moveJoint(joint, clamped(from + steps * scale, joint.lower, joint.upper));
}

/// Keys of the picture, while it has the focus.
export function pictureKeys(app) {
  const { stage, place } = app.picture;
  const choice = { axis: "x", turns: false };
  const tell = () =>
    app.notices.say(`arrow keys ${choice.turns ? "turn about" : "move along"} ${choice.axis}`);
  const nudge = (steps) => {
    const axis = AXES[choice.axis];
    const pose = choice.turns
      ? place.nudge({ about: axis, angle: steps * TURN })
      : place.nudge({ by: new Vector3(...axis).multiplyScalar(steps * MOVE).toArray() });
    if (!pose) return;
    stage.draw();
    const at = pose.position.map((v) => (v * 1e3).toFixed(1)).join(", ");
    app.notices.say(`${app.store.selected.owner} at ${at} mm`);
  };
  const choose = (change) => () => {
    Object.assign(choice, change);
    tell();
  };
  const keys = {
    x: choose({ axis: "x" }),
    y: choose({ axis: "y" }),
    z: choose({ axis: "z" }),
    t: choose({ turns: false }),
    r: choose({ turns: true }),
    PageDown: () => otherOwner(app, 1),
    PageUp: () => otherOwner(app, -1),
    "]": () => otherJoint(app, 1),
    "[": () => otherJoint(app, -1),
  };
  const ofJoint = { "+": 1, "=": 1, "-": -1, _: -1, "*": 10 };
  stage.canvas.addEventListener(
    "keydown",
    (event) => {
      if (!plain(event)) return;
      const { selected } = app.store;
      const take = (work) => {
        event.preventDefault();
        event.stopImmediatePropagation();
        work();
      };
      if (Object.hasOwn(keys, event.key)) return take(keys[event.key]);
      if (selected?.joint) {
        const steps = ofJoint[event.key] ?? ARROWS[event.key];
        if (steps)
          take(() => stepJoint(app, steps * (event.shiftKey && steps ** 2 === 1 ? 10 : 1)));
      } else if (place.shown() && ARROWS[event.key]) take(() => nudge(ARROWS[event.key]));
    },
    { capture: true },
  );
  turnByKeys(stage.controls, stage.canvas, () => app.view.fit());
}
