// How the reader turns the scene, without trapping the scrolling of the page.

import { OrbitControls } from "three/addons/controls/OrbitControls.js";

/// Calls `draw` on every change. The wheel zooms only once the canvas has the focus.
export function addControls(camera, canvas, draw) {
  const controls = new OrbitControls(camera, canvas);
  controls.enableDamping = false;
  controls.enableZoom = false;
  controls.listenToKeyEvents(canvas);
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
