// Tests for numbers/density.js and numbers/contours.js.

import assert from "node:assert/strict";
import test from "node:test";
import { bandwidth, correlation, density, regions, spreadOf } from "../numbers/density.js";
import { regionOf } from "../numbers/contours.js";
import { noise } from "../sample/random.js";

const normal = (count, sd = 1) => Array.from({ length: count }, () => noise(sd));

/// Twice the area within a ring, positive if it runs anticlockwise; by Gauss.
const area = (ring) =>
  ring.reduce((sum, [x, y], i) => {
    const [u, v] = ring[(i + 1) % ring.length];
    return sum + (x * v - u * y) / 2;
  }, 0);

test("the kernel of a normal distribution is the best one", () => {
  const best = (4 / 3) ** 0.2 * 2000 ** -0.2; // least mean integrated squared error, sd 1
  const h = bandwidth(normal(2000));
  assert.ok(Math.abs(h / best - 1) < 0.25, `${h} against ${best}`);
});

test("two far peaks do not widen the kernel", () => {
  const one = normal(1000);
  const two = one.map((v, i) => (i % 2 ? v + 40 : v - 40));
  assert.ok(bandwidth(two) < 1.5 * bandwidth(one));
  assert.ok(bandwidth(two) < 0.1 * spreadOf(two) * 1000 ** -0.2);
});

test("draws that are all alike have no density", () => {
  assert.equal(bandwidth([2, 2, 2]), 0);
  assert.deepEqual(density([2, 2, 2]), { x: [], y: [] });
});

test("a density is one in all, and as high as it should be", () => {
  const { x, y } = density(normal(4000));
  const sum = y.reduce((a, b) => a + b, 0) * (x[1] - x[0]);
  assert.ok(Math.abs(sum - 1) < 0.01);
  assert.ok(Math.abs(Math.max(...y) - 1 / Math.sqrt(2 * Math.PI)) < 0.03);
});

test("regions hold their shares, on a narrow ridge too", () => {
  const xs = normal(3000);
  const ys = xs.map((x) => 0.999 * x + noise(Math.sqrt(1 - 0.999 ** 2)));
  const { rings, outside } = regions(xs, ys, [0.9, 0.5]);
  assert.ok(Math.abs(outside.length / 3000 - 0.1) < 0.01);
  // A normal ellipse of probability p has the area -2 pi log(1 - p) sd_x sd_y sqrt(1 - r^2).
  [0.9, 0.5].forEach((p, i) => {
    const wanted = -2 * Math.PI * Math.log(1 - p) * Math.sqrt(1 - 0.999 ** 2);
    const got = rings[i].reduce((sum, ring) => sum + area(ring), 0);
    assert.ok(Math.abs(got / wanted - 1) < 0.15, `${p}: ${got} against ${wanted}`);
  });
});

test("two peaks are two regions", () => {
  const xs = normal(1000).map((v, i) => (i % 2 ? v + 20 : v - 20));
  const { rings } = regions(xs, normal(1000), [0.5]);
  const large = rings[0].filter((ring) => area(ring) > 0.5);
  assert.equal(large.length, 2);
});

test("the coefficient of correlation", () => {
  assert.ok(Math.abs(correlation([1, 2, 3], [2, 4, 6]) - 1) < 1e-12);
  assert.ok(Math.abs(correlation([1, 2, 3], [1, 0, 1])) < 1e-12);
});

/// A grid of `side` nodes over [-1, 1] in both directions.
function gridOf(side, height) {
  const step = 2 / (side - 1);
  const at = (k) => -1 + k * step;
  const cells = Array.from({ length: side * side }, (_, i) =>
    height(at(i % side), at(Math.floor(i / side))),
  );
  return { cells, side, low: [-1, -1], step: [step, step] };
}

test("a cone is cut in a circle", () => {
  const rings = regionOf(
    gridOf(81, (x, y) => Math.max(0, 1 - Math.hypot(x, y))),
    0.5,
  );
  assert.equal(rings.length, 1);
  assert.ok(Math.abs(area(rings[0]) - Math.PI / 4) < 0.01);
});

test("a hole runs the other way round", () => {
  const ridge = gridOf(81, (x, y) => Math.max(0, 1 - Math.abs(Math.hypot(x, y) - 0.6) / 0.4));
  const areas = regionOf(ridge, 0.5)
    .map(area)
    .sort((a, b) => a - b);
  assert.equal(areas.length, 2);
  assert.ok(Math.abs(areas[0] + Math.PI * 0.4 ** 2) < 0.02);
  assert.ok(Math.abs(areas[1] - Math.PI * 0.8 ** 2) < 0.02);
});

test("a region at the rim is closed there", () => {
  const [ring] = regionOf(
    gridOf(5, () => 1),
    0.5,
  );
  assert.ok(Math.abs(area(ring) - 2.5 ** 2) < 0.51); // half a step beyond, corners cut
});
