// Tendons of a digit: posture, tensions, excitations, and moment arms over a joint.

import { el } from "../../report/dom.js";
import { formatNumber } from "../../numbers/format.js";
import { QUANTITIES, quantityOf } from "../link/quantities.js";
import { rotated, steady } from "../link/directions.js";
import { latestWins, whenQuiet } from "../link/latest.js";
import { mergeJoints } from "../link/store.js";
import {
  backToWorld,
  facts,
  part,
  plainTable,
  refill,
  sliderRow,
  slowButton,
  warnings,
} from "./controls.js";
import { makeSweep } from "./tendon_sweep.js";

const MOST = 100; // end of a tension's slider where no largest force is known [N]
const ARM = 0.01; // about as large as moment arms of tendons [m]
const QUIET = 200; // after the last move the table is asked for [ms]

const most = (muscle) => muscle.max_force ?? muscle.strength ?? muscle.upper ?? MOST;

/// What the server says of the digit at rest, as terms; the force is turned from the subject's frame into
/// the picture's, whose axes the triad shows.
export function restFacts({ tip_force, rotation, torques, status, muscles = [] }) {
  const entries = [];
  // Forces are as large as tensions, torques as tensions by moment arms: less is rounding.
  const pull = Math.max(1, ...muscles.map(({ tension }) => tension ?? 0));
  if (tip_force) {
    const force = tip_force.map((v) => steady(v, pull));
    const seen = rotated(force, rotation).map((v) => steady(v, pull));
    entries.push(["Tip force", `${formatNumber(Math.hypot(...force), 2)}\u202fN`]);
    entries.push(["along x, y, z", `${seen.map((v) => formatNumber(v, 2)).join(", ")} N`]);
  }
  for (const [name, torque] of Object.entries(torques ?? {}))
    entries.push([`Torque ${name}`, `${formatNumber(steady(torque, pull * ARM) * 1e3)} N mm`]);
  if (status) entries.push(["Status", String(status)]);
  return entries;
}

/// Rows that set joints, tensions and excitations; `change(what, name, value)` hears of them.
function inputRows(joints, muscles, change) {
  const row = (what, name, lower, upper, quantity) => ({
    name,
    row: sliderRow({ name, lower, upper, quantity }, (value) => change(what, name, value)),
  });
  return {
    posture: joints.map((j) => row("posture", j.name, j.lower, j.upper, quantityOf(j))),
    tensions: muscles.map((m) => row("tensions", m.name, 0, most(m), QUANTITIES.force)),
    excitations: muscles.map((m) => row("excitations", m.name, 0, 1, QUANTITIES.share)),
  };
}

/// The sliders: { elements, build(joints, muscles), show(muscles), follow(valueOf) }.
function makeInputs(change) {
  const boxes = { posture: el("div", {}), tensions: el("div", {}), excitations: el("div", {}) };
  let rows = { posture: [], tensions: [], excitations: [] };
  const build = (joints, muscles) => {
    rows = inputRows(joints, muscles, change);
    for (const [what, box] of Object.entries(boxes))
      box.replaceChildren(...rows[what].map(({ row }) => row));
  };
  const show = (muscles) => {
    rows.tensions.forEach(({ row }, i) => row.set(muscles[i]?.tension));
    rows.excitations.forEach(({ row }, i) => row.set(muscles[i]?.excitation ?? row.value()));
  };
  const follow = (valueOf) => rows.posture.forEach(({ name, row }) => row.set(valueOf(name)));
  const elements = [
    part("Posture", boxes.posture),
    part("Tensions", boxes.tensions),
    part("Excitations", boxes.excitations),
  ];
  return { elements, build, show, follow };
}

/// What the server says of the digit: { element, show(state) }.
function makeRest() {
  const head = ["muscle", "tension [N]", "longer than at 0\u00b0 [mm]"];
  const numbers = plainTable(head, [], "Tensions");
  const bands = plainTable(["band", "tension [N]", ""], [], "Bands");
  const tip = el("div", {});
  const show = (state) => {
    refill(
      numbers.querySelector("tbody"),
      (state.muscles ?? []).map((m) => [
        m.name,
        formatNumber(m.tension, 2),
        formatNumber(m.length * 1e3, 2),
      ]),
    );
    const net = state.bands ?? [];
    bands.hidden = net.length === 0;
    refill(
      bands.querySelector("tbody"),
      net.map((b) => [b.name, formatNumber(b.tension, 2), b.slack ? "slack" : ""]),
    );
    tip.replaceChildren(facts(restFacts(state)), ...warnings(state.warnings));
  };
  return { element: part("At rest", tip, numbers, bands), show };
}

export function makeTendonPanel(app) {
  const { store } = app;
  const set = latestWins(async ({ method, params }) => {
    const next = await app.ask(method, params);
    if (next) take(next);
  }, mergeJoints);
  const inputs = makeInputs((what, name, value) =>
    set({ method: "tendons.set", params: { [what]: { [name]: value } } }),
  );
  const rest = makeRest();
  const sweep = makeSweep(app);
  const hint = el("div", { class: "hint" }, "No digit with tendons is shown.");
  const open = el(
    "div",
    { class: "buttons" },
    slowButton("Open a digit\u2026", () => app.openDialog("subjects")),
    backToWorld(app),
  );
  const body = el("div", { class: "parts" }, ...inputs.elements, rest.element, sweep.element);
  const panel = el("div", { class: "page tendons" }, hint, open, body);

  const here = () => store.scene?.mode === "tendons";
  function take(next) {
    const muscles = next.muscles ?? [];
    const { joints } = store.scene;
    const key = JSON.stringify([next.subject, next.digit, muscles.map((m) => m.name), joints]);
    if (panel.dataset.key !== key) {
      const leading = joints.filter((joint) => !joint.led_by);
      inputs.build(leading, muscles);
      sweep.offer(leading);
      sweep.clear();
    }
    panel.dataset.key = key;
    inputs.show(muscles);
    rest.show(next);
  }
  const refresh = whenQuiet(async () => {
    if (panel.hidden || !here() || !app.link.connected()) return;
    const next = await app.ask("tendons.state");
    if (next) take(next);
  }, QUIET);
  const changeMode = () => {
    body.hidden = !here();
    hint.hidden = here();
    if (here()) refresh();
  };
  store.on(["scene", "tab"], changeMode);
  store.on(["frame"], () => {
    if (here() && store.frame) {
      const valueOf = (name) =>
        store.frame.joints[store.scene.joints.findIndex((joint) => joint.name === name)];
      inputs.follow(valueOf);
      sweep.follow(valueOf);
    }
    if (!panel.hidden) refresh();
  });
  changeMode();
  return panel;
}
