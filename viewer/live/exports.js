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

const MOST_PICTURES = 600; // of a film that is saved as pictures

/// A canvas that shows what the stage does; take() brings it up to date, over `page` where a colour is given.
function copyOf({ canvas, words }, page) {
  const copy = document.createElement("canvas");
  copy.width = words.width;
  copy.height = words.height;
  const context = copy.getContext("2d");
  const take = () => {
    context.clearRect(0, 0, copy.width, copy.height);
    if (page) {
      context.fillStyle = page;
      context.fillRect(0, 0, copy.width, copy.height);
    }
    context.drawImage(canvas, 0, 0, copy.width, copy.height);
    context.drawImage(words, 0, 0, copy.width, copy.height);
  };
  return { copy, take };
}

/// Records WebM.
function recordFilm(stage) {
  const { copy, take } = copyOf(stage);
  const film = record(copy, themeColor("--page"));
  const frame = () => {
    take();
    film.frame();
  };
  const end = async (name) => {
    film.stop();
    const blob = await film.film;
    download(`${name}.webm`, blob);
    return blob.size;
  };
  return { frame, end };
}

/// Keeps pictures, and saves them as PNG, a file each, in their order.
function keepPictures(stage) {
  const { copy, take } = copyOf(stage, themeColor("--page"));
  const pictures = [];
  const frame = () => {
    if (pictures.length >= MOST_PICTURES) return;
    take();
    pictures.push(new Promise((done) => copy.toBlob(done, "image/png")));
  };
  const end = async (name) => {
    const blobs = await Promise.all(pictures);
    blobs.forEach((blob, i) => download(`${name}_${String(i + 1).padStart(4, "0")}.png`, blob));
    return blobs.length;
  };
  return { frame, end };
}

/// Begins a film of every picture that is drawn, as WebM, or as pictures where the browser cannot record;
/// returns a function that ends it and promises that the files were offered.
export function startFilm({ stage }) {
  const { frame, end } = canRecord() ? recordFilm(stage) : keepPictures(stage);
  stage.painted.push(frame);
  stage.draw();
  return (name) => {
    stage.painted.splice(stage.painted.indexOf(frame), 1);
    return end(name);
  };
}
