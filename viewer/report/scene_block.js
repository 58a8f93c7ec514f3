// A 3D view inside the report: frame, caption, and what to do where there is no WebGL.

import { colored } from "../picture/color_scale.js";
import { timedLayers } from "../picture/frames.js";
import { mountScene } from "../picture/view.js";
import { colorBar, withColorBar } from "./color_bar.js";
import { el } from "./dom.js";
import { errorBox, figure, remark } from "./figure.js";
import { hexColor } from "./palette.js";
import { playerOf } from "./player.js";
import { followScene } from "./scene_reading.js";
import { stripOf } from "./strip.js";
import { isPrinting, onThemeChange, themeColor } from "./theme.js";
import { whenNear, whenShown } from "./when_shown.js";

const NEAR = "1200px"; // of the window, where compact scenes are drawn
const HINT =
  "Drag to turn; click, then scroll to zoom; double-click to fit. Keys: arrows, +, \u2212, 0.";
const PRINTED = 2; // pixels of printed and saved pictures to each of CSS

const withColors = (layers) =>
  layers.map((layer, i) => ({ ...layer, color: layer.color ?? hexColor(i) }));

/// The scene follows the page's colours.
const theme = () => ({
  ink: themeColor("--ink"),
  muted: themeColor("--muted"),
  page: themeColor("--page"),
  faint: themeColor("--faint"),
});

/// On paper stands a picture of the view, drawn before the page is laid out for it.
function printPicture(frame, view) {
  const add = () => {
    const picture = view.picture(PRINTED);
    picture.className = "printed";
    frame.append(picture);
    view.draw();
  };
  if (isPrinting()) add();
  addEventListener("beforeprint", add);
  addEventListener("afterprint", () => frame.querySelector(".printed")?.remove());
}

/// `below` takes what stands under the picture: the player of a motion, and remarks.
function fillFrame(frame, block, below) {
  const layers = timedLayers(colored(withColors(block.layers), block.color_scale));
  const view = mountScene(frame, { ...block, layers }, theme);
  onThemeChange(view.draw);
  printPicture(frame, view);
  followScene(view, block);
  frame.toPng = (done) => {
    const picture = view.picture(PRINTED);
    const scale = block.color_scale;
    const whole = scale ? withColorBar(picture, scale, theme(), PRINTED) : picture;
    whole.toBlob(done, "image/png");
    view.draw();
  };
  const lost = `Not drawn (n/a): ${view.lost} of the items, without all their coordinates.`;
  const strip = stripOf(view, block.strip);
  const player = playerOf(view);
  if (player) frame.toMovie = () => player.film(frame.querySelector("canvas"), theme().page);
  below.append(...[player?.element, strip, view.lost ? remark(lost) : null].filter(Boolean));
}

export function drawScene(block) {
  const { compact } = block;
  const label = block.caption ?? "3D view";
  const frame = el("div", { class: compact ? "scene compact" : "scene", "data-label": label });
  const below = el("div");
  const fill = () => {
    try {
      fillFrame(frame, block, below);
    } catch (error) {
      frame.replaceChildren(errorBox(`The 3D view cannot be drawn: ${error.message}`));
    }
  };
  if (compact) whenNear(frame, NEAR, fill);
  else whenShown(frame, fill);
  const bar = block.color_scale ? colorBar(block.color_scale) : null;
  const hint = compact ? null : el("p", { class: "hint" }, HINT);
  return figure("figure", block.caption, frame, bar, below, hint);
}
