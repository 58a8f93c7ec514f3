// One WebGL context for every scene of a page: browsers allow only a few. A scene is rendered here,
// then copied onto the 2D canvas that the reader sees.

import { PCFShadowMap, WebGLRenderer } from "three";

let renderer = null;

/// The shared context; throws where the browser has no WebGL.
export function sharedRenderer() {
  if (renderer) return renderer;
  renderer = new WebGLRenderer({ antialias: true, alpha: true });
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  return renderer;
}

/// Renders onto the 2D canvas, at its own size in device pixels.
export function renderTo(context, scene, camera) {
  const { width, height } = context.canvas;
  const gl = sharedRenderer();
  const size = gl.domElement;
  if (size.width !== width || size.height !== height) gl.setSize(width, height, false);
  gl.render(scene, camera);
  context.clearRect(0, 0, width, height);
  context.drawImage(gl.domElement, 0, 0);
}
