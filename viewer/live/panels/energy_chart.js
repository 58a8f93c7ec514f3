// Energies of a moving scene over time, and the accuracy of its simulation.

import { formatNumber } from "../../numbers/format.js";
import { el } from "../../report/dom.js";
import { facts } from "./controls.js";
import { liveChart } from "./live_chart.js";

const DRAW = 200; // at least between two drawings of the chart [ms]
const MOST = 1500; // points of a chart

/// Numbers of an object by name, also those one level down: { kinetic: 1 }.
const numbersOf = (object) =>
  Object.fromEntries(Object.entries(object ?? {}).filter(([, value]) => Number.isFinite(value)));

/// Energies over time; a step back removes all later samples.
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
      // Thin out the older half, so that the whole run stays visible.
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

/// Returns the accuracy of a motion as pairs of a name and a text; empty if it is unknown.
export function accountFacts(state) {
  const rows = [];
  if (Number.isFinite(state.energy_error)) {
    const [error, all] = [state.energy_error, state.energy_turned_over].map((joule) =>
      formatNumber(Math.abs(joule) * 1e3),
    );
    const sense = state.energy_error < 0 ? "created" : "unaccounted for";
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

/// Returns the reason why a motion is unreliable; "" if there is none.
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

  /// Shows the accuracy of the motion, with a warning about unsolved contacts and energy errors.
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
