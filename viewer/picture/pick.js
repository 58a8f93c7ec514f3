// What of a scene lies below the pointer.

import { Raycaster, Vector2, Vector3 } from "three";

const REACH = 5; // about a line, within which the pointer is on it [px]
const CLEAR = 0.6; // opacity, above which one does not see through

const opacityOf = (object) => (object.material?.transparent ? object.material.opacity : 1);

/// An object and all that holds it, from within.
function* outwards(object) {
  for (let up = object; up; up = up.parent) yield up;
}

/// Whether an object and all that holds it is shown.
const isShown = (object) => [...outwards(object)].every(({ visible }) => visible);

/// The item that an object was built from.
const itemOf = (object) =>
  [...outwards(object)].find(({ userData }) => userData.item)?.userData.item ?? null;

/// Whether one does not see through an object, as one does between thin lines.
const isSolid = (object) => object.isMesh === true && opacityOf(object) > CLEAR;

/// The nearest that is not seen through; where all are, the nearest of all.
const first = (hits) => hits.find(({ object }) => isSolid(object)) ?? hits[0];

/// The colour of a mesh whose corners have one, where it was hit: linear, [r, g, b]; or null.
export function colorAtHit({ object, face, point }) {
  const colors = object.geometry?.attributes?.color;
  if (!colors || !face || !object.material.vertexColors) return null;
  const { position } = object.geometry.attributes;
  const local = object.worldToLocal(point.clone());
  const corners = [face.a, face.b, face.c];
  const [a, b, c] = corners.map((i) => new Vector3().fromBufferAttribute(position, i));
  const across = b.clone().sub(a).cross(c.clone().sub(a));
  const share = (p, q) => p.sub(local).cross(q.sub(local)).dot(across) / across.lengthSq();
  const weights = [
    share(b.clone(), c.clone()),
    share(c.clone(), a.clone()),
    share(a.clone(), b.clone()),
  ];
  return [0, 1, 2].map((k) =>
    weights.reduce((sum, w, i) => sum + w * colors.getComponent(corners[i], k), 0),
  );
}

/// What lies below a place of the picture, from -1 to 1 right and up: { layer, item, point, color },
/// or null. `half` is half the height of the picture [px].
export function pick({ camera, layers }, { x, y }, half) {
  const raycaster = new Raycaster();
  raycaster.setFromCamera(new Vector2(x, y), camera);
  const reach = (REACH * (camera.top - camera.bottom)) / (2 * half * camera.zoom);
  raycaster.params.Line.threshold = reach;
  raycaster.params.Line2 = { threshold: 2 * REACH };
  const groups = layers.map(({ group }) => group).filter(({ visible }) => visible);
  groups.forEach((group) => group.updateMatrixWorld());
  const hits = raycaster.intersectObjects(groups, true).filter(({ object }) => isShown(object));
  if (!hits.length) return null;
  const hit = first(hits);
  const holders = [...outwards(hit.object)];
  const layer = layers.find(({ group }) => holders.includes(group));
  return { layer, item: itemOf(hit.object), point: hit.point, color: colorAtHit(hit) };
}
