// Moment arms and lengths of muscles over a joint, with a line at the present posture.

import { el } from "../../report/dom.js";
import { quantityOf } from "../link/quantities.js";
import { choice, part, slowButton } from "./controls.js";
import { liveChart } from "./live_chart.js";

const LEAST = Math.PI / 900; // the line follows turns larger than this [rad], or metres

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

/// The part of the tendon panel with its charts. offer(joints) names what can be chosen, clear() takes the
/// charts away, follow(value of a joint by name) moves the line.
export function makeSweep(app) {
  const charts = el("div", {});
  const over = choice("Over", () => {});
  let joints = [];
  let swept = null;
  let latest = null; // tells values of joints

  async function plot() {
    const joint = joints.find(({ name }) => name === over.value());
    if (!joint) return;
    const found = await app.ask("tendons.sweep", { joint: joint.name, what: ["arms", "lengths"] });
    if (!found) return;
    swept = drawSweep(found, joint);
    charts.replaceChildren(swept.element);
    for (const words of found.warnings ?? []) charts.prepend(el("p", { class: "warning" }, words));
    sweep.follow(latest);
  }
  const sweep = {
    element: part(
      "Over a joint",
      over,
      el("div", { class: "buttons" }, slowButton("Plot", plot, { id: "plot-sweep" })),
      charts,
    ),
    offer: (next) => {
      joints = next;
      over.set(joints.map(({ name }) => name));
    },
    clear: () => {
      swept = null;
      charts.replaceChildren();
    },
    follow: (valueOf) => {
      latest = valueOf;
      if (!swept || !valueOf) return;
      const value = valueOf(swept.joint.name);
      if (!Number.isFinite(value) || Math.abs(value - (swept.drawn ?? Infinity)) < LEAST) return;
      swept.drawn = value;
      swept.cursor(value);
    },
  };
  return sweep;
}
