// Contacts as points with friction cones, and arrows for forces and moments.

import {
  ConeGeometry,
  CylinderGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
import { niceStep } from "../../numbers/ticks.js";

const Y = new Vector3(0, 1, 0);
const CONTACT = "#b3261e";
const FORCE = "#d55e00";
const ARROWS = {
  force: FORCE,
  moment: "#993366",
  axis: "#777777",
  measured: "#0072b2",
  predicted: "#d55e00",
  disturbance: "#cc79a7",
};
// Radii of arrows, in sizes of the scene: a prediction that is right lies within what was measured.
const THICK = {
  ...{ force: 0.0045, moment: 0.0045, axis: 0.0022 },
  ...{ measured: 0.006, predicted: 0.0035, disturbance: 0.0045 },
};
const LONGEST = 0.3; // of the largest arrow, in sizes of the scene
const ARROW = 6; // in the order of drawing
const SEEN = 0.01; // shorter arrows have no words, in sizes of the scene
const LEAST = 1e-6; // of the largest tension, or of 1 N: forces below are not drawn
const CONE = 0.05; // height of friction cones, in sizes of the scene

/// The size of a force up to which it is what rounding leaves of none [N], under `tensions` [N].
export const leastForce = (tensions = []) =>
  LEAST * tensions.reduce((most, t) => (t > most ? t : most), 1);

/// The length on the picture of one unit [m], round, so that the largest vector is LONGEST of the size;
/// `before` stays while the largest fits and is not small, and where the largest is no more than `least`.
export function arrowScale(largest, size, before, least = 0) {
  if (!(largest > least)) return before ?? null;
  const wanted = (LONGEST * size) / largest;
  if (before && before <= wanted * 1.001 && before > 0.2 * wanted) return before;
  const round = 1 / niceStep(1 / wanted);
  return round;
}

/// Room for as many copies as are asked for; it grows.
function pool(parent, geometry, material, order = 4) {
  let mesh = null;
  const ensure = (count) => {
    if (mesh && mesh.instanceMatrix.count >= count) return mesh;
    mesh?.removeFromParent();
    mesh?.dispose();
    mesh = new InstancedMesh(geometry, material, Math.max(16, 2 * count));
    mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    mesh.frustumCulled = false;
    mesh.raycast = () => {};
    mesh.renderOrder = order;
    parent.add(mesh);
    return mesh;
  };
  return (matrices) => {
    const target = ensure(matrices.length);
    matrices.forEach((matrix, i) => target.setMatrixAt(i, matrix));
    target.count = matrices.length;
    target.visible = matrices.length > 0; // else its program is translated for nothing
    target.instanceMatrix.needsUpdate = true;
  };
}

/// From unit geometry along y to a cylinder or cone of this radius between two points.
function between(from, to, radius) {
  const way = to.clone().sub(from);
  const length = way.length();
  const turn = new Quaternion().setFromUnitVectors(Y, way.divideScalar(length || 1));
  const middle = from.clone().add(to).multiplyScalar(0.5);
  return new Matrix4().compose(middle, turn, new Vector3(radius, length, radius));
}

/// Shafts and heads of arrows of one colour.
function arrowPool(parent, color, order = ARROW) {
  // Arrows are seen through whatever stands before them.
  const look = { depthTest: false, transparent: true };
  const material = new MeshLambertMaterial({
    ...look,
    color,
    emissive: color,
    emissiveIntensity: 0.25,
  });
  const shafts = pool(parent, new CylinderGeometry(1, 1, 1, 10), material, order);
  const heads = pool(parent, new ConeGeometry(1, 1, 14), material, order);
  return (arrows, radius) => {
    const parts = arrows
      .filter(({ vector }) => vector.lengthSq() > 0)
      .map(({ from, vector }) => {
        const tip = from.clone().add(vector);
        const head = Math.min(7 * radius, 0.5 * vector.length());
        const neck = tip.clone().addScaledVector(vector.clone().normalize(), -head);
        return [between(from, neck, radius), between(neck, tip, 2.6 * radius)];
      });
    shafts(parts.map(([shaft]) => shaft));
    heads(parts.map(([, head]) => head));
  };
}

/// A cone from a contact's point along the force that friction allows: along the normal from b on a.
function coneAt({ point, normal, friction }, height) {
  const from = new Vector3(...point);
  const to = from.clone().addScaledVector(new Vector3(...normal), height);
  // The geometry's tip is at +y: it is laid from the wide end to the tip.
  return between(to, from, Math.min(friction, 2) * height);
}

/// Contacts under `parent`: pose(frame) draws, `size` of the scene [m].
export function makeContacts(parent) {
  const group = new Group();
  const cones = new Group();
  parent.add(group);
  group.add(cones);
  const dots = new MeshBasicMaterial({ color: CONTACT, depthTest: false, transparent: true });
  const points = pool(group, new SphereGeometry(1, 12, 8), dots, ARROW);
  const coneMaterial = new MeshLambertMaterial({
    ...{ color: CONTACT, transparent: true, opacity: 0.3, side: DoubleSide, depthWrite: false },
  });
  const coneCopies = pool(cones, new ConeGeometry(1, 1, 24, 1, true), coneMaterial);
  const forces = arrowPool(group, FORCE);
  const show = { contacts: true, cones: true, forces: true };
  let scale = null;

  const pose = ({ contacts }, size) => {
    const shown = show.contacts ? contacts : [];
    const radius = 0.006 * size;
    points(
      shown.map(({ point }) =>
        new Matrix4().makeTranslation(...point).scale(new Vector3(radius, radius, radius)),
      ),
    );
    coneCopies(
      show.cones ? shown.filter((c) => c.friction > 0).map((c) => coneAt(c, CONE * size)) : [],
    );
    const largest = Math.max(0, ...contacts.map(({ force }) => Math.hypot(...force)));
    const least = leastForce();
    scale = arrowScale(largest, size, scale, least);
    const arrows = show.forces && scale ? contacts : [];
    forces(
      arrows.map(({ point, force }) => ({
        from: new Vector3(...point),
        vector: new Vector3(...force).multiplyScalar(scale),
      })),
      0.004 * size,
    );
    return { forceScale: largest > least ? scale : null };
  };
  return { pose, show, forget: () => (scale = null) };
}

/// Returns the quantity of an arrow; arrows of one quantity share a scale.
const unitOf = ({ kind, name }) => {
  const turns = kind === "moment" || /moment/i.test(name);
  if (kind === "disturbance") return turns ? "disturbance moment" : "disturbance";
  return turns ? "moment" : kind === "axis" ? "axis" : "force";
};

/// Over the object's radius [m] a disturbance's moment is a force, and has the scale of one; returns the
/// moments of which this is so.
function overRadius(arrows, radius) {
  const turns = radius ? arrows.filter(({ unit }) => unit === "disturbance moment") : [];
  for (const arrow of turns) {
    arrow.vector.divideScalar(radius);
    arrow.unit = "disturbance";
  }
  return turns;
}

/// Up to which size arrows are what rounding leaves, by their unit; a disturbance has the size 1.
function leastOf(tensions, size) {
  const force = leastForce(tensions);
  const [moment, disturbance] = [force * size, LEAST];
  return { force, moment, disturbance, "disturbance moment": LEAST * size };
}

/// Arrows that a scene names, one colour a kind; pose(frame, size) returns the tips of those that are seen.
/// radius(r) is the length [m] that moments of a disturbance are divided by, null where none is known:
/// then they have a scale of their own.
export function makeVectors(parent) {
  const group = new Group();
  parent.add(group);
  const pools = Object.fromEntries(
    Object.entries(ARROWS).map(([kind, color]) => [
      kind,
      arrowPool(group, color, kind === "predicted" ? ARROW + 0.5 : ARROW),
    ]),
  );
  let kinds = [];
  let scales = {};
  let radius = null;
  let drawn = false; // whether a moment over the radius is

  const show = (scene) => {
    kinds = scene.arrows.map((arrow) => ({ kind: arrow.kind, unit: unitOf(arrow) }));
    scales = {};
    radius = null;
  };
  const pose = ({ arrows, tensions }, size) => {
    const all = kinds.map(({ kind, unit }, i) => ({
      kind,
      unit,
      from: new Vector3(...arrows.subarray(6 * i, 6 * i + 3)),
      vector: new Vector3(...arrows.subarray(6 * i + 3, 6 * i + 6)),
    }));
    const turns = overRadius(all, radius);
    const least = leastOf(tensions, size);
    for (const unit of Object.keys(least)) {
      const largest = Math.max(
        0,
        ...all.filter((a) => a.unit === unit).map((a) => a.vector.length()),
      );
      scales[unit] = arrowScale(largest, size, scales[unit], least[unit]);
    }
    for (const { unit, vector } of all) {
      if (unit === "axis") vector.setLength(vector.length() > 0 ? 0.12 * size : 0);
      else vector.multiplyScalar(vector.length() > least[unit] ? (scales[unit] ?? 0) : 0);
    }
    drawn = turns.some(({ vector }) => vector.lengthSq() > 0);
    for (const [kind, draw] of Object.entries(pools))
      draw(
        all.filter((arrow) => arrow.kind === kind),
        THICK[kind] * size,
      );
    if (!group.visible) return [];
    return all
      .map(({ from, vector }, i) => ({
        position: from.clone().add(vector),
        long: vector.length(),
        i,
      }))
      .filter(({ long }) => long > SEEN * size);
  };
  return {
    ...{ show, pose, visible: (on) => (group.visible = on), radius: (length) => (radius = length) },
    momentRadius: () => (drawn ? radius : null),
  };
}
