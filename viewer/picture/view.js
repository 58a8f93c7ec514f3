// One 3D view: a canvas in a container, drawn when something changes and not before.

import { Scene, Vector3 } from "three";
import { fitCamera, makeCamera, setAspect, slanted } from "./camera_fit.js";
import { addControls, turnByKeys } from "./controls.js";
import { diagonal, extentOf } from "./extent.js";
import { buildGrid } from "./grid.js";
import { addPanel } from "./gui.js";
import { buildLayers } from "./items.js";
import { addLights } from "./lights.js";
import { drawLabels, drawScaleBar, drawTriad } from "./overlay.js";
import { link } from "./linked.js";
import { pick } from "./pick.js";
import { renderTo, sharedRenderer } from "./renderer.js";

function makeCanvas(container) {
  const canvas = document.createElement("canvas");
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "img");
  const keys = "arrow keys turn, plus and minus zoom, 0 fits";
  canvas.setAttribute("aria-label", `${container.dataset.label ?? "3D view"}; ${keys}`);
  container.append(canvas);
  return canvas;
}

/// Where a sun must stand; nothing for scenes without meshes.
function sunFor(layers, box, size, from) {
  const meshes = layers.some(({ items }) => items.some(({ kind }) => kind === "mesh"));
  if (!meshes || box.isEmpty()) return null;
  return { from, center: box.getCenter(new Vector3()), radius: 0.75 * size };
}

/// Builds everything that does not depend on the canvas. The grid is not shown where something else
/// stands for the floor.
function assemble({ layers, up = [0, 0, 1], view }) {
  const box = extentOf(layers);
  const size = diagonal(box);
  const upward = new Vector3(...up).normalize();
  const scene = new Scene();
  const camera = makeCamera(upward);
  const built = buildLayers(layers, size);
  const { grid } = buildGrid(box, size, upward);
  grid.visible = layers.every(({ fit }) => fit !== false);
  scene.add(grid, ...built.map((layer) => layer.group));
  const from = view ? new Vector3(...view).normalize() : slanted(upward);
  addLights(scene, camera, upward, sunFor(layers, box, size, from));
  return {
    scene,
    camera,
    box,
    grid,
    layers: built,
    show: { labels: true },
    from,
  };
}

/// Boxes of the picture that the panel covers, in CSS pixels.
function coveredBy(panel) {
  if (!panel) return [];
  const { offsetLeft: left, offsetTop: top, offsetWidth, offsetHeight } = panel.domElement;
  return [{ left, top, right: left + offsetWidth, bottom: top + offsetHeight }];
}

/// Draws the scene and what is written on it, with so many device pixels to each of CSS.
function paint(view, context, theme, { unit = "mm", compact, axes }, ratio, covered) {
  const { canvas } = context;
  const size = { width: canvas.width / ratio, height: canvas.height / ratio };
  const look = { ...theme(), ...size, compact };
  renderTo(context, view.scene, view.camera);
  context.save();
  context.scale(ratio, ratio);
  const labels = view.layers
    .filter((layer) => layer.group.visible)
    .flatMap((layer) => layer.labels);
  if (view.show.labels) drawLabels(context, labels, view.camera, look, covered);
  if (!compact) drawTriad(context, view.camera, look, axes);
  drawScaleBar(context, view.camera, unit, look);
  context.restore();
}

/// Makes all lines wider, which are counted in device pixels.
function widenLines(scene, factor) {
  scene.traverse(({ material }) => {
    if (material?.isLineMaterial) material.linewidth *= factor;
  });
}

/// The present view as a new canvas on the page's colour, `size` in CSS pixels, `ratio` pixels to
/// each: to be printed or saved.
function pictureOf(view, size, theme, spec, ratio) {
  const canvas = document.createElement("canvas");
  canvas.width = Math.max(1, Math.round(size.width * ratio));
  canvas.height = Math.max(1, Math.round(size.height * ratio));
  const context = canvas.getContext("2d");
  const factor = ratio / devicePixelRatio;
  widenLines(view.scene, factor);
  setAspect(view.camera, canvas.width / canvas.height);
  paint(view, context, theme, spec, ratio, []);
  widenLines(view.scene, 1 / factor);
  context.globalCompositeOperation = "destination-over";
  context.fillStyle = theme().page;
  context.fillRect(0, 0, canvas.width, canvas.height);
  return canvas;
}

/// A small picture from where the view began, whatever the reader has done to it since.
function stillOf(view, size, theme, spec, ratio) {
  const camera = view.camera.clone(false);
  fitCamera(camera, view.box, size.width / size.height, view.from);
  return pictureOf({ ...view, camera }, size, theme, { ...spec, compact: true }, ratio);
}

/// Sets the canvas to the size of its container, in device pixels.
function resize(canvas, container) {
  canvas.width = Math.max(1, Math.round(container.clientWidth * devicePixelRatio));
  canvas.height = Math.max(1, Math.round(container.clientHeight * devicePixelRatio));
  return canvas.width / canvas.height;
}

/// Calls `work` at most once a frame.
function oncePerFrame(work) {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      work();
    });
  };
}

/// Draws `spec` = { layers, unit, up, view, compact, axes } into `container`; `theme()` returns the
/// colours { ink, page }. Returns the view: draw(), paintNow() that does so at once, fit(),
/// picture(ratio), still(size, ratio), at(event) as pick() tells what is below the pointer, its
/// layers, its canvas, and `lost`, the number of items with missing coordinates.
/// Throws where the browser has no WebGL.
export function mountScene(container, spec, theme) {
  sharedRenderer();
  const canvas = makeCanvas(container);
  const context = canvas.getContext("2d");
  const view = assemble(spec);
  const paintNow = () => paint(view, context, theme, spec, devicePixelRatio, coveredBy(view.panel));
  view.draw = oncePerFrame(paintNow);
  const shown = () => ({ width: container.clientWidth, height: container.clientHeight });
  view.picture = (ratio) => pictureOf(view, shown(), theme, spec, ratio);
  view.still = (size, ratio) => stillOf(view, size, theme, spec, ratio);
  view.paintNow = paintNow;
  view.canvas = canvas;
  view.at = ({ clientX, clientY }) => {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const place = { x: (2 * (clientX - left)) / width - 1, y: 1 - (2 * (clientY - top)) / height };
    return pick(view, place, height / 2);
  };
  const controls = addControls(view.camera, canvas, view.draw);
  view.fit = () => {
    controls.target.copy(fitCamera(view.camera, view.box, canvas.width / canvas.height, view.from));
    controls.update();
    view.draw();
  };
  canvas.addEventListener("dblclick", view.fit);
  turnByKeys(controls, canvas, view.fit);
  resize(canvas, container);
  view.fit();
  if (!spec.compact) view.panel = addPanel(container, view);
  if (spec.link) link(spec.link, view, controls);
  new ResizeObserver(() => {
    if (!container.clientWidth) return;
    setAspect(view.camera, resize(canvas, container));
    paintNow();
  }).observe(container);
  view.lost = view.layers.reduce((sum, layer) => sum + layer.lost, 0);
  return view;
}
