// Tendons of a digit: posture, tensions, excitations, and moment arms over a joint.

import { el } from "../../report/dom.js";
import { formatNumber } from "../../numbers/format.js";
import { QUANTITIES, quantityOf } from "../link/quantities.js";
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
const QUIET = 200; // after the last move the table is asked for [ms]

const most = (muscle) => muscle.max_force ?? muscle.strength ?? muscle.upper ?? MOST;

/// What the server says of the digit at rest, as terms.
function restFacts({ tip_force: force, torques, status }) {
  const entries = [];
  if (force) {
    entries.push(["Tip force", `${formatNumber(Math.hypot(...force), 2)}\u202fN`]);
    entries.push(["along x, y, z", `${force.map((v) => formatNumber(v, 2)).join(", ")} N`]);
  }
  for (const [name, torque] of Object.entries(torques ?? {}))
    entries.push([`Torque ${name}`, `${formatNumber(torque * 1e3)} N mm`]);
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

export function makeTendonPanel(app) {
  const { store } = app;
  const hint = el("div", { class: "hint" });
  const posture = el("div", {});
  const tensions = el("div", {});
  const excitations = el("div", {});
  const numbers = plainTable(
    ["muscle", "tension [N]", "longer than at 0\u00b0 [mm]"],
    [],
    "Tensions",
  );
  const bands = plainTable(["band", "tension [N]", ""], [], "Bands");
  const tip = el("div", {});
  const sweep = makeSweep(app);
  let state = null;
  let rows = { posture: [], tensions: [], excitations: [] };

  const set = latestWins(async ({ method, params }) => {
    const next = await app.ask(method, params);
    if (next) take(next);
  }, mergeJoints);
  const change = (what, name, value) =>
    set({ method: "tendons.set", params: { [what]: { [name]: value } } });

  function build() {
    const joints = store.scene.joints.filter((joint) => !joint.led_by);
    const muscles = state.muscles ?? [];
    rows = inputRows(joints, muscles, change);
    posture.replaceChildren(...rows.posture.map(({ row: one }) => one));
    tensions.replaceChildren(...rows.tensions.map(({ row: one }) => one));
    excitations.replaceChildren(...rows.excitations.map(({ row: one }) => one));
    sweep.offer(joints);
    sweep.clear();
  }

  function show() {
    const muscles = state.muscles ?? [];
    rows.tensions.forEach(({ row }, i) => row.set(muscles[i]?.tension));
    rows.excitations.forEach(({ row }, i) => row.set(muscles[i]?.excitation ?? row.value()));
    refill(
      numbers.querySelector("tbody"),
      muscles.map((m) => [m.name, formatNumber(m.tension, 2), formatNumber(m.length * 1e3, 2)]),
    );
    const net = state.bands ?? [];
    bands.hidden = net.length === 0;
    refill(
      bands.querySelector("tbody"),
      net.map((b) => [b.name, formatNumber(b.tension, 2), b.slack ? "slack" : ""]),
    );
    tip.replaceChildren(facts(restFacts(state)), ...warnings(state.warnings));
  }

  const refresh = whenQuiet(async () => {
    if (panel.hidden || store.scene?.mode !== "tendons" || !app.link.connected()) return;
    const next = await app.ask("tendons.state");
    if (next) take(next);
  }, QUIET);

  function take(next) {
    const names = [next.subject, next.digit, next.muscles?.map((m) => m.name), store.scene.joints];
    const key = JSON.stringify(names);
    state = next;
    if (panel.dataset.key !== key) build();
    panel.dataset.key = key;
    show();
  }

  const open = el(
    "div",
    { class: "buttons" },
    slowButton("Open a digit\u2026", () => app.openDialog("subjects")),
    backToWorld(app),
  );
  const body = el(
    "div",
    {},
    part("Posture", posture),
    part("Tensions", tensions),
    part("Excitations", excitations),
    part("At rest", tip, numbers, bands),
    sweep.element,
  );
  const panel = el("div", { class: "page tendons" }, hint, open, body);

  function follow() {
    if (store.scene?.mode !== "tendons" || !store.frame) return;
    const valueOf = (name) =>
      store.frame.joints[store.scene.joints.findIndex((joint) => joint.name === name)];
    for (const { name, row } of rows.posture) row.set(valueOf(name));
    sweep.follow(valueOf);
  }
  const changeMode = () => {
    const here = store.scene?.mode === "tendons";
    body.hidden = !here;
    hint.hidden = here;
    hint.textContent = "No digit with tendons is shown.";
    if (here) refresh();
  };
  store.on(["scene", "tab"], changeMode);
  store.on(["frame"], () => {
    follow();
    if (!panel.hidden) refresh();
  });
  changeMode();
  return panel;
}
