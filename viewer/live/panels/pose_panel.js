// Joints of a hand, a digit or a scene as sliders.

import { el } from "../../report/dom.js";
import { jointsOf, leaderOf } from "../link/store.js";
import { quantityOf, told } from "../link/quantities.js";
import { choice, part, sliderRow } from "./controls.js";

/// The heading of a joint's rows: the part of its name before the last "/", else the digit that it moves.
export const groupOf = ({ name, body }, bodies) =>
  name.split(/[/.]/).slice(0, -1).join(" ") || bodies[body]?.digit || "";
const shortName = ({ name }) => name.split("/").at(-1);

/// Rows of joints, under headings where names have a first part.
function rowsOf(app, joints) {
  const rows = joints.map((joint) => {
    const row = sliderRow(
      {
        name: shortName(joint),
        title: joint.name,
        lower: joint.lower,
        upper: joint.upper,
        quantity: quantityOf(joint),
        note: joint.led_by ? `goes with ${joint.led_by}` : null,
        off: Boolean(joint.led_by) || !app.canMove(joint),
      },
      (value) => app.moveJoint(joint, value),
    );
    row.dataset.joint = joint.name;
    row.addEventListener("focusin", () => {
      if (!joint.led_by) app.select({ owner: joint.hand, joint: joint.name }, { quiet: true });
    });
    return { joint, row };
  });
  const groups = new Map();
  for (const { joint, row } of rows) {
    const group = groupOf(joint, app.store.scene.bodies);
    if (!groups.has(group)) groups.set(group, []);
    groups.get(group).push(row);
  }
  const elements = [...groups].map(([title, list]) =>
    title ? part(title, ...list) : el("div", {}, ...list),
  );
  return { rows, elements };
}

export function makePosePanel(app) {
  const { store } = app;
  const hands = choice("Hand", (hand) => app.select({ owner: hand }));
  const box = el("div", {});
  const where = el("p", { class: "where", "aria-live": "off" });
  const panel = el("div", { class: "page pose" }, hands, where, box);
  let rows = [];

  const hand = () => {
    const names = [...new Set(store.scene?.joints.map((joint) => joint.hand) ?? [])];
    const wanted = store.selected?.owner;
    return names.includes(wanted)
      ? wanted
      : names.includes(hands.value())
        ? hands.value()
        : names[0];
  };
  const build = () => {
    const names = [...new Set(store.scene?.joints.map((joint) => joint.hand) ?? [])];
    hands.hidden = names.length < 2;
    const chosen = hand();
    hands.set(names, chosen);
    const key = JSON.stringify([
      chosen,
      store.scene?.mode,
      store.scene && jointsOf(store.scene, chosen),
    ]);
    if (panel.dataset.key === key) return;
    panel.dataset.key = key;
    const made = rowsOf(app, chosen === undefined ? [] : jointsOf(store.scene, chosen));
    rows = made.rows;
    const none = el("p", { class: "hint" }, "There are no joints. Add a hand to pose it.");
    box.replaceChildren(...(rows.length ? made.elements : [none]));
    follow();
  };
  const follow = () => {
    if (!store.frame || panel.hidden) return;
    for (const { joint, row } of rows) row.set(store.frame.joints[joint.index]);
  };
  const mark = () => {
    for (const { joint, row } of rows)
      row.mark(store.selected?.joint === joint.name && store.selected.owner === joint.hand);
    build();
    place();
  };
  const place = () => {
    const at = app.poseOf(store.selected?.owner);
    where.hidden = !at;
    if (at)
      where.textContent = `${store.selected.owner} stands at ${at
        .map((v) => (v * 1e3).toFixed(1))
        .join(", ")} mm`;
  };
  store.on(["scene"], build);
  store.on(["frame", "tab"], () => {
    follow();
    place();
  });
  store.on(["selected"], mark);
  build();
  return panel;
}

/// What is said when a joint has moved.
export const jointWords = (scene, joint, value) =>
  `${joint.name} ${told(value, quantityOf(joint))}${leaderOf(scene, joint) === joint ? "" : " (led)"}`;
