// A row of buttons that name the colours and hide or show what they stand for.

import { el, svg } from "./dom.js";

const LINE = { width: 26, height: 4 }; // [px]

/// A patch of a mark: box, line, dash, dot, ring, thick or thin. A line has its dashes.
export function swatch({ color = "var(--ink)", mark = "box", dash }) {
  if (mark !== "line") return el("span", { class: `swatch ${mark}`, style: `--swatch: ${color}` });
  const y = LINE.height / 2;
  return svg(
    "svg",
    { class: "swatch-line", ...LINE, "aria-hidden": "true" },
    svg("line", {
      x1: 0,
      x2: LINE.width,
      y1: y,
      y2: y,
      style: `stroke: ${color}`,
      "stroke-width": 3,
      "stroke-dasharray": dash?.join(" "),
    }),
  );
}

function entry({ name, ...look }, onToggle) {
  const button = el(
    "button",
    { type: "button", "aria-pressed": "true", title: `Hide or show ${name}` },
    swatch(look),
    name,
  );
  button.addEventListener("click", () => {
    const shown = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(shown));
    onToggle(name, shown);
  });
  return button;
}

/// `entries` have a name, a CSS colour, a mark as swatch() takes it, and a line its dashes.
export const legend = (entries, onToggle) =>
  el(
    "div",
    { class: "legend", role: "group", "aria-label": "Legend" },
    ...entries.map((e) => entry(e, onToggle)),
  );

/// The same look without buttons, for line styles that cannot be switched off.
export const key = (entries) =>
  el(
    "div",
    { class: "legend key" },
    ...entries.map(({ name, ...look }) => el("span", {}, swatch(look), name)),
  );
