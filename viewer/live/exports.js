// Files that leave the page: pictures, drawings of charts, glTF, films.

import { figureSvg } from "../report/figure_svg.js";
import { fileName } from "../report/figure_csv.js";
import { canRecord, record } from "../report/movie.js";
import { download } from "../report/save.js";
import { themeColor } from "../report/theme.js";

/// The picture as it stands, as PNG.
export const savePng = (picture, name) =>
  new Promise((done) =>
    picture.stage.picture().toBlob((blob) => {
      download(`${name}.png`, blob);
      done(blob.size);
    }, "image/png"),
  );

/// Every chart of the page that is shown, a file each; returns how many there were.
export function saveCharts() {
  const figures = [...document.querySelectorAll("figure.figure")].filter(
    (figure) => figure.offsetParent && [...figure.querySelectorAll(".chart")].some((f) => f.toSvg),
  );
  for (const figure of figures) {
    const caption = figure.querySelector("figcaption")?.textContent ?? "";
    download(`${fileName(caption, "chart")}.svg`, figureSvg(figure), "image/svg+xml");
  }
  return figures.length;
}

export async function saveGltf(ask, name) {
  const made = await ask("picture.gltf");
  if (made) download(`${name}.gltf`, made.gltf, "model/gltf+json");
  return Boolean(made);
}

/// Begins a film of every picture that is drawn; returns a function that ends it and promises the file, or
/// null where the browser cannot record.
export function startFilm(picture) {
  if (!canRecord()) return null;
  const { stage } = picture;
  const copy = document.createElement("canvas");
  copy.width = stage.words.width;
  copy.height = stage.words.height;
  const context = copy.getContext("2d");
  const film = record(copy, themeColor("--page"));
  const take = () => {
    context.clearRect(0, 0, copy.width, copy.height);
    context.drawImage(stage.canvas, 0, 0, copy.width, copy.height);
    context.drawImage(stage.words, 0, 0, copy.width, copy.height);
    film.frame();
  };
  stage.painted.push(take);
  stage.draw();
  return async (name) => {
    stage.painted.splice(stage.painted.indexOf(take), 1);
    film.stop();
    const blob = await film.film;
    download(`${name}.webm`, blob);
    return blob.size;
  };
}
