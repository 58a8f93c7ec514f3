// Opens every page of a folder in Chromium at the widths that pages are made for, and asserts that
// nothing is clipped and no block is an error: `npm run check-folder -- ../out`.

import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { startBrowser } from "./browser.js";
import { clippedParts, isDrawn, openEverything } from "./probes.js";

const WIDTHS = [1400, 1024, 390]; // [px]
const SETTLE = 1000; // [ms] for what is drawn a frame later

const pause = (ms) => new Promise((done) => setTimeout(done, ms));

async function ask(browser, probe) {
  const expression = `(${probe})()`;
  const options = { expression, returnByValue: true, awaitPromise: true };
  const { result, exceptionDetails } = await browser.send("Runtime.evaluate", options);
  assert.equal(exceptionDetails, undefined, exceptionDetails?.exception?.description);
  return result.value;
}

/// Faults of a page at a width, each with the page's name.
async function faultsOf(browser, path, width) {
  const metrics = { width, height: 900, deviceScaleFactor: 1, mobile: false };
  await browser.send("Emulation.setDeviceMetricsOverride", metrics);
  await browser.send("Page.navigate", { url: `file://${path}` });
  for (let i = 0; i < 200 && !(await ask(browser, isDrawn)); ++i) await pause(100);
  const errors = await ask(browser, openEverything);
  await pause(SETTLE);
  return [...errors, ...(await ask(browser, clippedParts))];
}

const folder = resolve(process.argv[2] ?? "../out");
const pages = readdirSync(folder).filter((name) => name.endsWith(".html"));
assert.ok(pages.length > 0, `no page in ${folder}`);
const browser = await startBrowser();
let count = 0;
try {
  for (const domain of ["Runtime", "Page"]) await browser.send(`${domain}.enable`);
  for (const page of pages)
    for (const width of WIDTHS)
      for (const fault of await faultsOf(browser, join(folder, page), width)) {
        console.log(`${page} at ${width} px: ${fault}`);
        ++count;
      }
} finally {
  await browser.close();
}
assert.equal(count, 0, `${count} faults on ${pages.length} pages`);
console.log(`${pages.length} pages are whole at ${WIDTHS.join(", ")} px`);
