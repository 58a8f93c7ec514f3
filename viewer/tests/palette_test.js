// Tests for report/palette.js: colours that can be told apart, also by the colour-blind.

import assert from "node:assert/strict";
import test from "node:test";
import { cssColor, dashOf, HEX, hexColor, seriesLooks } from "../report/palette.js";

// What the eye lacks, in linear RGB, at severity 1. Source: Machado, Oliveira and Fernandes 2009,
// IEEE TVCG 15(6), table of the supplement.
const EYES = {
  normal: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protanope: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deuteranope: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
};
const LEAST = 0.07; // difference in OKLab; about 0.02 is the least that is seen at all

const linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const channels = (hex) => [1, 3, 5].map((at) => linear(parseInt(hex.slice(at, at + 2), 16) / 255));
const apply = (matrix, v) => matrix.map((row) => row.reduce((sum, m, i) => sum + m * v[i], 0));
const clamp = (v) => v.map((c) => Math.min(1, Math.max(0, c)));

/// Source: Ottosson 2020, "A perceptual color space for image processing".
function oklab(rgb) {
  const cones = apply(
    [
      [0.4122214708, 0.5363325363, 0.0514459929],
      [0.2119034982, 0.6806995451, 0.1073969566],
      [0.0883024619, 0.2817188376, 0.6299787005],
    ],
    rgb,
  ).map(Math.cbrt);
  return apply(
    [
      [0.2104542553, 0.793617785, -0.0040720468],
      [1.9779984951, -2.428592205, 0.4505937099],
      [0.0259040371, 0.7827717662, -0.808675766],
    ],
    cones,
  );
}

const seen = (hex, eye) => oklab(clamp(apply(EYES[eye], channels(hex))));
const distance = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));

// On a page ink is its text colour.
const onPage = Object.entries({ ...HEX, ink: "#1b1f24" });

test("there are ten colours", () => assert.equal(onPage.length, 10));

for (const eye of Object.keys(EYES))
  test(`${eye}: any two colours differ, and all from a white page`, () => {
    for (const [i, [name, hex]] of onPage.entries()) {
      assert.ok(distance(seen(hex, eye), seen("#ffffff", eye)) > 2 * LEAST, `${name} on white`);
      for (const [other, otherHex] of onPage.slice(0, i)) {
        const apart = distance(seen(hex, eye), seen(otherHex, eye));
        assert.ok(apart > LEAST, `${name} and ${other}: ${apart}`);
      }
    }
  });

test("forty lines look different: ten colours, four dashes", () => {
  const names = Array.from({ length: 40 }, (_, i) => ({ name: `line ${i}` }));
  const looks = seriesLooks(names).map(({ color, dash }) => `${color} ${dash}`);
  assert.equal(new Set(looks).size, 40);
  assert.equal(dashOf(9), undefined);
  assert.notEqual(dashOf(10), undefined);
  assert.equal(cssColor(10), cssColor(0));
  assert.equal(hexColor(10), hexColor(0));
});

test("series of one name look alike", () => {
  const [a, b, c] = seriesLooks([{ name: "one" }, { name: "two" }, { name: "one" }]);
  assert.deepEqual(a, c);
  assert.notDeepEqual(a, b);
});
