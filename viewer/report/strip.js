// A motion as a row of still pictures with the time below each, which also stands on paper.

import { formatNumber } from "../numbers/format.js";
import { instantAt, instantsOf } from "../picture/frames.js";
import { el } from "./dom.js";
import { onThemeChange } from "./theme.js";

const SIZE = { width: 300, height: 225 }; // of one picture, CSS pixels
const RATIO = 2; // pixels of a picture to each of CSS

/// Calls `work` for each of the instants with nothing else in view; the view is left as it was.
function atEach(view, instants, work) {
  const timed = view.layers.filter(({ time }) => time !== null);
  const before = timed.map(({ group }) => group.visible);
  for (const instant of instants) {
    for (const { group, time } of timed) group.visible = time === instant;
    work(instant);
  }
  timed.forEach(({ group }, i) => (group.visible = before[i]));
}

/// The strip of a view at the instants nearest before `times` [s]; null without times or instants.
export function stripOf(view, times) {
  const all = instantsOf(view.layers);
  if (!times?.length || !all.length) return null;
  const instants = [...new Set(times.map((time) => instantAt(all, time)))];
  const strip = el("div", { class: "strip", role: "group", "aria-label": "Motion in pictures" });
  const fill = () => {
    strip.replaceChildren();
    atEach(view, instants, (instant) => {
      const told = `${formatNumber(instant)} s`;
      const picture = view.still(SIZE, RATIO);
      picture.setAttribute("role", "img");
      picture.setAttribute("aria-label", `At ${told}`);
      strip.append(el("div", { class: "still" }, picture, el("span", {}, told)));
    });
    view.draw();
  };
  fill();
  onThemeChange(fill);
  return strip;
}
