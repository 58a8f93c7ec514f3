// Tests for the parts of chains, corner plots, predictions and charts that need no browser.

import assert from "node:assert/strict";
import test from "node:test";
import { disagrees } from "../report/chains.js";
import { withUnit } from "../report/chain_panels.js";
import { brokenName, rangeOf } from "../report/corner_panels.js";
import { goesOn, rowText } from "../report/interval.js";
import { seriesLooks } from "../report/palette.js";
import { pathThrough } from "../report/panel.js";
import { isOutside } from "../report/predictive.js";

test("chains disagree above 1.01, and where nobody knows", () => {
  assert.equal(disagrees({ r_hat: 1.0099 }), false);
  assert.equal(disagrees({ r_hat: 1.011 }), true);
  assert.equal(disagrees({ r_hat: null }), true);
});

test("a name has its unit", () => {
  assert.equal(withUnit({ name: "tilt", unit: "deg" }), "tilt [deg]");
  assert.equal(withUnit({ name: "noise" }), "noise");
});

test("long names break after slashes", () => {
  assert.deepEqual(brokenName("axis/MCP3/direction/1 [deg]", 75), [
    "axis/MCP3/",
    "direction/1",
    "[deg]",
  ]);
  assert.deepEqual(brokenName("tilt", 75), ["tilt"]);
});

test("a wide prior does not hide the posterior", () => {
  const draws = [0, 0.5, 1];
  const wide = Array.from({ length: 101 }, (_, i) => i - 50);
  const [low, high] = rangeOf({ draws, prior: wide });
  assert.deepEqual([low, high], [-0.5, 1.5]);
});

test("a truth outside the draws is in sight, unless it is far", () => {
  assert.ok(rangeOf({ draws: [0, 1], truth: 1.5 })[1] > 1.5);
  assert.ok(rangeOf({ draws: [0, 1], truth: 50 })[1] < 4);
});

test("faint series are grey and use up no colour", () => {
  const series = [{ faint: true }, { name: "a" }, { faint: true }, { name: "b" }];
  assert.deepEqual(
    seriesLooks(series).map(({ color }) => color),
    ["var(--muted)", "var(--blue)", "var(--muted)", "var(--vermillion)"],
  );
});

test("a missing point interrupts a path", () => {
  const path = pathThrough([
    [0, 0],
    [1, 1],
    [2, NaN],
    [3, 3],
  ]);
  assert.equal(path, "M0.0 0.0L1.0 1.0M3.0 3.0");
});

test("what lies outside its interval", () => {
  assert.equal(isOutside({ measured: 3, low: 0, high: 2 }), true);
  assert.equal(isOutside({ measured: 2, low: 0, high: 2 }), false);
  assert.equal(isOutside({ measured: null, low: 0, high: 2 }), null);
});

test("a row goes on beyond a cut axis if anything of it does", () => {
  assert.equal(goesOn({ estimate: 1, low: 0, high: 3 }, 2), true);
  assert.equal(goesOn({ estimate: 1, low: 0, high: 2 }, 2), false);
  assert.equal(goesOn({ estimate: null, low: null, high: null }, 2), false);
  assert.equal(goesOn({ estimate: 1, high: 3 }, Infinity), false);
});

test("a row tells its own words, or estimate and interval", () => {
  assert.equal(rowText({ display: "2 deg" }), "2 deg");
  assert.equal(rowText({ estimate: 2, low: 1, high: 3, unit: "mm" }), "2 [1, 3] mm");
  assert.equal(rowText({ estimate: null }), "n/a");
});
