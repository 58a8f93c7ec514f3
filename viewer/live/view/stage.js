// The picture that fills the window: scene, camera, lights, drawn when something changes and not before.

import { Box3, Group, Scene, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { makeCamera, slanted } from "../../picture/camera_fit.js";
import { buildGrid } from "../../picture/grid.js";
import { addLights } from "../../picture/lights.js";
import { drawLabels, drawScaleBar, drawTriad } from "../../picture/overlay.js";
import { addPainting, drawsInSoftware, makeRenderer } from "./painting.js";
import { addCamera } from "./stage_camera.js";

const UP = new Vector3(0, 0, 1);
const EMPTY = new Box3(new Vector3(-0.15, -0.15, 0), new Vector3(0.15, 0.15, 0.15)); // [m]

/// Lights and floor for a box; those of an earlier box go.
function furnish(stage, box) {
  stage.furniture.removeFromParent();
  stage.camera.clear();
  stage.sun?.dispose();
  stage.grid?.dispose();
  const size = box.getSize(new Vector3()).length() || 1;
  stage.furniture = new Group();
  const { grid } = buildGrid(box, size, UP);
  grid.visible = stage.shown.grid;
  stage.grid = grid;
  const center = box.getCenter(new Vector3());
  const sun = { from: stage.from, center, radius: 0.75 * size };
  const lights = new Group();
  addLights(lights, stage.camera, UP, sun);
  stage.sun = lights.children.find(({ castShadow }) => castShadow);
  stage.furniture.add(grid, lights);
  stage.scene.add(stage.furniture);
}

/// All that the words on the picture depend on, as a text.
function wordsKey(stage, look, labels, covered) {
  const { camera, insets, ratio } = stage;
  const { left, right, top, bottom, zoom, view } = camera;
  const seen = [camera.matrixWorld.elements, left, right, top, bottom, zoom, view];
  return JSON.stringify([seen, look, insets, ratio, labels, covered]);
}

/// Draws what stands on the picture: labels, triad and scale bar, in the part that no panel covers. What is
/// there already is left, for the browser takes long over a canvas that covers its window.
function overlay(stage, context, theme) {
  const { width, height, insets, ratio, camera } = stage;
  const look = { ...theme(), width, height };
  const [labels, covered] = [stage.labels(), stage.covered()];
  const key = wordsKey(stage, look, labels, covered);
  if (stage.written === key) return;
  stage.written = key;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  drawLabels(context, labels, camera, look, covered);
  context.translate(insets.left, -insets.bottom);
  drawTriad(context, camera, look);
  // The bar is drawn in millimetres: a camera that is a thousand times as wide says so.
  const { left, right, zoom } = camera;
  context.translate(-insets.left - insets.right, 0);
  drawScaleBar(context, { left: 1e3 * left, right: 1e3 * right, zoom }, "mm", look);
}

/// A canvas for WebGL and one for words over it, in `container`; `theme()` returns { ink, page, muted }.
/// Returns the stage: scene, camera, controls, draw(), paintNow(), fit(box, direction), look(box),
/// setInsets(), picture(ratio), ray(event); `labels` and `covered` are functions to be replaced.
export function makeStage(container, theme) {
  const canvas = document.createElement("canvas");
  canvas.className = "gl";
  canvas.tabIndex = 0;
  const words = document.createElement("canvas");
  words.className = "words";
  words.setAttribute("aria-hidden", "true");
  container.append(canvas, words);
  const software = drawsInSoftware();
  const renderer = makeRenderer(canvas, software);
  const scene = new Scene();
  const camera = makeCamera(UP);
  const stage = {
    ...{ canvas, words, renderer, scene, camera, width: 1, height: 1, ratio: 1 },
    insets: { left: 0, right: 0, top: 0, bottom: 0 },
    furniture: new Group(),
    shown: { grid: true, shadows: true },
    from: slanted(UP),
    box: EMPTY.clone(),
    labels: () => [],
    covered: () => [],
    preparing: [], // called before every picture
    painted: [], // and after
    expecting: false, // whether whoever calls paintNow() has something to be drawn in the next frame of the screen
    paints: 0,
    written: null, // what the words on the picture were drawn of
  };
  addPainting(stage, software, () => overlay(stage, words.getContext("2d"), theme));

  const controls = new OrbitControls(camera, canvas);
  controls.enableDamping = false;
  controls.addEventListener("change", stage.draw);
  stage.controls = controls;

  stage.look = (box) => {
    stage.box = box.isEmpty() ? EMPTY.clone() : box;
    furnish(stage, stage.box);
    stage.draw();
  };
  stage.picture = () => {
    stage.paintNow(true);
    const copy = document.createElement("canvas");
    copy.width = words.width;
    copy.height = words.height;
    const context = copy.getContext("2d");
    context.fillStyle = theme().page;
    context.fillRect(0, 0, copy.width, copy.height);
    context.drawImage(canvas, 0, 0, copy.width, copy.height);
    context.drawImage(words, 0, 0);
    return copy;
  };
  const resize = () => {
    stage.width = Math.max(1, container.clientWidth);
    stage.height = Math.max(1, container.clientHeight);
    stage.ratio = Math.min(2, devicePixelRatio);
    words.width = Math.round(stage.width * stage.ratio);
    words.height = Math.round(stage.height * stage.ratio);
    stage.written = null; // a canvas of another size is empty
    stage.aim();
    if (stage.isHeld()) stage.setPixels();
    else stage.paintNow();
  };
  addCamera(stage);
  stage.hold(true); // until there is something to be seen
  stage.look(new Box3());
  stage.fit();
  new ResizeObserver(resize).observe(container);
  resize();
  return stage;
}
