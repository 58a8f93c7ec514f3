// Tests of what surfaces of the live picture get beside their triangles, against three.js.

import assert from "node:assert/strict";
import { test } from "node:test";
import { BufferAttribute, BufferGeometry, TorusKnotGeometry } from "three";
import { boundsOf, smoothGeometry, vertexNormals } from "../live/view/surface.js";

const knot = new TorusKnotGeometry(0.03, 0.01, 60, 12);
const positions = knot.attributes.position.array;
const triangles = Uint16Array.from(knot.index.array);

test("normals and bounds are those of three.js", () => {
  const wanted = new BufferGeometry();
  wanted.setAttribute("position", new BufferAttribute(positions, 3));
  wanted.setIndex(new BufferAttribute(triangles, 1));
  wanted.computeVertexNormals();
  wanted.computeBoundingBox();
  wanted.computeBoundingSphere();
  const found = smoothGeometry({ positions, triangles });
  const normals = [found.attributes.normal.array, wanted.attributes.normal.array];
  assert.equal(normals[0].length, normals[1].length);
  normals[0].forEach((value, i) => assert.ok(Math.abs(value - normals[1][i]) < 1e-5));
  assert.deepEqual(found.boundingBox, wanted.boundingBox);
  assert.ok(found.boundingSphere.center.distanceTo(wanted.boundingSphere.center) < 1e-9);
  assert.ok(Math.abs(found.boundingSphere.radius - wanted.boundingSphere.radius) < 1e-9);
});

test("a corner without area has no direction, and is a number", () => {
  const flat = vertexNormals(new Float32Array(9), new Uint16Array([0, 1, 2]));
  assert.deepEqual([...flat], Array(9).fill(0));
});

test("a single point is its own box", () => {
  const { box, ball } = boundsOf(new Float32Array([1, 2, 3]));
  assert.deepEqual([box.min.toArray(), box.max.toArray()], [[1, 2, 3], [1, 2, 3]]);
  assert.equal(ball.radius, 0);
});
