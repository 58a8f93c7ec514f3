// How the reader turns the scene, without trapping the scrolling of the page.

import { OrbitControls } from "three/addons/controls/OrbitControls.js";

/// Calls `draw` on every change. The wheel zooms only once the canvas has the focus.
export function addControls(camera, canvas, draw) {
  const controls = new OrbitControls(camera, canvas);
  controls.enableDamping = false;
  controls.enableZoom = false;
  canvas.style.touchAction = "pan-y";
  canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
  canvas.addEventListener("focus", () => {
    controls.enableZoom = true;
  });
  canvas.addEventListener("blur", () => {
    controls.enableZoom = false;
  });
  controls.addEventListener("change", draw);
  return controls;
}

const TURN = Math.PI / 24; // a press of an arrow key [rad]
const ZOOM = 1.15; // a press of plus

/// Arrow keys turn the scene, plus and minus zoom, 0 and Home fit; with Ctrl, Alt or Meta they keep
/// what they do in the browser.
export function turnByKeys(controls, canvas, fit) {
  // What three.js calls dollying out makes an orthographic picture larger.
  const keys = {
    ArrowLeft: () => controls.rotateLeft(TURN),
    ArrowRight: () => controls.rotateLeft(-TURN),
    ArrowUp: () => controls.rotateUp(TURN),
    ArrowDown: () => controls.rotateUp(-TURN),
    "+": () => controls.dollyOut(ZOOM),
    "=": () => controls.dollyOut(ZOOM),
    "-": () => controls.dollyIn(ZOOM),
    0: fit,
    Home: fit,
  };
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || !Object.hasOwn(keys, event.key)) return;
    event.preventDefault();
    keys[event.key]();
  });
}
