// Colours and materials of bodies by what they are; the same colours as in reports.

import { MeshLambertMaterial, NotEqualStencilFunc, ReplaceStencilOp } from "three";

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

/// Returns true if parts inside of the hand must be visible through its surface.
const hasInside = (scene, owner) =>
  scene.lines.length > 0 || scene.bodies.some((b) => b.owner === owner && b.role === "bone");

/// The group whose opacity the reader sets: "hands", "objects", or nothing.
const layerOf = (scene, body) => {
  if (body.role === "object") return "objects";
  return (body.role === "link" || body.role === "nail") && hasInside(scene, body.owner)
    ? "hands"
    : null;
};

/// Stencil value of a layer's surfaces; 0 for what is drawn on top of them.
const onceOf = (body, layer) => (body.role === "nail" ? 0 : ({ hands: 1, objects: 2 }[layer] ?? 0));

/// { color, layer, once } of every body of a scene.
export function looksOf(scene) {
  const digits = digitColors(scene.bodies);
  return scene.bodies.map((body, i) => {
    const layer = layerOf(scene, body);
    return { color: colorOf(body, digits[i]), layer, once: onceOf(body, layer) };
  });
}

export const bodyMaterial = (color) =>
  new MeshLambertMaterial({
    color,
    stencilFunc: NotEqualStencilFunc,
    stencilZPass: ReplaceStencilOp,
  });

/// Of what is translucent the nearest surface alone is seen. In a fine picture a veil that writes depth is
/// drawn before it. In a plain one, where drawing twice costs too much, bodies are drawn in the order of
/// `nearness`, from 0 to 1, and what a layer has covered it does not cover again, nails apart.
export function layer(mesh, fine, nearness = 0) {
  const { material, userData } = mesh;
  const through = material.opacity < 1;
  if (userData.veil) userData.veil.visible = through && fine;
  material.depthWrite = !through || !fine;
  material.stencilWrite = through && !fine && userData.once > 0;
  material.stencilRef = userData.once;
  mesh.renderOrder = through ? 3 + nearness : 0;
}

/// Sets the opacity; translucent surfaces are drawn after all solid ones.
export function setOpacity(mesh, opacity) {
  const { material } = mesh;
  material.transparent = opacity < 1;
  material.opacity = opacity;
  material.needsUpdate = true;
  mesh.castShadow = opacity > 0.2;
  layer(mesh, true);
}

export const setGlow = (mesh, on) => mesh.material.emissive.setHex(on ? GLOW : 0);
