// Colours and materials of bodies by what they are; the same colours as in reports.

import { MeshLambertMaterial } from "three";

const SKIN = "#dfab8f";
const NAIL = "#f0d3c6";
const BONE = "#e6dcc3";
const PALM = "#7d8794";
const OBJECT = "#e6a83c";
const OBSTACLE = "#b9c0c9";
const DIGITS = ["#6fa8cf", "#8dbb95", "#c7a6d1", "#d3a15f", "#7cc0c4", "#b0a37a"];
const GLOW = 0x3a3010; // of what is selected

const isSkin = ({ role, material }) =>
  role === "link" && (material === "skin" || material === "fingertip");

/// Digits of each hand, in order of appearance, so that each keeps its colour.
function digitColors(bodies) {
  const places = new Map();
  return bodies.map(({ owner, digit }) => {
    if (!digit) return PALM;
    if (!places.has(owner)) places.set(owner, []);
    const digits = places.get(owner);
    if (!digits.includes(digit)) digits.push(digit);
    return DIGITS[digits.indexOf(digit) % DIGITS.length];
  });
}

function colorOf(body, digit) {
  if (isSkin(body)) return SKIN;
  if (body.role === "nail") return NAIL;
  if (body.role === "bone" || body.material === "bone") return BONE;
  if (body.role === "object") return OBJECT;
  if (body.role === "obstacle") return OBSTACLE;
  return digit;
}

/// Whether something of the hand stands behind its surface that a reader wants to see.
const hasInside = (scene, owner) =>
  scene.lines.length > 0 || scene.bodies.some((b) => b.owner === owner && b.role === "bone");

/// The group whose opacity the reader sets: "hands", "objects", or nothing.
const layerOf = (scene, body) => {
  if (body.role === "object") return "objects";
  return (body.role === "link" || body.role === "nail") && hasInside(scene, body.owner)
    ? "hands"
    : null;
};

/// { color, layer } of every body of a scene.
export function looksOf(scene) {
  const digits = digitColors(scene.bodies);
  return scene.bodies.map((body, i) => ({
    color: colorOf(body, digits[i]),
    layer: layerOf(scene, body),
  }));
}

export const bodyMaterial = (color) => new MeshLambertMaterial({ color });

/// What is translucent hides what stands behind it only after all that is solid has been drawn.
export function setOpacity(mesh, opacity) {
  const { material } = mesh;
  material.transparent = opacity < 1;
  material.opacity = opacity;
  material.depthWrite = opacity === 1;
  material.needsUpdate = true;
  mesh.castShadow = opacity > 0.2;
  // Where the surface is seen through, its nearest layer alone is drawn: see `veil`.
  if (mesh.userData.veil) mesh.userData.veil.visible = opacity < 1;
  mesh.renderOrder = opacity < 1 ? 3 : 0;
}

export const setGlow = (mesh, on) => mesh.material.emissive.setHex(on ? GLOW : 0);
