// Quantities two by two: which values go together. The reader chooses which ones.

import { cornerSvg } from "./corner_panels.js";
import { el } from "./dom.js";
import { figure } from "./figure.js";
import { fluid } from "./fluid.js";
import { key } from "./legend.js";

const MOST = 8;
const LEAST_PANEL = 76; // [px]
const SIDE = 96; // taken by the names at the left [px]

/// A button for each quantity shown, which removes it; a list adds others.
function chooser(quantities, chosen, onChange) {
  const chips = chosen.map((i) =>
    el(
      "button",
      {
        type: "button",
        class: "chip",
        title: `Leave out ${quantities[i].name}`,
        disabled: chosen.length < 3,
        onclick: () => onChange(chosen.filter((k) => k !== i)),
      },
      quantities[i].name,
      el("span", { "aria-hidden": "true" }, " \u00d7"),
    ),
  );
  const others = quantities.map((q, i) => [q, i]).filter(([, i]) => !chosen.includes(i));
  if (!others.length) return chips;
  const full = chosen.length >= MOST;
  const select = el(
    "select",
    {
      "aria-label": "Add a quantity",
      disabled: full,
      onchange: () => onChange([...chosen, Number(select.value)]),
    },
    el("option", { value: "" }, full ? `${MOST} at most` : "add a quantity"),
    ...others.map(([q, i]) => el("option", { value: i }, q.name)),
  );
  return [...chips, select];
}

function keyOf(quantities) {
  const entries = [
    {
      name: "50 % of draws",
      color: "color-mix(in srgb, var(--blue) 60%, var(--page))",
      mark: "box",
    },
    { name: "90 %", color: "color-mix(in srgb, var(--blue) 25%, var(--page))", mark: "box" },
  ];
  if (quantities.some((q) => q.prior))
    entries.push({ name: "prior", color: "var(--muted)", mark: "dash" });
  if (quantities.some((q) => typeof q.truth === "number"))
    entries.push({ name: "truth", color: "var(--vermillion)", mark: "line" });
  return key(entries);
}

export function drawCorner(block) {
  const { quantities } = block;
  let chosen = block.shown ?? quantities.slice(0, MOST).map((_, i) => i);
  let fitted = false;
  const tools = el("div", { class: "tools chooser" });
  const frame = fluid({ class: "corner" }, (width) => {
    // At first no more than find room.
    if (!fitted) {
      const room = Math.max(2, Math.floor((width - SIDE) / LEAST_PANEL));
      if (chosen.length > room) change(chosen.slice(0, room), false);
      fitted = true;
    }
    const side = Math.max(LEAST_PANEL, Math.min(170, (width - SIDE - 4) / chosen.length));
    return [
      cornerSvg(
        chosen.map((i) => quantities[i]),
        Math.floor(side),
        SIDE,
      ),
    ];
  });
  function change(next, redraw = true) {
    chosen = next;
    tools.replaceChildren(...chooser(quantities, chosen, change));
    if (redraw) frame.redraw();
  }
  change(chosen.slice(0, MOST), false);
  return figure("figure", block.caption, tools, keyOf(quantities), frame);
}
