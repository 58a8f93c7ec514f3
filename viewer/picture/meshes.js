// Triangle meshes as reports carry them: corners in 16-bit steps, base64, shared by all their items.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  Vector3,
} from "three";
import { toCreasedNormals } from "three/addons/utils/BufferGeometryUtils.js";

const MOST_SHORT = 65536; // vertices that 16 bits can count
const ROUGHNESS = 0.62;

const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;

/// Colours in bytes of sRGB, as three.js wants them: linear.
function linearColors(text) {
  const given = new Uint8Array(bytes(text));
  const linear = new Float32Array(given.length);
  const color = new Color();
  for (let i = 0; i < given.length; i += 3)
    color.setRGB(given[i] / 255, given[i + 1] / 255, given[i + 2] / 255, "srgb").toArray(linear, i);
  return linear;
}

function decode({ vertices, origin, step, triangles, crease, colors }) {
  const steps = new Int16Array(bytes(vertices));
  const positions = Float32Array.from(steps, (s, i) => origin[i % 3] + step * s);
  const Index = positions.length / 3 > MOST_SHORT ? Uint32Array : Uint16Array;
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  if (colors) geometry.setAttribute("color", new BufferAttribute(linearColors(colors), 3));
  geometry.setIndex(new BufferAttribute(new Index(bytes(triangles)), 1));
  if (crease === undefined) geometry.computeVertexNormals();
  else return toCreasedNormals(geometry, (crease * Math.PI) / 180);
  return geometry;
}

const decoded = new WeakMap();

/// The geometry of a mesh, made once however many items show it.
function geometryOf(mesh) {
  if (!decoded.has(mesh)) decoded.set(mesh, decode(mesh));
  return decoded.get(mesh);
}

function placement({ rotation, position = [0, 0, 0] }) {
  const [x, y, z] = rotation ?? [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const [[a, b, c], [d, e, f], [g, h, i]] = [x, y, z];
  const [u, v, w] = position;
  return new Matrix4().set(a, b, c, u, d, e, f, v, g, h, i, w, 0, 0, 0, 1);
}

/// Adds every corner of a mesh item to a box.
export function expandByMesh(box, item) {
  const matrix = placement(item);
  const { position } = geometryOf(item.mesh).attributes;
  const point = new Vector3();
  for (let i = 0; i < position.count; ++i)
    box.expandByPoint(point.fromBufferAttribute(position, i).applyMatrix4(matrix));
}

/// Light materials are shared by all items of one colour and opacity; `userData.hull` marks those
/// that are seen through, whose opacity the reader may change.
function materialOf(look, opacity, colored) {
  look.solids ??= new Map();
  const key = `${opacity} ${colored}`;
  if (!look.solids.has(key))
    look.solids.set(
      key,
      new MeshStandardMaterial({
        color: colored ? 0xffffff : look.color,
        vertexColors: colored,
        roughness: ROUGHNESS,
        transparent: opacity < 1,
        opacity,
        depthWrite: opacity === 1,
        side: opacity < 1 ? DoubleSide : 0,
      }),
    );
  return look.solids.get(key);
}

export function buildMesh(item, look) {
  const { mesh: given, opacity = 1 } = item;
  const mesh = new Mesh(geometryOf(given), materialOf(look, opacity, given.colors !== undefined));
  mesh.applyMatrix4(placement(item));
  mesh.castShadow = mesh.receiveShadow = true;
  mesh.userData.hull = opacity < 1;
  mesh.geometry.computeBoundingSphere();
  mesh.userData.labelAt = mesh.geometry.boundingSphere.center.clone().applyMatrix4(mesh.matrix);
  return mesh;
}
