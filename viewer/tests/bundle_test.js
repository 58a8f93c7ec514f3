// The committed bundles are what the sources make, and can be embedded as they are.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { build } from "esbuild";
import { BUNDLES } from "../bundle_options.js";
import { pageOf } from "../sample/page.js";

const root = join(import.meta.dirname, "..");

for (const options of BUNDLES) {
  const committed = readFileSync(join(root, options.outfile), "utf8");

  test(`${options.outfile} is up to date (npm run bundle)`, async () => {
    const { outputFiles } = await build({ ...options, write: false });
    assert.ok(outputFiles[0].text === committed, "sources and bundle differ");
  });

  // Pages of reports hold their bundle; the live page is served beside its own.
  if (options.outfile.endsWith(".html")) continue;
  test(`${options.outfile} is plain ASCII and cannot end its element`, () => {
    assert.match(committed, /^[\x00-\x7f]*$/);
    assert.doesNotMatch(committed, /<\/?(script|style)|<!--/i);
  });
}

test("text of a report cannot end the script element", () => {
  const page = pageOf({ title: "</script><script>alert(1)</script><!--", sections: [] });
  assert.equal(page.match(/<script/g).length, 2);
});
