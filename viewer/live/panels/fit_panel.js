// A fit: its trials, its joint axes, forces measured and predicted.

import { el } from "../../report/dom.js";
import { formatCell, formatNumber } from "../../numbers/format.js";
import { backToWorld, choice, facts, fileRow, part, plainTable, refill } from "./controls.js";

const vector = (v) => (v ? v.map((x) => formatNumber(x, 2)).join(", ") : "n/a");

const trialName = (trial, i) =>
  typeof trial === "string"
    ? trial
    : (trial.name ?? [i + 1, trial.muscle].filter(Boolean).join(" "));

/// Whatever else the server says of an axis, one fact a line.
const axisFacts = (axis) =>
  Object.entries(axis)
    .filter(([key]) => key !== "name" && key !== "joint")
    .map(([key, value]) => [
      key.replaceAll("_", " "),
      Array.isArray(value) ? vector(value) : formatCell(value),
    ]);

export function makeFitPanel(app) {
  const { store } = app;
  const hint = el("p", { class: "hint" }, "No fit is shown.");
  const open = fileRow("Fit", (file) => app.ask("fit.open", { file }));
  const trials = choice("Trial", async (value) => {
    await app.ask("fit.trial", { trial: Number(value) });
    refresh();
  });
  const now = el("div", {});
  const table = plainTable(["trial", "measured [N]", "predicted [N]"], [], "Forces");
  const axes = el("div", {});
  const body = el(
    "div",
    {},
    trials,
    part("This trial", now),
    part("All trials", table),
    part("Axes", axes),
  );
  const panel = el("div", { class: "page fit" }, hint, open, backToWorld(app), body);

  function show(state) {
    const list = state.trials ?? [];
    const chosen = state.trial ?? 0;
    trials.set(
      list.map((trial, i) => ({ value: String(trial.index ?? i), text: trialName(trial, i) })),
      String(chosen),
    );
    const trial = list.find((one, i) => (one.index ?? i) === chosen) ?? {};
    const measured = state.measured ?? trial.measured;
    const predicted = state.predicted ?? trial.predicted;
    now.replaceChildren(
      facts([
        ["Measured", `${vector(measured)} N`],
        ["Predicted", `${vector(predicted)} N`],
      ]),
    );
    refill(
      table.querySelector("tbody"),
      list.map((one, i) => [trialName(one, i), vector(one.measured), vector(one.predicted)]),
    );
    axes.replaceChildren(
      ...(state.axes ?? []).map((axis, i) =>
        part(axis.name ?? axis.joint ?? `axis ${i + 1}`, facts(axisFacts(axis))),
      ),
    );
  }
  async function refresh() {
    const here = store.scene?.mode === "fit";
    hint.hidden = here;
    body.hidden = !here;
    if (!here || panel.hidden) return;
    const state = await app.ask("fit.state");
    if (state) show(state);
  }
  store.on(["scene", "tab"], refresh);
  refresh();
  return panel;
}
