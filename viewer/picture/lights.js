// Soft light from above, and one lamp that goes with the camera so that no view is dark. Scenes of
// meshes have a sun besides, which casts shadows.

import { DirectionalLight, HemisphereLight, Vector3 } from "three";

const MAP = 1024; // [px] of the shadow's map

/// A lamp over the shoulder of the first view, whose shadows cover a ball about the scene.
function addSun(scene, { up, from, center, radius }) {
  const sun = new DirectionalLight(0xffffff, 1.9);
  const side = new Vector3().crossVectors(up, from);
  const way = from.clone().addScaledVector(up, 1.3).addScaledVector(side, -0.8).normalize();
  sun.position.copy(center).addScaledVector(way, 2 * radius);
  sun.target.position.copy(center);
  sun.castShadow = true;
  sun.shadow.mapSize.set(MAP, MAP);
  const reach = { left: -radius, right: radius, top: radius, bottom: -radius };
  Object.assign(sun.shadow.camera, reach, { near: 0.2 * radius, far: 4 * radius });
  sun.shadow.normalBias = (4 * radius) / MAP;
  sun.shadow.radius = 4;
  scene.add(sun, sun.target);
}

/// `sun` = { from, center, radius } where there are shadows.
export function addLights(scene, camera, up, sun) {
  const sky = new HemisphereLight(0xffffff, 0x8a8f99, sun ? 1.3 : 1.6);
  sky.position.copy(up);
  const lamp = new DirectionalLight(0xffffff, sun ? 0.7 : 1.8);
  lamp.position.set(-0.6, 0.8, 1);
  camera.add(lamp);
  scene.add(sky, camera);
  if (sun) addSun(scene, { ...sun, up });
}
