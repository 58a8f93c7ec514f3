// Tests for report/contents_model.js.

import assert from "node:assert/strict";
import test from "node:test";
import { groupedTitles } from "../report/contents_model.js";

test("titles that begin alike become a group, in which each keeps its place", () =>
  assert.deepEqual(
    groupedTitles(["Start", "Posterior of H1: modes", "Posterior of H1: what was learnt", "End"]),
    [
      { title: "Start", index: 0 },
      {
        title: "Posterior of H1",
        entries: [
          { title: "Modes", index: 1 },
          { title: "What was learnt", index: 2 },
        ],
      },
      { title: "End", index: 3 },
    ],
  ));

test("a lone title with a colon keeps all its words", () =>
  assert.deepEqual(groupedTitles(["The thumb: axes", "The finger: axes"]), [
    { title: "The thumb: axes", index: 0 },
    { title: "The finger: axes", index: 1 },
  ]));

test("titles that begin alike but stand apart are no group", () =>
  assert.equal(
    groupedTitles(["A: one", "B", "A: two"]).filter(({ entries }) => entries).length,
    0,
  ));

test("no sections, no titles", () => assert.deepEqual(groupedTitles([]), []));
