// Tests for picture/pick.js, the way back along the colours of picture/color_scale.js, and the words of
// report/scene_reading.js.

import assert from "node:assert/strict";
import test from "node:test";
import { Vector3 } from "three";
import { sceneReading } from "../report/scene_reading.js";
import { fitCamera, makeCamera } from "../picture/camera_fit.js";
import { colorOf, valueOf } from "../picture/color_scale.js";
import { diagonal, extentOf } from "../picture/extent.js";
import { buildLayers } from "../picture/items.js";
import { pick } from "../picture/pick.js";

const HALF = 100; // height of the picture [px]
const layer = (name, items, more = {}) => ({ name, color: "#0072b2", items, ...more });

/// A view along x, whose picture has y to the right and z up.
function viewOf(layers) {
  const box = extentOf(layers);
  const camera = makeCamera(new Vector3(0, 0, 1));
  fitCamera(camera, box, 1, new Vector3(1, 0, 0));
  camera.updateMatrixWorld();
  return { camera, layers: buildLayers(layers, diagonal(box)) };
}

const BONE = { kind: "segment", a: [0, 0, -20], b: [0, 0, 20], radius: 5, label: "PP3" };
const HULL = {
  kind: "hull",
  vertices: [
    [30, -60, -60],
    [30, 60, -60],
    [30, 0, 60],
    [40, 0, 0],
  ],
  faces: [
    [0, 1, 2],
    [0, 1, 3],
    [1, 2, 3],
    [2, 0, 3],
  ],
};

test("what is nearest to the eye is found, and where its surface is", () => {
  const front = { kind: "segment", a: [10, 0, -20], b: [10, 0, 20], radius: 2 };
  const view = viewOf([layer("bones", [BONE]), layer("nearer", [front])]);
  const found = pick(view, { x: 0, y: 0 }, HALF);
  assert.equal(found.layer.name, "nearer");
  assert.ok(Math.abs(found.point.x - 12) < 0.1, `its front is at ${found.point.x}, not at 12`);
});

test("what one sees through does not hide what is behind it", () => {
  const view = viewOf([layer("skin", [HULL]), layer("bones", [BONE])]);
  assert.equal(pick(view, { x: 0, y: 0 }, HALF).item.label, "PP3");
});

test("what one sees through is found where nothing is behind it", () =>
  assert.equal(pick(viewOf([layer("skin", [HULL])]), { x: 0, y: 0 }, HALF).layer.name, "skin"));

test("layers that are switched off are not found", () => {
  const view = viewOf([layer("bones", [BONE], { visible: false })]);
  assert.equal(pick(view, { x: 0, y: 0 }, HALF), null);
});

test("nothing is found beside everything", () =>
  assert.equal(pick(viewOf([layer("bones", [BONE])]), { x: 0.99, y: 0.99 }, HALF), null));

test("a colour of the scale tells its value, another none", () => {
  const scale = { low: 2, high: 8 };
  for (const value of [2, 3.7, 6.1, 8]) {
    const hex = colorOf(value, scale);
    const bytes = [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
    assert.ok(Math.abs(valueOf(bytes, scale) - value) < 0.02, `${value} as ${hex}`);
  }
  assert.equal(valueOf([0xdf, 0xab, 0x8f], scale), null, "skin is no value");
});

test("a reading tells name, value with its unit, and place with words of the axes", () => {
  const found = {
    layer: { name: "bands" },
    item: { label: "TE", value: 3.21432 },
    point: new Vector3(12.34, -5, 0.5),
    color: null,
  };
  const block = { color_scale: { label: "tension [N]", low: 0, high: 5 }, axes: ["distal"] };
  assert.deepEqual(sceneReading(found, block), [
    "bands: TE",
    "tension 3.21 N",
    "x (distal) 12.3, y \u22125, z 0.5 mm",
  ]);
});
