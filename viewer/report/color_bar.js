// What the colours of a scene stand for.

import { colorOf, cssGradient } from "../picture/color_scale.js";
import { formatNumber } from "../numbers/format.js";
import { el } from "./dom.js";

/// `dashed` names what is drawn so, if anything is.
export const colorBar = ({ label, low, high, dashed }) =>
  el(
    "div",
    { class: "color-bar" },
    el("span", {}, label),
    el("span", { class: "number" }, formatNumber(low)),
    el("span", { class: "ramp", style: `background: ${cssGradient()}` }),
    el("span", { class: "number" }, formatNumber(high)),
    dashed ? el("span", { class: "dashed" }, dashed) : null,
  );

const HEIGHT = 30; // of the bar below a saved picture [px]
const RAMP = { width: 176, height: 11 };
const GAP = 8;

/// A saved picture with the same bar below it; `look` has the colours { ink, page }, `ratio` the
/// pixels to each of CSS.
export function withColorBar(picture, { label, low, high }, look, ratio) {
  const whole = document.createElement("canvas");
  whole.width = picture.width;
  whole.height = picture.height + HEIGHT * ratio;
  const context = whole.getContext("2d");
  context.fillStyle = look.page;
  context.fillRect(0, 0, whole.width, whole.height);
  context.drawImage(picture, 0, 0);
  context.scale(ratio, ratio);
  context.font = "12px system-ui, sans-serif";
  context.textBaseline = "middle";
  const middle = picture.height / ratio + HEIGHT / 2;
  let left = GAP;
  const write = (words) => {
    context.fillStyle = look.ink;
    context.fillText(words, left, middle);
    left += context.measureText(words).width + GAP;
  };
  write(label);
  write(formatNumber(low));
  for (let i = 0; i < RAMP.width; ++i) {
    context.fillStyle = colorOf(i, { low: 0, high: RAMP.width - 1 });
    context.fillRect(left + i, middle - RAMP.height / 2, 1.5, RAMP.height);
  }
  left += RAMP.width + GAP;
  write(formatNumber(high));
  return whole;
}
