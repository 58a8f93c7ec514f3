// The horizontal axis and the reference lines that bar charts and forest plots share.

import { svg } from "./dom.js";
import { tickLabels } from "../numbers/format.js";

/// About the width of a text at 12 px; SVG can only measure what is already in the page.
export const textWidth = (text) => 6.7 * String(text).length;

/// Grid lines from `top` to `bottom`, ticks and a label below.
export function axisBelow(x, values, top, bottom, label, middle) {
  const names = tickLabels(values);
  return [
    ...values.flatMap((v, i) => [
      svg("line", { class: v === 0 ? "zero" : "grid", x1: x(v), x2: x(v), y1: top, y2: bottom }),
      svg("text", { x: x(v), y: bottom + 15, "text-anchor": "middle" }, names[i]),
    ]),
    svg(
      "text",
      { class: "label", x: middle, y: bottom + 34, "text-anchor": "middle" },
      label ?? "",
    ),
  ];
}

/// Dashed vertical lines, named at the top.
export const references = (x, lines, top, bottom) =>
  lines.flatMap(({ label, value }) => [
    svg("line", { class: "reference", x1: x(value), x2: x(value), y1: top, y2: bottom }),
    svg("text", { class: "label", x: x(value), y: top - 6, "text-anchor": "middle" }, label ?? ""),
  ]);
