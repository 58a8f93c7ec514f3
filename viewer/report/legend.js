// A row of buttons that name the colours and hide or show what they stand for.

import { el } from "./dom.js";

function entry({ name, color, mark = "box" }, onToggle) {
  const swatch = el("span", { class: `swatch ${mark}`, style: `--swatch: ${color}` });
  const button = el(
    "button",
    { type: "button", "aria-pressed": "true", title: `Hide or show ${name}` },
    swatch,
    name,
  );
  button.addEventListener("click", () => {
    const shown = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(shown));
    onToggle(name, shown);
  });
  return button;
}

/// `entries` have a name, a CSS colour and a mark: box, line, dash, or dot.
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
    ...entries.map(({ name, color = "var(--ink)", mark }) =>
      el("span", {}, el("span", { class: `swatch ${mark}`, style: `--swatch: ${color}` }), name),
    ),
  );
