// Tests for report/opening.js and what report/check.js says of the parts around sections.

import assert from "node:assert/strict";
import test from "node:test";
import { reportFaults } from "../report/check.js";
import { isPage } from "../report/opening.js";

const report = (more) => ({ title: "t", sections: [], ...more });

test("links lead to pages of the same folder and nowhere else", () => {
  assert.ok(isPage("wine_glass.html"));
  for (const file of ["../a.html", "http://a.b/c.html", "a.html#b", "a.txt", "", undefined])
    assert.ok(!isPage(file), String(file));
});

test("an opening must say what was asked, done and learnt", () => {
  const opening = { asked: "a", done: "d", learnt: "l" };
  assert.deepEqual(reportFaults(report({ opening })), []);
  assert.match(reportFaults(report({ opening: { asked: "a" } }))[0], /"opening" must be/);
});

test("lines of a summary are texts, pages have a title", () => {
  assert.deepEqual(reportFaults(report({ summary: [{ text: "t", file: "a.html" }] })), []);
  assert.match(reportFaults(report({ summary: ["t"] }))[0], /"summary" must be/);
  assert.match(reportFaults(report({ pages: [{ file: "a.html" }] }))[0], /"pages" must be/);
});
