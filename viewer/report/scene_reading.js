// Tells what of a scene lies below the pointer: its name, its value, and where it is.

import { Color } from "three";
import { valueOf } from "../picture/color_scale.js";
import { formatNumber } from "../numbers/format.js";
import { hideTooltip, showTooltip } from "./tooltip.js";

const bytesOf = ([r, g, b]) => {
  const { r: red, g: green, b: blue } = new Color(r, g, b).convertLinearToSRGB();
  return [red, green, blue].map((c) => 255 * c);
};

/// The value of what was found on the scale of its scene; null if it has none.
function readValue({ item, color }, scale) {
  if (!scale) return null;
  if (Number.isFinite(item?.value)) return item.value;
  return color ? valueOf(bytesOf(color), scale) : null;
}

/// "tension [N]" and 3.2 as "tension 3.2 N".
function withLabel(label, value) {
  const [, name, unit] = label.match(/^(.*?)\s*(?:\[([^\]]*)\])?$/);
  return `${name} ${formatNumber(Number(value.toPrecision(3)))}${unit ? ` ${unit}` : ""}`;
}

/// The lines of the tooltip about `found` = { layer, item, point, color }, of a scene block.
export function sceneReading(found, { color_scale: scale, unit = "mm", axes = [] }) {
  const { layer, item, point } = found;
  const value = readValue(found, scale);
  const size = Math.max(...point.toArray().map(Math.abs));
  const told = (v) => formatNumber(Number(v.toFixed(size < 10 ? 2 : 1)));
  const place = point.toArray().map((v, i) => {
    const word = axes[i] ? ` (${axes[i]})` : "";
    return `${"xyz"[i]}${word} ${told(v)}`;
  });
  return [
    item?.label ? `${layer.name}: ${item.label}` : layer.name,
    ...(value === null ? [] : [withLabel(scale.label, value)]),
    `${place.join(", ")} ${unit}`,
  ];
}

/// Tells while the pointer moves over a view without a button held.
export function followScene(view, block) {
  let last = null;
  const tell = (event) => {
    last = event;
    requestAnimationFrame(() => {
      if (last !== event) return;
      const found = view.at(event);
      if (found) showTooltip(event, sceneReading(found, block));
      else hideTooltip();
    });
  };
  view.canvas.addEventListener("pointermove", (event) => {
    if (event.buttons === 0) tell(event);
    else hideTooltip();
  });
  view.canvas.addEventListener("pointerleave", () => {
    last = null;
    hideTooltip();
  });
}
