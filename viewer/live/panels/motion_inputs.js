// Inputs of a moving scene: efforts, targets of drives, tensions, excitations; one at a time.

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

/// Returns a unit of the server as it is displayed.
function quantityOf({ unit }) {
  if (unit === "rad") return QUANTITIES.angle;
  if (unit === "m") return QUANTITIES.length;
  return { unit: unit === "1" ? "" : unit, scale: 1, digits: 3, step: 0.01, big: 0.1 };
}

/// A name in two: "human:skewed/index/FDP2" is FDP2 of "human:skewed index".
export function nameParts(name) {
  const parts = name.split("/");
  return { group: parts.slice(0, -1).join(" "), short: parts.at(-1) };
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
    const { short } = nameParts(input.name);
    const about = { name: short, title: input.name, lower, upper, quantity };
    const row = sliderRow(about, (value) => {
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
    const told = (one) => {
      const { group, short } = nameParts(one.name);
      return { value: keyOf(one), text: `${short} (${one.kind})`, group };
    };
    chosen.set(inputs.map(told));
    show();
  }
  return { element, refill };
}
