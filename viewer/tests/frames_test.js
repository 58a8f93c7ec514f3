// Tests for picture/frames.js and picture/label_places.js.

import assert from "node:assert/strict";
import test from "node:test";
import { instantAt, instantsOf, speedsFor, timedLayers } from "../picture/frames.js";
import { placeLabels } from "../picture/label_places.js";

const named = (...names) => names.map((name) => ({ name }));
const times = (layers) => timedLayers(layers).map(({ time }) => time);

test("layers with a time, or named after theirs, are instants", () => {
  const layers = [
    ...named("0 s", "0.04 s", "1e-1 s", "tendons at the end"),
    { name: "a", time: 2 },
  ];
  assert.deepEqual(times(layers), [0, 0.04, 0.1, null, 2]);
  assert.deepEqual(instantsOf(timedLayers(layers)), [0, 0.04, 0.1, 2]);
});

test("two instants are no motion", () =>
  assert.deepEqual(times(named("0 s", "1 s")), [null, null]));

test("layers that share an instant are shown together", () => {
  const layers = timedLayers([0, 1, 1, 2].map((time) => ({ name: "a", time })));
  assert.deepEqual(instantsOf(layers), [0, 1, 2]);
});

test("an instant holds until the next", () => {
  const at = (time) => instantAt([0, 1, 3], time);
  assert.deepEqual([-1, 0, 0.9, 1, 2.9, 3, 9].map(at), [0, 0, 0, 1, 1, 3, 3]);
});

test("a short motion starts slowly, a long one in its own time", () => {
  assert.equal(speedsFor([0, 1]).chosen, 0.25);
  assert.equal(speedsFor([0, 5]).chosen, 1);
  assert.equal(speedsFor([0, 1e-3]).chosen, 0.05);
});

const size = { width: 300, height: 200 };
const label = (x, y, depth = 0, text = "PIP3") => ({ x, y, depth, text, width: 40 });
const apart = (a, b) =>
  a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;

test("words at one point do not cover each other, and stay in the picture", () => {
  const placed = placeLabels(
    Array.from({ length: 12 }, (_, i) => label(150, 100, i)),
    size,
  );
  assert.ok(placed.length >= 10);
  placed.forEach(({ place }, i) => {
    assert.ok(place.left >= 0 && place.right <= 300 && place.top >= 0 && place.bottom <= 200);
    for (const other of placed.slice(0, i)) assert.ok(apart(place, other.place));
  });
});

test("the nearest words stand beside their point, later ones are led to it", () => {
  const [near, , third] = placeLabels(
    [label(150, 100, 0.9), label(150, 100, 0.1), label(150, 100, 1)],
    size,
  );
  assert.equal(near.label.depth, 0.1);
  assert.equal(near.place.far, false);
  assert.ok(near.place.left > 150);
  assert.equal(third.place.far, true);
});

test("words without room are left out, and none covers what is taken", () => {
  const everything = { left: 0, right: 300, top: 0, bottom: 200 };
  assert.deepEqual(placeLabels([label(150, 100)], size, [everything]), []);
  const right = { left: 150, right: 300, top: 0, bottom: 200 };
  const [{ place }] = placeLabels([label(150, 100)], size, [right]);
  assert.ok(place.right <= 150);
});
