// From the items of a scene to three.js objects. Knows nothing of pages, cameras or panels.

import { Color, Group, MeshLambertMaterial } from "three";
import { buildArrow, buildAxis } from "./arrows.js";
import { buildSurface } from "./shapes.js";
import { buildMesh } from "./meshes.js";
import { buildCone, buildSegment, buildPoints } from "./solids.js";
import { buildHull, buildLine, buildLines } from "./surfaces.js";

const BUILD = {
  segment: buildSegment,
  axis: buildAxis,
  arrow: buildArrow,
  hull: buildHull,
  points: buildPoints,
  line: buildLine,
  lines: buildLines,
  surface: buildSurface,
  mesh: buildMesh,
  cone: buildCone,
};

/// Whether every number of an item is one: NaN arrives as null.
export const isComplete = (value) =>
  value !== null && typeof value === "object"
    ? Object.entries(value).every(([key, part]) => key === "label" || isComplete(part))
    : value !== null && !Number.isNaN(value);

/// Colour and material, shared by all items of one colour.
function lookFor(size) {
  const looks = new Map();
  return (color) => {
    if (!looks.has(color))
      looks.set(color, {
        color: new Color(color),
        material: new MeshLambertMaterial({ color }),
        size,
      });
    return looks.get(color);
  };
}

/// One layer as a group; `labels` collects { position, text, color } for whoever writes on the
/// picture. `size` is the diagonal of the scene, from which items without a radius get one.
function buildLayer(layer, size) {
  const group = new Group();
  const labels = [];
  const look = lookFor(size);
  const complete = layer.items.filter(isComplete);
  for (const item of complete) {
    const object = BUILD[item.kind](item, look(item.color ?? layer.color));
    object.userData.item = item;
    group.add(object);
    if (item.label) labels.push({ position: object.userData.labelAt, text: item.label });
  }
  group.name = layer.name;
  group.visible = layer.visible !== false;
  return {
    group,
    labels,
    name: layer.name,
    color: layer.color,
    time: layer.time ?? null,
    lost: layer.items.length - complete.length,
  };
}

export const buildLayers = (layers, size) => layers.map((layer) => buildLayer(layer, size));
