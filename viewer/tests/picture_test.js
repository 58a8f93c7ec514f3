// Tests for picture/: what can be said without a browser.

import assert from "node:assert/strict";
import test from "node:test";
import { Box3, Vector3 } from "three";
import { fitCamera, makeCamera } from "../picture/camera_fit.js";
import { diagonal, extentOf } from "../picture/extent.js";
import { buildGrid } from "../picture/grid.js";
import { colored, colorOf } from "../picture/color_scale.js";
import { buildLayers } from "../picture/items.js";

const ITEMS = [
  { kind: "segment", a: [0, 0, 0], b: [0, 0, 40], radius: 5 },
  { kind: "axis", point: [0, 0, 40], direction: [2, 0, 0], length: 30, label: "PIP" },
  { kind: "arrow", from: [0, 0, 40], vector: [0, 10, 0], label: "2 N" },
  {
    kind: "hull",
    vertices: [
      [0, 0, 0],
      [9, 0, 0],
      [0, 9, 0],
      [0, 0, 9],
    ],
    faces: [
      [0, 2, 1],
      [0, 1, 3],
      [0, 3, 2],
      [1, 2, 3],
    ],
  },
  {
    kind: "points",
    positions: [
      [1, 2, 3],
      [4, 5, 6],
    ],
    radius: 1,
  },
  {
    kind: "line",
    positions: [
      [0, 0, 0],
      [1, 1, 1],
    ],
    dashed: true,
  },
];
const FRAME = [
  [0, 1, 0],
  [0, 0, 1],
  [1, 0, 0],
];
const surface = (shape, ...size) => ({
  kind: "surface",
  shape,
  size,
  center: [1, 2, 3],
  axes: FRAME,
});
const layer = (items) => ({ name: "layer", color: "#0072b2", items });
const boxOf = (object) => new Box3().setFromObject(object);

test("every kind of item becomes an object", () => {
  const [built] = buildLayers([layer(ITEMS)], 50);
  assert.equal(built.group.children.length, ITEMS.length);
  assert.equal(built.lost, 0);
});

test("a segment reaches from end to end, caps included", () => {
  const [{ group }] = buildLayers([layer([ITEMS[0]])], 50);
  const { min, max } = boxOf(group);
  assert.ok(min.distanceTo(new Vector3(-5, -5, -5)) < 1e-4);
  assert.ok(max.distanceTo(new Vector3(5, 5, 45)) < 1e-4);
});

// The frame's z is the scene's x, its x the scene's y, its y the scene's z.
const HALF_SIZES = [
  [surface("cylinder", 2, 7), [7, 2, 2]],
  [surface("sphere", 4), [4, 4, 4]],
  [surface("ellipsoid", 2, 3, 5), [5, 2, 3]],
  [surface("capsule", 2, 7), [9, 2, 2]],
  [surface("torus", 1, 6), [1, 7, 7]],
];
for (const [item, half] of HALF_SIZES)
  test(`a ${item.shape} stands in its frame with its size`, () => {
    const [{ group }] = buildLayers([layer([item])], 50);
    const seen = boxOf(group);
    const size = seen.getSize(new Vector3());
    assert.ok(seen.getCenter(new Vector3()).distanceTo(new Vector3(1, 2, 3)) < 0.1);
    // Facets stay inside the smooth surface, by less than a fiftieth of it.
    for (const [i, s] of size.toArray().entries())
      assert.ok(s / 2 <= half[i] + 1e-6 && s / 2 > 0.98 * half[i], `${s / 2} of ${half[i]}`);
    assert.ok(extentOf([layer([item])]).containsBox(seen));
  });

test("an item's own colour wins over its layer's", () => {
  const [{ group }] = buildLayers([layer([{ ...ITEMS[0], color: "#ff0000" }, ITEMS[0]])], 50);
  const shown = group.children.map((mesh) => mesh.material.color.getHexString());
  assert.deepEqual(shown, ["ff0000", "0072b2"]);
});

test("a value is coloured by the scale, its ends by the first and the last colour", () => {
  const scale = { low: 1, high: 3 };
  const ends = [colorOf(-5, scale), colorOf(9, scale)];
  assert.deepEqual([colorOf(1, scale), colorOf(3, scale)], ends);
  assert.notEqual(ends[0], ends[1]);
  const [{ items }] = colored([layer([{ ...ITEMS[5], value: 3 }, ITEMS[5]])], scale);
  assert.deepEqual([items[0].color, items[1].color], [ends[1], undefined]);
});

test("an axis is centred on its point, has its length, and is labelled at its head", () => {
  const [{ group, labels }] = buildLayers([layer([ITEMS[1]])], 50);
  const { min, max } = boxOf(group);
  assert.ok(Math.abs(min.x + 15) < 1e-4 && Math.abs(max.x - 15) < 1e-4);
  assert.deepEqual(labels[0].position.toArray(), [15, 0, 40]);
});

test("an arrow ends at from + vector", () => {
  const [{ labels }] = buildLayers([layer([ITEMS[2]])], 50);
  assert.deepEqual(labels[0].position.toArray(), [0, 10, 40]);
});

test("items with missing coordinates are counted, not drawn", () => {
  const broken = { kind: "segment", a: [0, null, 0], b: [0, 0, 1], radius: 1 };
  const [built] = buildLayers([layer([broken, ITEMS[4]])], 50);
  assert.equal(built.lost, 1);
  assert.equal(built.group.children.length, 1);
  assert.ok(!extentOf([layer([broken])]).containsPoint(new Vector3(0, 0, 1)));
});

test("a hidden layer still counts for the extent", () => {
  const box = extentOf([{ ...layer([ITEMS[0]]), visible: false }]);
  assert.deepEqual([box.min.z, box.max.z], [-5, 45]);
  assert.ok(Math.abs(diagonal(box) - Math.hypot(10, 10, 50)) < 1e-9);
});

test("the camera sees the whole box, from any side and in any shape of window", () => {
  const box = new Box3(new Vector3(-10, 0, 5), new Vector3(30, 8, 90));
  for (const aspect of [0.4, 1, 3])
    for (const direction of [undefined, new Vector3(1, 0, 0), new Vector3(1, 2, 3).normalize()]) {
      const camera = makeCamera(new Vector3(0, 0, 1));
      fitCamera(camera, box, aspect, direction);
      for (const x of [-10, 30])
        for (const y of [0, 8])
          for (const z of [5, 90]) {
            const seen = new Vector3(x, y, z).project(camera);
            assert.ok(
              Math.max(...seen.toArray().map(Math.abs)) <= 1,
              `corner at ${seen.toArray()}`,
            );
          }
    }
});

test("the grid lies under the scene", () => {
  const box = new Box3(new Vector3(0, 0, 5), new Vector3(10, 10, 50));
  const { grid, step } = buildGrid(box, diagonal(box), new Vector3(0, 0, 1));
  assert.ok(Math.abs(grid.position.z - 5) < 1e-9);
  assert.equal(step, 5); // diagonal 47.2: a twelfth is 3.9
});

test("an empty scene is no error", () => {
  const box = extentOf([layer([])]);
  assert.equal(diagonal(box), 1);
  fitCamera(makeCamera(new Vector3(0, 1, 0)), box, 1);
  buildGrid(box, 1, new Vector3(0, 1, 0));
});

test("a cloud of lines is translucent, and within the extent", () => {
  const item = {
    kind: "lines",
    opacity: 0.3,
    positions: [
      [0, 0, 0],
      [1, 0, 0],
      [0, 2, 0],
      [0, 2, 7],
    ],
  };
  const [{ group }] = buildLayers([layer([item])], 10);
  const { material, geometry } = group.children[0];
  assert.equal(material.opacity, 0.3);
  assert.equal(material.transparent, true);
  assert.equal(geometry.getAttribute("position").count, 4);
  assert.deepEqual(extentOf([layer([item])]).max.toArray(), [1, 2, 7]);
});

const coded = (Kind, values) =>
  btoa(String.fromCharCode(...new Uint8Array(Kind.from(values).buffer)));

// A tetrahedron with corners at 0 and at 10 along each axis, in steps of 0.1.
const TETRAHEDRON = {
  origin: [0, 0, 0],
  step: 0.1,
  vertices: coded(Int16Array, [0, 0, 0, 100, 0, 0, 0, 100, 0, 0, 0, 100]),
  triangles: coded(Uint16Array, [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]),
};

test("a mesh is decoded, placed, and shares its geometry with others of its name", () => {
  // The mesh's x is the scene's y, its y the scene's z, its z the scene's x.
  const rotation = [
    [0, 0, 1],
    [1, 0, 0],
    [0, 1, 0],
  ];
  const placed = { kind: "mesh", mesh: TETRAHEDRON, rotation, position: [5, 6, 7] };
  const [{ group }] = buildLayers([layer([placed, { kind: "mesh", mesh: TETRAHEDRON }])], 20);
  const [turned, plain] = group.children;
  assert.equal(turned.geometry, plain.geometry);
  assert.equal(turned.material, plain.material);
  const corner = new Vector3(10, 0, 0).applyMatrix4(turned.matrix);
  assert.deepEqual(corner.toArray(), [5, 16, 7]);
  const { min, max } = extentOf([layer([placed])]);
  assert.ok(min.distanceTo(new Vector3(5, 6, 7)) < 1e-5);
  assert.ok(max.distanceTo(new Vector3(15, 16, 17)) < 1e-5);
});

test("a mesh with creases is flat beside them", () => {
  const [{ group }] = buildLayers([layer([{ kind: "mesh", mesh: { ...TETRAHEDRON, crease: 30 } }])], 20);
  const { position, normal } = group.children[0].geometry.attributes;
  assert.equal(position.count, 12); // nothing shared between its four faces
  for (let i = 0; i < 3; ++i) assert.ok(Math.abs(normal.getZ(i) + 1) < 1e-6); // the face z = 0
});

test("a cone opens from its tip", () => {
  const cone = { kind: "cone", tip: [1, 2, 3], axis: [0, 0, 8], radius: 4 };
  const [{ group }] = buildLayers([layer([cone])], 20);
  const { position } = group.children[0].geometry.attributes;
  const mesh = group.children[0];
  mesh.updateMatrix();
  const point = new Vector3();
  for (let i = 0; i < position.count; ++i) {
    point.fromBufferAttribute(position, i).applyMatrix4(mesh.matrix);
    const out = Math.hypot(point.x - 1, point.y - 2);
    assert.ok(Math.abs(out - (point.z - 3) / 2) < 1e-5, `radius ${out} at ${point.z - 3}`);
  }
});

test("a layer that is not fitted does not count", () => {
  const table = { ...layer([{ kind: "mesh", mesh: TETRAHEDRON }]), fit: false };
  assert.ok(extentOf([table]).isEmpty());
});
