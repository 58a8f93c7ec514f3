// Wrench sets as small 3D views side by side: within friction, and within the limits of the motors.

import { el } from "../../report/dom.js";
import { themeColor } from "../../report/theme.js";
import { mountScene } from "../../picture/view.js";
import { choice, part, slowButton } from "./controls.js";

const NAMES = ["Fx", "Fy", "Fz", "Tx", "Ty", "Tz"]; // torques over the object's reach
const SETS = {
  "force, no torque": { axes: [0, 1, 2], kind: "slice" },
  "torque, no force": { axes: [3, 4, 5], kind: "slice" },
  "force, any torque": { axes: [0, 1, 2], kind: "projection" },
  "torque, any force": { axes: [3, 4, 5], kind: "projection" },
  "three axes": null,
};
const SIDES = [
  { limits: "geometric", title: "Contacts alone", color: "#0072b2" },
  {
    ...{ limits: "actuated", title: "With the hand's limits", color: "#d55e00" },
    note: "Efforts limit what the hand presses, but not what palm, joint limits and drives that cannot be driven back bear: their strength is unknown, so that sets may be far larger than any hand is.",
  },
];
const AXIS = "#8a8f99";

/// Arrows along the axes of a set, a little longer than the set is large.
function axesItems(vertices, axes) {
  const reach = (i) => Math.max(1e-9, ...vertices.map((v) => Math.abs(v[i])));
  const longest = Math.max(reach(0), reach(1), reach(2));
  return axes.map((axis, i) => {
    const vector = [0, 0, 0];
    vector[i] = 1.15 * Math.max(reach(i), 0.25 * longest);
    return { kind: "arrow", from: [0, 0, 0], vector, label: NAMES[axis], color: AXIS };
  });
}

function draw(side, set, axes, group) {
  const frame = el("div", { class: "scene small" });
  frame.dataset.label = `${side.title}: set of wrenches`;
  const flat = set.vertices.length < 4;
  const words = "The set has no volume along these axes.";
  const open = set.failed ? `; ${set.failed} directions have no bound` : "";
  const caption = el("figcaption", {}, `${side.title} [${set.unit}]${open}`);
  if (!flat) {
    const hull = { kind: "hull", vertices: set.vertices, faces: set.triangles };
    const layers = [
      { name: "set", color: side.color, items: [hull] },
      { name: "axes", color: AXIS, items: axesItems(set.vertices, axes) },
    ];
    const spec = { layers, compact: true, unit: set.unit.split(" ")[0], link: group };
    // The frame needs its size before the scene is mounted.
    requestAnimationFrame(() =>
      mountScene(frame, spec, () => ({ ink: themeColor("--ink"), page: themeColor("--page") })),
    );
  } else frame.append(el("p", { class: "hint" }, words));
  const note = side.note ? el("p", { class: "hint beside" }, side.note) : null;
  return el("figure", { class: "wrenches" }, frame, caption, note);
}

let groups = 0;

/// The part of the grasp panel that shows sets of wrenches; `grasp()` names hand and object.
export function makeWrenchView(app, grasp) {
  const views = el("div", { class: "pair" });
  const axes = [0, 1, 2].map((i) => {
    const one = choice(`Axis ${i + 1}`, () => {});
    one.set(
      NAMES.map((text, value) => ({ value: String(value), text })),
      String(i),
    );
    return one;
  });
  const freely = el("div", { class: "axes", hidden: true }, ...axes);
  const kind = choice("Set", (name) => (freely.hidden = SETS[name] !== null));
  kind.set(Object.keys(SETS), "force, no torque");
  const chosen = () =>
    SETS[kind.value()] ?? { axes: axes.map((one) => Number(one.value())), kind: "projection" };
  const show = async () => {
    const what = chosen();
    if (new Set(what.axes).size < 3) return app.notices.error("Choose three different axes.");
    const group = `wrenches ${++groups}`;
    const drawn = [];
    for (const side of SIDES) {
      const params = { ...grasp(), ...what, limits: side.limits };
      const set = await app.ask("grasp.wrench_set", params);
      if (!set) return;
      drawn.push(draw(side, set, what.axes, group));
    }
    views.replaceChildren(...drawn);
  };
  return part(
    "Wrench space",
    kind,
    freely,
    el("div", { class: "buttons" }, slowButton("Show", show, { id: "show-wrenches" })),
    views,
  );
}
