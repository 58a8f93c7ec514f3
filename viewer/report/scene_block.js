// A 3D view inside the report: frame, caption, and what to do where there is no WebGL.

import { colored } from "../scene/color_scale.js";
import { mountScene } from "../scene/view.js";
import { colorBar } from "./color_bar.js";
import { el } from "./dom.js";
import { errorBox, figure, remark } from "./figure.js";
import { hexColor } from "./palette.js";
import { onThemeChange, themeColor } from "./theme.js";

const NEAR = "1200px"; // of the window, where compact scenes are drawn
const HINT = "Drag to turn; click, then scroll to zoom; double-click to fit.";

const withColors = (layers) =>
  layers.map((layer, i) => ({ ...layer, color: layer.color ?? hexColor(i) }));

/// The scene follows the page's colours.
const theme = () => ({
  ink: themeColor("--ink"),
  muted: themeColor("--muted"),
  page: themeColor("--page"),
  faint: themeColor("--faint"),
});

function fillFrame(frame, block, notes) {
  const scene = { ...block, layers: colored(withColors(block.layers), block.color_scale) };
  const view = mountScene(frame, scene, theme);
  onThemeChange(view.draw);
  const lost = `Not drawn (n/a): ${view.lost} of the items, without all their coordinates.`;
  if (view.lost) notes.append(remark(lost));
}

/// Does the work when the element comes near the window, or is printed.
function whenNear(element, work) {
  const observer = new IntersectionObserver(
    (seen) => seen.some(({ isIntersecting }) => isIntersecting) && begin(),
    { rootMargin: NEAR },
  );
  const begin = () => {
    observer.disconnect();
    removeEventListener("beforeprint", begin);
    work();
  };
  observer.observe(element);
  addEventListener("beforeprint", begin);
}

export function drawScene(block) {
  const { compact } = block;
  const label = block.caption ?? "3D view";
  const frame = el("div", { class: compact ? "scene compact" : "scene", "data-label": label });
  const notes = el("div");
  const fill = () => {
    try {
      fillFrame(frame, block, notes);
    } catch (error) {
      frame.replaceChildren(errorBox(`The 3D view cannot be drawn: ${error.message}`));
    }
  };
  if (compact) whenNear(frame, fill);
  else requestAnimationFrame(fill);
  const bar = block.color_scale ? colorBar(block.color_scale) : null;
  const hint = compact ? null : el("p", { class: "hint" }, HINT);
  return figure("figure", block.caption, frame, bar, hint, notes);
}
