// Buttons that save a figure: as SVG or PNG, and its numbers as CSV.

import { csvOf } from "./csv.js";
import { el } from "./dom.js";
import { fileName, figureTable } from "./figure_csv.js";
import { pngOf } from "./figure_png.js";
import { figureSvg } from "./figure_svg.js";
import { canRecord } from "./movie.js";

/// Offers a file to the reader; nothing leaves the page.
export function download(name, content, type) {
  const href = URL.createObjectURL(
    content instanceof Blob ? content : new Blob([content], { type }),
  );
  el("a", { href, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(href), 1000);
}

const button = (words, what, save) =>
  el("button", { type: "button", title: `Save ${what}`, onclick: save }, words);

/// Buttons for a chart's figure.
function chartButtons(block, figure) {
  const name = fileName(block.caption, block.type);
  const svg = () => download(`${name}.svg`, figureSvg(figure), "image/svg+xml");
  const png = async () => download(`${name}.png`, await pngOf(figureSvg(figure)));
  const csv = () => download(`${name}.csv`, csvOf(figureTable(block)), "text/csv");
  return [
    button("SVG", "the figure as a drawing", svg),
    button("PNG", "the figure as a picture", png),
    button("CSV", "the numbers of the figure", csv),
  ];
}

/// The button that plays a motion once and saves it as a film, and what it tells of a failure.
export function filmButton(frame, name) {
  const told = el("output", {});
  const film = button("WebM", "the motion as a film, while it plays once", async () => {
    film.disabled = true;
    told.textContent = "";
    try {
      const blob = await frame.toMovie?.();
      if (blob) download(`${name}.webm`, blob);
    } catch (error) {
      told.textContent = `No film was saved: ${error.message}`;
    } finally {
      film.disabled = false;
    }
  });
  return [film, told];
}

/// The buttons for a scene's figure, whose frame has a function `toPng(done)`, and `toMovie()`
/// where something moves.
function sceneButtons(block, figure) {
  const frame = figure.querySelector(".scene");
  const name = fileName(block.caption, "scene");
  const png = () => frame.toPng?.((blob) => download(`${name}.png`, blob));
  const buttons = [button("PNG", "the picture as it stands", png)];
  if (block.strip && canRecord()) buttons.push(...filmButton(frame, name));
  return buttons;
}

/// The figure of a block, with the buttons that save it.
export function withSaving(block, figure) {
  const buttons =
    block.type === "scene"
      ? sceneButtons(block, figure)
      : figureTable(block)
        ? chartButtons(block, figure)
        : [];
  if (buttons.length)
    figure.append(
      el("div", { class: "tools save", role: "group", "aria-label": "Save" }, ...buttons),
    );
  return figure;
}
