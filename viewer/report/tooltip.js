// One small box that follows the pointer and tells numbers.

import { el } from "./dom.js";
import { swatch } from "./legend.js";

let box = null;

function place(event) {
  const margin = 14;
  const width = box.offsetWidth;
  const height = box.offsetHeight;
  const left =
    event.clientX + margin + width > innerWidth
      ? event.clientX - margin - width
      : event.clientX + margin;
  const top =
    event.clientY + margin + height > innerHeight
      ? event.clientY - margin - height
      : event.clientY + margin;
  box.style.left = `${Math.max(0, left)}px`;
  box.style.top = `${Math.max(0, top)}px`;
}

export function showTooltip(event, lines) {
  box ??= document.body.appendChild(el("div", { class: "tooltip", role: "status" }));
  box.replaceChildren(...lines.map((line, i) => el(i === 0 ? "strong" : "div", {}, line)));
  box.hidden = false;
  place(event);
}

/// A line of a tooltip about one of several curves: its mark, its name and what it is there. `near`
/// makes it stand out.
export const readingRow = (look, name, value, near = false) =>
  el(
    "span",
    { class: near ? "reading near" : "reading" },
    swatch({ ...look, mark: "line" }),
    el("span", {}, name),
    el("span", { class: "value" }, value),
  );

export function hideTooltip() {
  if (box) box.hidden = true;
}

/// Tells `lines` while the pointer is over `node`; the same text is its accessible name.
export function describe(node, lines) {
  node.setAttribute("aria-label", lines.join(", "));
  node.addEventListener("pointermove", (event) => showTooltip(event, lines));
  node.addEventListener("pointerleave", hideTooltip);
  return node;
}
