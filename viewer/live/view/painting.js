// Scheduling and quality of rendering: full resolution and shadows at rest, reduced quality during motion on
// slow machines.

import { PCFShadowMap, WebGLRenderer } from "three";

const SLOW = 45; // where pictures take longer they are plain while things move [ms]
const PLAIN = 0.6; // pixels of a plain picture to each of the window, along either side
const REST = 250; // until the picture counts as at rest [ms]
const GRID = 0.28; // opacity of the grid
const MOST = 1.5; // pixels of the finest picture to each of the window, along either side

/// Returns true if rendering is done in software.
export function drawsInSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return true;
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(String(name));
}

/// A processor takes thrice as long for smooth edges in every picture (`antialias`): there fine pictures
/// have more pixels instead, and plain ones have rough edges.
export function makeRenderer(canvas, software) {
  const renderer = new WebGLRenderer({ canvas, antialias: !software, alpha: true, stencil: true });
  renderer.setPixelRatio(1);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false;
  return renderer;
}

/// Gives a stage the functions paintNow(fine), and draw(), which paints once in the next frame of the screen, and
/// hold(true), until which is taken back nothing is drawn: half a picture costs as much as the whole one that comes
/// behind it; setPixels() gives the canvas its size meanwhile. `overlay()` draws what stands on the picture. What is in `stage.preparing` hears before every picture
/// whether it is to be fine, what is in `stage.painted` is called after it.
export function addPainting(stage, software, overlay) {
  const { canvas, renderer, scene, camera } = stage;
  let resting = null;
  let waiting = null;
  let cost = 0; // of fine pictures [ms]
  let held = false;

  const setPixels = (fine) => {
    const share = !fine ? PLAIN : software ? MOST / stage.ratio : 1;
    const [width, height] = [stage.width, stage.height].map((n) =>
      Math.max(1, Math.round(n * stage.ratio * share)),
    );
    if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
    // Its lines are one pixel wide, whatever a pixel is.
    stage.grid.material.opacity = GRID * Math.min(MOST, share);
  };

  /// A fine picture only where none is to come: it would hold that up, and the next one after it again.
  const rest = () => {
    if (waiting === null && !stage.expecting) stage.paintNow(true);
  };
  stage.paintNow = (fine = !(software || cost > SLOW)) => {
    const begin = performance.now();
    cancelAnimationFrame(waiting);
    waiting = null;
    stage.expecting = false;
    setPixels(fine);
    const shadows = stage.shown.shadows && fine;
    renderer.shadowMap.needsUpdate = shadows;
    stage.sun.castShadow = shadows;
    for (const prepare of stage.preparing) prepare(fine);
    renderer.render(scene, camera);
    overlay();
    if (fine) cost = 0.5 * cost + 0.5 * (performance.now() - begin);
    ++stage.paints;
    for (const told of stage.painted) told();
    clearTimeout(resting);
    if (!fine) resting = setTimeout(rest, REST);
  };
  stage.draw = () => {
    if (!held) waiting ??= requestAnimationFrame(() => stage.paintNow());
  };
  stage.hold = (on) => {
    if (on === held) return;
    held = on;
    if (on) cancelAnimationFrame(waiting);
    if (on) waiting = null;
    else stage.draw();
  };
  stage.isHeld = () => held;
  stage.setPixels = () => setPixels(!software);
  /// Lets the browser translate the programs that such objects are drawn by, while other work goes on.
  stage.warm = (objects) => {
    const shadows = stage.shown.shadows && !software;
    stage.sun.castShadow = shadows;
    renderer.compile(objects, camera, scene);
  };
}
