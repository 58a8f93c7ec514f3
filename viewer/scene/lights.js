// Soft light from above, and one lamp that goes with the camera so that no view is dark.

import { DirectionalLight, HemisphereLight } from "three";

export function addLights(scene, camera, up) {
  const sky = new HemisphereLight(0xffffff, 0x8a8f99, 1.6);
  sky.position.copy(up);
  const lamp = new DirectionalLight(0xffffff, 1.8);
  lamp.position.set(-0.6, 0.8, 1);
  camera.add(lamp);
  scene.add(sky, camera);
}
