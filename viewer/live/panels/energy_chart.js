// Where the energy of a moving scene is, over time, and how far its motion is to be believed.

import { formatNumber } from "../../numbers/format.js";
import { el } from "../../report/dom.js";
import { facts } from "./controls.js";
import { liveChart } from "./live_chart.js";

const DRAW = 200; // at least between two drawings of the chart [ms]
const MOST = 1500; // points of a chart

/// Numbers of an object by name, also those one level down: { kinetic: 1 }.
const numbersOf = (object) =>
  Object.fromEntries(Object.entries(object ?? {}).filter(([, value]) => Number.isFinite(value)));

/// Energies over time, which forget what comes after a step back.
export function makeHistory() {
  const history = { t: [], values: new Map() };
  history.add = (t, values) => {
    while (history.t.length && history.t.at(-1) >= t) {
      history.t.pop();
      for (const list of history.values.values()) list.pop();
    }
    for (const name of Object.keys(values))
      if (!history.values.has(name))
        history.values.set(
          name,
          history.t.map(() => null),
        );
    history.t.push(t);
    for (const [name, list] of history.values) list.push(values[name] ?? null);
    if (history.t.length > MOST) {
      // Every second point of the older half goes: the whole run stays in sight.
      const keep = (_, i) => i % 2 === 0 || i > MOST / 2;
      history.t = history.t.filter(keep);
      for (const [name, list] of history.values) history.values.set(name, list.filter(keep));
    }
  };
  history.clear = () => {
    history.t = [];
    history.values = new Map();
  };
  history.series = () => [...history.values].map(([name, y]) => ({ name, x: history.t, y }));
  return history;
}

function energyBlock(history) {
  return {
    caption: "Energies",
    x_label: "time [s]",
    y_label: "energy [J]",
    height: 200,
    series: history.series(),
  };
}

const beyond = ({ beyond_rad, beyond_m }) =>
  beyond_m === undefined
    ? `${formatNumber((beyond_rad * 180) / Math.PI)}\u202f\u00b0`
    : `${formatNumber(beyond_m * 1e3)}\u202fmm`;

/// How far a motion is to be believed, as pairs of a name and words; nothing where that is not known.
export function accountFacts(state) {
  const rows = [];
  if (Number.isFinite(state.energy_error)) {
    const [error, all] = [state.energy_error, state.energy_turned_over].map((joule) =>
      formatNumber(Math.abs(joule) * 1e3),
    );
    const sense = state.energy_error < 0 ? "made of nothing" : "lost to nothing";
    rows.push(["Energy error", `${error} mJ ${sense}, of ${all} mJ turned over`]);
  }
  if (Number.isFinite(state.deepest))
    rows.push(["Deepest overlap", `${formatNumber(state.deepest * 1e3)}\u202fmm`]);
  if (state.limits_passed?.length)
    rows.push([
      "Limits passed",
      state.limits_passed.map((limit) => `${limit.joint} by ${beyond(limit)}`).join(", "),
    ]);
  if (state.restitution_ignored > 0)
    rows.push(["Restitution ignored", `up to ${formatNumber(state.restitution_ignored)}`]);
  return rows;
}

/// What forbids to believe a motion; "" if nothing does.
export function doubts(state) {
  const words = [];
  if (state.energy_balances === false)
    words.push("Energy does not balance: do not use this motion. Shorter steps may help.");
  if (state.unsolved)
    words.push(
      `${state.unsolved} of ${state.steps} steps missed the tolerance of their contacts; the ` +
        `largest residual is ${formatNumber(state.worst_residual ?? NaN)}.`,
    );
  return words.join(" ");
}

/// The chart, and the account beside it. follow() asks for the energies of now, tell() for the
/// account alone, as of a recorded run, clear() forgets those before. Every frame is asked for, so
/// that no impact falls between two samples, but not before the last answer came.
export function makeEnergyChart(app) {
  const history = makeHistory();
  const element = el("div", { class: "charts" });
  const account = el("div", { class: "account" });
  const warning = el("p", { class: "warning", role: "alert", hidden: true });
  let chart = null;
  let asking = false;
  let redraw = null;

  /// Contact problems that were left with an error, and energy of nothing, are never passed over.
  function warn(state) {
    const words = doubts(state);
    warning.hidden = !words;
    warning.textContent = words;
    account.replaceChildren(facts(accountFacts(state)));
  }

  function draw() {
    redraw = null;
    if (!history.t.length) return;
    const names = [...history.values.keys()].join();
    const block = energyBlock(history);
    if (chart?.names === names) chart.update(block);
    else {
      chart = { ...liveChart(block), names };
      element.replaceChildren(chart.figure);
    }
  }
  async function tell() {
    const state = await app.call("motion.state", { want: ["energy"] }).catch(() => null);
    if (state) warn(state);
    return state;
  }
  async function follow() {
    if (asking) return;
    asking = true;
    const state = await tell();
    asking = false;
    const values = numbersOf(state?.energy);
    if (!Object.keys(values).length) return;
    history.add(state.t, values);
    redraw ??= setTimeout(draw, DRAW);
  }
  const clear = () => {
    history.clear();
    warning.hidden = true;
    account.replaceChildren();
  };
  return { element, account, warning, follow, tell, clear };
}
