// What a moving scene can be told: efforts, targets of drives, tensions, excitations; one at a time.

import { el } from "../../report/dom.js";
import { latestWins } from "../link/latest.js";
import { QUANTITIES } from "../link/quantities.js";
import { choice, part, sliderRow } from "./controls.js";

// The parameter of motion.set for each kind, and its limits where none are known.
const KINDS = {
  effort: { param: "efforts", reach: 10 },
  target: { param: "targets", reach: Math.PI },
  tension: { param: "tensions", reach: 100 },
  excitation: { param: "excitations", reach: 1 },
};

/// How a unit of the server is shown.
function quantityOf({ unit }) {
  if (unit === "rad") return QUANTITIES.angle;
  if (unit === "m") return QUANTITIES.length;
  return { unit: unit === "1" ? "" : unit, scale: 1, digits: 3, step: 0.01, big: 0.1 };
}

const keyOf = ({ kind, name }) => `${kind} ${name}`;

/// The part of the time panel with the inputs; refill() asks which there are.
export function makeMotionInputs(app) {
  const box = el("div", {});
  const chosen = choice("Input", () => show());
  const element = part("Inputs", chosen, box);
  let inputs = [];
  const send = latestWins((params) => app.ask("motion.set", params));

  function show() {
    const input = inputs.find((one) => keyOf(one) === chosen.value());
    if (!input) return box.replaceChildren();
    const { param, reach } = KINDS[input.kind];
    const quantity = quantityOf(input);
    const lower = input.lower ?? (param === "efforts" || param === "targets" ? -reach : 0);
    const upper = input.upper ?? reach;
    const row = sliderRow({ name: input.name, lower, upper, quantity }, (value) => {
      input.set = value;
      send({ [param]: { [input.name]: value } });
    });
    row.set(input.set ?? 0);
    box.replaceChildren(row);
  }
  async function refill() {
    const found = await app.ask("motion.inputs");
    inputs = (found?.inputs ?? []).filter(({ kind }) => kind in KINDS);
    element.hidden = inputs.length === 0;
    chosen.set(inputs.map((one) => ({ value: keyOf(one), text: `${one.name} (${one.kind})` })));
    show();
  }
  return { element, refill };
}
