// Legend of the colours and lengths of the picture.

import { el } from "../../report/dom.js";
import { formatNumber } from "../../numbers/format.js";
import { cssGradient } from "../../picture/color_scale.js";

/// The legend: show({ tensionEnd, forceScale, momentRadius }) fills it; box() is where it stands in the
/// window, as measure() last found it.
export function makeLegend() {
  const low = el("span", { class: "number" }, "0");
  const high = el("span", { class: "number" });
  const ramp = el("span", { class: "ramp" });
  ramp.style.background = cssGradient();
  const tensions = el(
    "div",
    { class: "color-bar", hidden: true },
    el("span", {}, "tension [N]"),
    low,
    ramp,
    high,
    el("span", { class: "dashed" }, "slack"),
  );
  const forces = el("div", { class: "force-scale", hidden: true });
  const moment = el("div", { class: "moment-scale", hidden: true });
  const legend = el(
    "div",
    { class: "key-box", "aria-label": "Legend", role: "group" },
    tensions,
    forces,
    moment,
  );
  let shown = "";
  let box = null;
  // Cached, because measuring forces a layout.
  legend.measure = () => {
    const { left, right, top, bottom } = legend.getBoundingClientRect();
    box = right > left && bottom > top ? { left, right, top, bottom } : null;
  };
  legend.box = () => box;
  new ResizeObserver(legend.measure).observe(legend);
  legend.show = ({ tensionEnd, forceScale, momentRadius = null }) => {
    const key = `${tensionEnd} ${forceScale} ${momentRadius}`;
    if (key === shown) return;
    shown = key;
    tensions.hidden = tensionEnd === null;
    forces.hidden = forceScale === null;
    moment.hidden = momentRadius === null;
    if (tensionEnd !== null) high.textContent = formatNumber(tensionEnd);
    if (forceScale !== null)
      forces.textContent = `arrows: 10\u202fmm for ${formatNumber(0.01 / forceScale)}\u202fN`;
    if (momentRadius !== null)
      moment.textContent =
        "disturbance: moment over the object's radius, " +
        `${formatNumber(1e3 * momentRadius, 1)}\u202fmm`;
  };
  return legend;
}
