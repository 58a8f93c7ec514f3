// The picture that fills the window: scene, camera, lights, drawn when something changes and not before.

import { Box3, Group, PCFShadowMap, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { makeCamera, slanted } from "../../scene/camera_fit.js";
import { buildGrid } from "../../scene/grid.js";
import { addLights } from "../../scene/lights.js";
import { drawLabels, drawScaleBar, drawTriad } from "../../scene/overlay.js";
import { addCamera } from "./stage_camera.js";

const UP = new Vector3(0, 0, 1);
const EMPTY = new Box3(new Vector3(-0.15, -0.15, 0), new Vector3(0.15, 0.15, 0.15)); // [m]
const SLOW = 45; // where pictures take longer they are plain while things move [ms]
const PLAIN = 0.6; // pixels of a plain picture to each of a fine one, along either side
const REST = 250; // until the picture counts as at rest [ms]

function makeRenderer(canvas) {
  const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  renderer.setPixelRatio(1);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false;
  return renderer;
}

/// Whether the processor draws in place of a graphics card.
function drawsInSoftware(renderer) {
  const gl = renderer.getContext();
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  return /swiftshader|llvmpipe|software|basic render/i.test(String(name));
}

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

/// Draws what stands on the picture: labels, triad and scale bar, in the part that no panel covers.
function overlay(stage, context, theme) {
  const { width, height, insets } = stage;
  const ratio = stage.ratio;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  const look = { ...theme(), width, height };
  drawLabels(context, stage.labels(), stage.camera, look, stage.covered());
  context.translate(insets.left, -insets.bottom);
  drawTriad(context, stage.camera, look);
  // The bar is drawn in millimetres: a camera that is a thousand times as wide says so.
  const { left, right, zoom } = stage.camera;
  context.translate(-insets.left - insets.right, 0);
  drawScaleBar(context, { left: 1e3 * left, right: 1e3 * right, zoom }, "mm", look);
}

/// Calls `work(now)` at most once a frame of the screen.
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

/// Gives a stage the functions paintNow(fine) and draw().
function addPainting(stage, theme) {
  const { canvas, words, renderer, scene, camera } = stage;
  const software = drawsInSoftware(renderer);
  let resting = null;

  const setPixels = (share) => {
    const [width, height] = [stage.width, stage.height].map((n) =>
      Math.max(1, Math.round(n * stage.ratio * share)),
    );
    if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
  };

  /// Draws at once: fine, with shadows and all pixels, or plain. Where drawing is slow pictures are plain
  /// while things move, and fine once they rest.
  stage.paintNow = (fine = !(software || stage.cost > SLOW)) => {
    const begin = performance.now();
    setPixels(fine ? 1 : PLAIN);
    const shadows = stage.shown.shadows && fine;
    renderer.shadowMap.needsUpdate = shadows;
    stage.sun.castShadow = shadows;
    for (const prepare of stage.preparing) prepare();
    renderer.render(scene, camera);
    overlay(stage, words.getContext("2d"), theme);
    if (fine) stage.cost = 0.5 * stage.cost + 0.5 * (performance.now() - begin);
    ++stage.paints;
    for (const told of stage.painted) told();
    clearTimeout(resting);
    if (!fine) resting = setTimeout(() => stage.paintNow(true), REST);
  };
  stage.draw = oncePerFrame(() => stage.paintNow());
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
  const renderer = makeRenderer(canvas);
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
    paints: 0,
    cost: 0, // of the last picture [ms]
  };
  addPainting(stage, theme);

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
    stage.aim();
    stage.paintNow();
  };
  addCamera(stage);
  stage.look(new Box3());
  stage.fit();
  new ResizeObserver(resize).observe(container);
  resize();
  return stage;
}
