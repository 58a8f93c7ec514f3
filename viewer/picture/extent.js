// How much room the items of a scene take, before anything is built.

import { Box3, Vector3 } from "three";
import { isComplete } from "./items.js";
import { expandByMesh } from "./meshes.js";
import { shapeReach } from "./shapes.js";

const along = (from, vector, factor) => from.map((value, i) => value + factor * vector[i]);

function unit(v) {
  const length = Math.hypot(...v) || 1;
  return v.map((value) => value / length);
}

/// Points that an item reaches, as [x, y, z].
function reach(item) {
  if (item.kind === "segment") return [item.a, item.b];
  if (item.kind === "arrow") return [item.from, along(item.from, item.vector, 1)];
  if (item.kind === "cone") return [item.tip, along(item.tip, item.axis, 1)];
  if (item.kind === "axis")
    return [-0.5, 0.5].map((s) => along(item.point, unit(item.direction), s * (item.length ?? 0)));
  if (item.kind === "surface")
    return [-1, 1].map((s) => item.center.map((value) => value + s * shapeReach(item)));
  return item.vertices ?? item.positions;
}

/// The box around all complete items, hidden layers included so that switching them on does not
/// move the view. Layers with `fit` false do not count.
export function extentOf(layers) {
  const box = new Box3();
  const point = new Vector3();
  const fitted = layers.filter(({ fit }) => fit !== false);
  for (const item of fitted.flatMap((layer) => layer.items).filter(isComplete)) {
    if (item.kind === "mesh") {
      expandByMesh(box, item);
      continue;
    }
    for (const p of reach(item)) box.expandByPoint(point.fromArray(p));
    if (item.radius && item.kind === "segment")
      for (const p of [item.a, item.b])
        for (const s of [-1, 1]) box.expandByPoint(point.fromArray(p).addScalar(s * item.radius));
  }
  return box;
}

export const diagonal = (box) => (box.isEmpty() ? 1 : box.getSize(new Vector3()).length() || 1);
