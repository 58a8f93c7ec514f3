// A fit: its trials, its joint axes, forces measured and predicted.

import { el } from "../../report/dom.js";
import { formatNumber } from "../../numbers/format.js";
import { rotated } from "../link/directions.js";
import { backToWorld, choice, facts, fileRow, part, plainTable, refill } from "./controls.js";

const vector = (v) => (v ? v.map((x) => formatNumber(x, 2)).join(", ") : "n/a");

const trialName = ({ trial, specimen, posture, loads }) =>
  [`${trial + 1}`, specimen, posture, loads].filter((word) => word && word !== "").join(" ");

const COMPONENTS =
  "Components along the experiment's own axes; arrows show the same forces in the picture.";
const FRAME = "Reference posture; along x, y, z of the picture, from the subject's origin.";
const DEGREE = Math.PI / 180;

/// An estimate with its interval, where that is not the estimate itself.
function intervalWords({ value, lower, upper }, scale, unit) {
  const shown = (v) => formatNumber(v === null ? NaN : v / scale, 1);
  const between = lower === upper ? "" : ` (${shown(lower)} to ${shown(upper)})`;
  return `${shown(value)}${between}${unit}`;
}

/// Returns the relative position of two axes as text.
const pairFacts = ({ angle, distance, beyond }) => [
  ["Angle", intervalWords(angle, DEGREE, "\u00b0")],
  ["Distance", intervalWords(distance, 1e-3, "\u202fmm")],
  ["Second lies distal by", intervalWords(beyond, 1e-3, "\u202fmm")],
];

/// An axis along the triad of the picture; points have the subject's origin.
export const axisFacts = ({ direction, point }, rotation) => [
  ["Direction", vector(rotated(direction, rotation))],
  ["Point", `${vector(rotated(point, rotation).map((x) => x * 1e3))} mm`],
];

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
  const axes = el("div", { class: "parts" });
  const body = el(
    "div",
    { class: "parts" },
    trials,
    part("This trial", now, el("p", { class: "hint" }, COMPONENTS)),
    part("All trials", table),
    part("Axes", el("p", { class: "hint" }, FRAME), axes),
  );
  const panel = el("div", { class: "page fit" }, hint, open, backToWorld(app), body);

  function show(state) {
    const list = state.trials;
    trials.set(
      list.map((one) => ({ value: String(one.trial), text: trialName(one) })),
      String(state.trial),
    );
    const trial = list.find((one) => one.trial === state.trial);
    now.replaceChildren(
      facts(
        trial
          ? [
              ["Measured", `${vector(trial.measured)} N`],
              ["Predicted", `${vector(trial.predicted)} N`],
              ["Standard deviation", `${vector(trial.sd)} N`],
              ["Direction off by", `${formatNumber(trial.direction_error / DEGREE, 1)}\u00b0`],
            ]
          : [],
      ),
      ...(state.warnings ?? []).map((words) => el("p", { class: "warning" }, words)),
    );
    refill(
      table.querySelector("tbody"),
      list.map((one) => [trialName(one), vector(one.measured), vector(one.predicted)]),
    );
    axes.replaceChildren(
      ...state.pairs.map((pair) => part(pair.axes, facts(pairFacts(pair)))),
      ...state.axes.map((axis) => part(axis.joint, facts(axisFacts(axis, state.rotation)))),
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
