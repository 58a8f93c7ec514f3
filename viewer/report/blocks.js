// From a block's type to the function that draws it.

import { el, paragraphs } from "./dom.js";
import { errorBox, figure, remark } from "./figure.js";
import { faults, isEmpty } from "./check.js";
import { drawBanner } from "./banner.js";
import { drawBars } from "./bars.js";
import { drawChains } from "./chains.js";
import { drawCorner } from "./corner.js";
import { drawInterval } from "./interval.js";
import { drawLines } from "./lines.js";
import { isPage } from "./opening.js";
import { drawPredictive } from "./predictive.js";
import { withSaving } from "./save.js";
import { drawScene } from "./scene_block.js";
import { drawTable } from "./table.js";
import { drawVectors } from "./vectors.js";

/// A link goes to a page beside this one, nowhere else.
const linkTo = ({ file, text }) =>
  isPage(file) ? el("p", {}, el("a", { href: file }, text ?? file)) : null;

const drawText = (block) =>
  el("div", { class: "prose" }, ...paragraphs(block.text), block.link ? linkTo(block.link) : null);

const drawRow = ({ narrow, blocks }) =>
  el("div", { class: narrow ? "row narrow" : "row" }, ...blocks.map(drawBlock));

const DRAW = {
  table: drawTable,
  lines: drawLines,
  vectors: drawVectors,
  scene: drawScene,
  bars: drawBars,
  interval: drawInterval,
  banner: drawBanner,
  chains: drawChains,
  corner: drawCorner,
  predictive: drawPredictive,
  text: drawText,
  row: drawRow,
};

/// The element for one block; for one that is wrong or unknown, a box that says so.
export function drawBlock(block) {
  const wrong = faults(block);
  if (wrong.length) return errorBox(wrong.join("; "));
  if (isEmpty(block)) return figure("figure", block.caption, remark("No data."));
  try {
    return withSaving(block, DRAW[block.type](block));
  } catch (error) {
    return errorBox(`block "${block.type}" could not be drawn: ${error.message}`);
  }
}
