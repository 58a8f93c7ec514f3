// Measured against predicted forces: small multiples of arrows, one colour a tendon, one scale for
// all.

import { el } from "./dom.js";
import { figure, remark } from "./figure.js";
import { key, legend } from "./legend.js";
import { cssColor, indexByName } from "./palette.js";
import { vectorPanel } from "./vector_panel.js";
import { commonScale, groupsOf, misfit, planeRange } from "./vectors_model.js";

const PANEL = { width: 250, height: 240 }; // room for the arrows of one panel [px]
const NARROW_PANEL = 168; // the same width where four stand in a row [px]

const KEY = [
  { name: "measured", mark: "line" },
  { name: "predicted", mark: "dash" },
  { name: "95 % region", mark: "ring" },
];

const planeOf = (plane, range, scale, index) =>
  el(
    "div",
    { class: "plane" },
    el("h3", {}, plane.name),
    el(
      "div",
      { class: "panels" },
      ...plane.panels.map((panel) => vectorPanel(panel, plane, range, scale, index)),
    ),
  );

export function drawVectors(block) {
  const groups = groupsOf(block);
  const index = indexByName(groups);
  const ranges = block.planes.map(planeRange);
  const room = block.planes.some((plane) => plane.panels.length > 3) ? NARROW_PANEL : PANEL.width;
  const scale = commonScale(ranges, room, PANEL.height);
  const body = el(
    "div",
    { class: "planes" },
    ...block.planes.map((plane, i) => planeOf(plane, ranges[i], scale, index)),
  );
  const toggle = (name, shown) =>
    body.querySelectorAll(".pair").forEach((pair) => {
      if (pair.dataset.group === name) pair.style.display = shown ? "" : "none";
    });
  const arrows = block.planes.flatMap((plane) => plane.panels.flatMap((panel) => panel.arrows));
  const lost = arrows.filter((a) => misfit(a) === null).length;
  const sds = arrows.some((a) => a.sd || a.predicted_sd);
  return figure(
    "figure",
    block.caption,
    legend(
      groups.map((name) => ({ name, color: cssColor(index.get(name)) })),
      toggle,
    ),
    key(sds ? KEY : KEY.slice(0, 2)),
    body,
    remark(
      lost ? `${lost} of ${arrows.length} pairs have a force that is not available (n/a).` : "",
    ),
  );
}
