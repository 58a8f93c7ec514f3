// Soft pads of a grasp: depths, and sticking parts.

import { el } from "../../report/dom.js";
import { formatNumber } from "../../numbers/format.js";
import { QUANTITIES } from "../link/quantities.js";
import { part, plainTable, refill, sliderRow, slowButton } from "./controls.js";

const MOST = 20; // of the force that presses a pad [N]

const rowOf = (pad) => [
  pad.link,
  formatNumber(pad.depth * 1e3, 2),
  formatNumber(pad.area * 1e6, 1),
  `${formatNumber(100 * pad.stick, 0)} %`,
];

/// The part of the grasp panel with pads; `grasp()` names hand and object.
export function makePadPart(app, grasp) {
  let force = 1;
  const row = sliderRow(
    { name: "force of each", lower: 0.1, upper: MOST, quantity: QUANTITIES.force },
    (value) => (force = value),
  );
  row.set(force);
  const head = ["pad", "depth [mm]", "area [mm\u00b2]", "sticks"];
  const table = plainTable(head, [], "Pads");
  table.hidden = true;
  const words = el("p", { class: "hint" });
  const show = async () => {
    const found = await app.ask("grasp.pads", { ...grasp(), force });
    if (!found) return;
    table.hidden = found.pads.length === 0;
    refill(table.querySelector("tbody"), found.pads.map(rowOf));
    words.textContent = found.reasons.length
      ? found.reasons.join("\n")
      : "On the picture: blue points stick, orange ones slip; larger is more pressure.";
    app.picture.pads.show(found.pads.flatMap(({ points }) => points));
  };
  return part(
    "Pads",
    row,
    el("div", { class: "buttons" }, slowButton("Press", show, { id: "press-pads" })),
    table,
    words,
  );
}
