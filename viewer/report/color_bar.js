// What the colours of a scene stand for.

import { cssGradient } from "../scene/color_scale.js";
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
