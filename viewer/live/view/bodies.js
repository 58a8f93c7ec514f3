// Bodies of the scene: meshes that are fetched once each, and poses that come with every frame.

import { Box3, Group, Mesh, MeshBasicMaterial, Vector3 } from "three";
import { toCreasedNormals } from "three/addons/utils/BufferGeometryUtils.js";
import { decodeMesh } from "../link/frame.js";
import { coarseOf } from "./coarse.js";
import { bodyMaterial, layer, looksOf, setGlow, setOpacity } from "./looks.js";
import { smoothGeometry } from "./surface.js";

/// Smooth, or sharp at edges beyond `crease` [deg].
function geometryOf(mesh, crease) {
  const geometry = smoothGeometry(mesh);
  const creased = crease !== null && crease !== undefined && crease >= 0;
  return creased ? toCreasedNormals(geometry, (crease * Math.PI) / 180) : geometry;
}

/// Geometries by mesh and crease, fetched once; those that no scene shows any more are freed.
export function meshShelf(fetchMesh) {
  const shelf = new Map();
  const keyOf = ({ mesh, crease }) => `${mesh} ${crease}`;
  const get = (body) => {
    const key = keyOf(body);
    if (!shelf.has(key)) {
      const geometry = fetchMesh(body.mesh).then((buffer) =>
        geometryOf(decodeMesh(buffer), body.crease),
      );
      // One that could not be fetched is asked for again by the next scene.
      geometry.catch(() => shelf.delete(key));
      shelf.set(key, geometry);
    }
    return shelf.get(key);
  };
  const keepOnly = (bodies) => {
    const wanted = new Set(bodies.filter(({ mesh }) => mesh).map(keyOf));
    for (const [key, geometry] of shelf)
      if (!wanted.has(key)) {
        shelf.delete(key);
        geometry.then((made) => made.dispose()).catch(() => {});
      }
  };
  return { get, keepOnly, size: () => shelf.size };
}

/// A surface that writes depth alone, before what is translucent: of a translucent body only the
/// nearest surface is then seen, and not its own inside.
function veilOf(geometry) {
  const veil = new Mesh(geometry, new MeshBasicMaterial({ colorWrite: false }));
  veil.renderOrder = 2;
  veil.visible = false;
  veil.raycast = () => {};
  return veil;
}

function fill(group, geometry, look, index) {
  const mesh = new Mesh(geometry, bodyMaterial(look.color));
  mesh.castShadow = mesh.receiveShadow = true;
  mesh.userData = { ...look, body: index, surface: geometry, veil: veilOf(geometry) };
  group.add(mesh, mesh.userData.veil);
  group.userData.mesh = mesh;
  return mesh;
}

/// Returns the coordinate of a mesh's centre along a direction [m].
function depthOf({ geometry, matrixWorld }, way) {
  geometry.boundingSphere ?? geometry.computeBoundingSphere();
  return geometry.boundingSphere.center.clone().applyMatrix4(matrixWorld).dot(way);
}

function clear(bodies) {
  for (const group of bodies.groups) {
    group.userData.mesh?.material.dispose();
    group.userData.mesh?.userData.veil.material.dispose();
    group.removeFromParent();
  }
}

/// Prepares meshes for a fine picture, or for a plain one from this camera.
function prepare(meshes, fine, camera) {
  for (const mesh of meshes) {
    const { surface } = mesh.userData;
    mesh.geometry = fine ? surface : (surface.userData.coarse ??= coarseOf(surface));
  }
  const through = meshes.filter(({ material }) => material.opacity < 1);
  if (fine) return through.forEach((mesh) => layer(mesh, true));
  const way = camera.getWorldDirection(new Vector3());
  const depths = new Map(through.map((mesh) => [mesh, depthOf(mesh, way)]));
  through.sort((a, b) => depths.get(a) - depths.get(b));
  through.forEach((mesh, i) => layer(mesh, false, i / through.length));
}

/// Empty groups for the bodies of the next scene; until the first frame comes each stands where its namesake
/// stood.
const groupsOf = (next, { groups, hidden }) =>
  next.bodies.map(({ name, owner }, index) => {
    const group = new Group();
    group.name = name;
    group.visible = !hidden.has(owner);
    const before = groups.find((old) => old.name === name);
    if (before) group.position.copy(before.position);
    if (before) group.quaternion.copy(before.quaternion);
    group.userData.index = index;
    return group;
  });

/// Returns the bounding box of all bodies; without obstacles if there are other bodies.
function boxOf(scene, meshes) {
  const boxes = { object: new Box3(), obstacle: new Box3() };
  for (const mesh of meshes) {
    const { geometry, parent, userData } = mesh;
    geometry.boundingBox ?? geometry.computeBoundingBox();
    parent.updateMatrixWorld();
    const { role } = scene.bodies[userData.body];
    boxes[role === "obstacle" ? role : "object"].union(
      geometry.boundingBox.clone().applyMatrix4(parent.matrixWorld),
    );
  }
  return boxes.object.isEmpty() ? boxes.obstacle : boxes.object;
}

/// A solid and a translucent body of no size, by which all are drawn.
function samples() {
  const group = new Group();
  const geometry = smoothGeometry({
    positions: new Float32Array(9),
    triangles: new Uint16Array([0, 1, 2]),
  });
  for (const opacity of [1, 0.5]) setOpacity(fill(group, geometry, {}, -1), opacity);
  return group;
}

/// Bodies under `parent`. show(scene) builds, promising when all meshes are there; pose(frame) moves;
/// hide(owner, hidden), select(owner), opacity(layer, value), prepare(fine, camera), box().
export function makeBodies(parent, shelf, told) {
  const bodies = { groups: [], hidden: new Set(), opacities: { hands: 0.5, objects: 1 } };
  bodies.samples = samples();
  let scene = null;
  let selected = null;

  const dress = (mesh) => {
    const { layer } = mesh.userData;
    setOpacity(mesh, layer ? bodies.opacities[layer] : 1);
    setGlow(mesh, scene.bodies[mesh.userData.body].owner === selected);
  };
  const meshes = () => bodies.groups.flatMap(({ userData }) => userData.mesh ?? []);

  bodies.show = (next) => {
    const groups = groupsOf(next, bodies);
    clear(bodies);
    scene = next;
    bodies.groups = groups;
    for (const group of groups) parent.add(group);
    const looks = looksOf(scene);
    shelf.keepOnly(scene.bodies);
    return Promise.all(
      scene.bodies.map(async (body, i) => {
        if (!body.mesh) return;
        const geometry = await shelf.get(body);
        if (scene !== next) return;
        dress(fill(groups[i], geometry, looks[i], i));
        told();
      }),
    );
  };

  bodies.pose = ({ bodies: numbers }) =>
    bodies.groups.forEach((group, i) => {
      const at = 7 * i;
      group.position.set(numbers[at], numbers[at + 1], numbers[at + 2]);
      const [w, x, y, z] = [3, 4, 5, 6].map((step) => numbers[at + step]);
      group.quaternion.set(x, y, z, w);
      group.updateMatrixWorld();
    });

  bodies.hide = (owner, hidden) => {
    if (hidden) bodies.hidden.add(owner);
    else bodies.hidden.delete(owner);
    bodies.groups.forEach((group, i) => {
      group.visible = !bodies.hidden.has(scene.bodies[i].owner);
    });
  };
  bodies.select = (owner) => {
    selected = owner;
    meshes().forEach(dress);
  };
  bodies.opacity = (layer, value) => {
    bodies.opacities[layer] = value;
    meshes().forEach(dress);
  };
  bodies.prepare = (fine, camera) => prepare(meshes(), fine, camera);
  bodies.meshes = () => meshes().filter((mesh) => mesh.parent.visible);
  bodies.box = () => boxOf(scene, meshes());
  return bodies;
}
