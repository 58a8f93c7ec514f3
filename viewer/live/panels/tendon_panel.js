// Tendons of a digit: posture, tensions, excitations, and moment arms over a joint.

import { el } from "../../report/dom.js";
import { formatNumber } from "../../numbers/format.js";
import { QUANTITIES, quantityOf } from "../link/quantities.js";
import { latestWins, whenQuiet } from "../link/latest.js";
import { mergeJoints } from "../link/store.js";
import { choice, facts, part, plainTable, refill, sliderRow, slowButton } from "./controls.js";
import { liveChart } from "./live_chart.js";

const MOST = 100; // end of a tension's slider where no largest force is known [N]
const QUIET = 200; // after the last move the table is asked for [ms]
const DEGREE = Math.PI / 180;

const most = (muscle) => muscle.max_force ?? muscle.strength ?? muscle.upper ?? MOST;

/// A sweep as two charts' series; x in degrees or mm.
function sweepBlocks(sweep, joint) {
  const { scale, unit } = quantityOf(joint);
  const x = sweep.x.map((value) => value / scale);
  const series = (values) =>
    Object.entries(values ?? {}).map(([name, y]) => ({
      name,
      x,
      y: y.map((v) => (v === null ? null : v * 1e3)),
    }));
  const cursor = (value) => [{ axis: "x", value: value / scale }];
  const x_label = `${joint.name} [${unit}]`;
  const common = { x_label, height: 210 };
  return {
    cursor,
    arms: {
      ...common,
      caption: `Moment arms over ${joint.name}`,
      y_label: "moment arm [mm]",
      series: series(sweep.arms),
    },
    lengths: {
      ...common,
      caption: `Lengths over ${joint.name}`,
      y_label: "longer than at 0\u00b0 [mm]",
      series: series(sweep.lengths),
    },
  };
}

/// The charts of one sweep, with a line at the posture.
function drawSweep(sweep, joint) {
  const blocks = sweepBlocks(sweep, joint);
  const charts = ["arms", "lengths"]
    .filter((what) => blocks[what].series.length)
    .map((what) => {
      const block = { ...blocks[what], reference_lines: blocks.cursor(sweep.x[0]) };
      return { block, chart: liveChart(block) };
    });
  return {
    joint,
    element: el("div", { class: "charts" }, ...charts.map(({ chart }) => chart.figure)),
    cursor: (value) =>
      charts.forEach(({ block, chart }) =>
        chart.update({ ...block, reference_lines: blocks.cursor(value) }),
      ),
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
  const charts = el("div", {});
  const over = choice("Over", () => {});
  let state = null;
  let rows = { posture: [], tensions: [], excitations: [] };
  let swept = null;

  const set = latestWins(async ({ method, params }) => {
    const next = await app.ask(method, params);
    if (next) take(next);
  }, mergeJoints);
  const change = (what, name, value) =>
    set({ method: "tendons.set", params: { [what]: { [name]: value } } });

  function build() {
    const joints = store.scene.joints.filter((joint) => !joint.led_by);
    const muscles = state.muscles ?? [];
    const row = (what, name, lower, upper, quantity) => {
      const made = sliderRow({ name, lower, upper, quantity }, (v) => change(what, name, v));
      return { name, row: made };
    };
    rows = {
      posture: joints.map((j) => row("posture", j.name, j.lower, j.upper, quantityOf(j))),
      tensions: muscles.map((m) => row("tensions", m.name, 0, most(m), QUANTITIES.force)),
      excitations: muscles.map((m) => row("excitations", m.name, 0, 1, QUANTITIES.share)),
    };
    posture.replaceChildren(...rows.posture.map(({ row: one }) => one));
    tensions.replaceChildren(...rows.tensions.map(({ row: one }) => one));
    excitations.replaceChildren(...rows.excitations.map(({ row: one }) => one));
    over.set(joints.map(({ name }) => name));
    charts.replaceChildren();
    swept = null;
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
    const entries = [];
    if (state.tip_force) {
      const [x, y, z] = state.tip_force;
      entries.push(["Tip force", `${formatNumber(Math.hypot(x, y, z), 2)}\u202fN`]);
      entries.push(["along x, y, z", `${[x, y, z].map((v) => formatNumber(v, 2)).join(", ")} N`]);
    }
    for (const [name, torque] of Object.entries(state.torques ?? {}))
      entries.push([`Torque ${name}`, `${formatNumber(torque * 1e3)} N mm`]);
    if (state.status) entries.push(["Status", String(state.status)]);
    tip.replaceChildren(
      facts(entries),
      ...(state.warnings ?? []).map((words) => el("p", { class: "warning", role: "alert" }, words)),
    );
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

  async function sweep() {
    const joint = store.scene.joints.find(({ name }) => name === over.value());
    if (!joint) return;
    const found = await app.ask("tendons.sweep", { joint: joint.name, what: ["arms", "lengths"] });
    if (!found) return;
    swept = drawSweep(found, joint);
    charts.replaceChildren(swept.element);
    follow();
  }

  const open = el(
    "div",
    { class: "buttons" },
    slowButton("Open a digit\u2026", () => app.openDialog("subjects")),
  );
  const body = el(
    "div",
    {},
    part("Posture", posture),
    part("Tensions", tensions),
    part("Excitations", excitations),
    part("At rest", tip, numbers, bands),
    part(
      "Over a joint",
      over,
      el("div", { class: "buttons" }, slowButton("Plot", sweep, { id: "plot-sweep" })),
      charts,
    ),
  );
  const panel = el("div", { class: "page tendons" }, hint, open, body);

  function follow() {
    if (store.scene?.mode !== "tendons" || !store.frame) return;
    for (const { name, row } of rows.posture) {
      const index = store.scene.joints.findIndex((joint) => joint.name === name);
      row.set(store.frame.joints[index]);
    }
    if (!swept) return;
    const at = store.scene.joints.findIndex(({ name }) => name === swept.joint.name);
    const value = store.frame.joints[at];
    // Half a pixel of the chart is less than this; more often it need not be drawn.
    if (Math.abs(value - (swept.drawn ?? Infinity)) < 0.2 * DEGREE) return;
    swept.drawn = value;
    swept.cursor(value);
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
