// Opens every page of a folder in Chromium at the widths that pages are made for, light and dark, and
// asserts that the console is silent, nothing is clipped, no word of a header is broken and no block
// is an error: `npm run check-folder -- ../out`. A second folder gets a picture of each.

import assert from "node:assert/strict";
import { mkdirSync, readdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { startBrowser } from "./browser.js";
import { brokenWords, clippedParts, isDrawn, openEverything } from "./probes.js";

const WIDTHS = [1400, 1024, 390]; // [px]
const SCHEMES = ["light", "dark"];
const SETTLE = 1000; // [ms] for what is drawn a frame later

const pause = (ms) => new Promise((done) => setTimeout(done, ms));

async function ask(browser, probe) {
  const expression = `(${probe})()`;
  const options = { expression, returnByValue: true, awaitPromise: true };
  const { result, exceptionDetails } = await browser.send("Runtime.evaluate", options);
  assert.equal(exceptionDetails, undefined, exceptionDetails?.exception?.description);
  return result.value;
}

/// What the console and the log of the browser were told, exceptions included.
function messages(events) {
  const told = events.splice(0).flatMap(({ method, params }) => {
    if (method === "Runtime.exceptionThrown") {
      const { exception, text } = params.exceptionDetails;
      return [exception?.description ?? text];
    }
    if (method === "Runtime.consoleAPICalled")
      return [params.args.map((value) => value.value ?? value.description).join(" ")];
    return method === "Log.entryAdded" ? [params.entry.text] : [];
  });
  return told.map((text) => `console: ${text}`);
}

/// Faults of a page at a width in a colour scheme.
async function faultsOf(browser, path, width, scheme) {
  const metrics = { width, height: 900, deviceScaleFactor: 1, mobile: false };
  await browser.send("Emulation.setDeviceMetricsOverride", metrics);
  const features = [{ name: "prefers-color-scheme", value: scheme }];
  await browser.send("Emulation.setEmulatedMedia", { features });
  await browser.send("Page.navigate", { url: `file://${path}` });
  for (let i = 0; i < 200 && !(await ask(browser, isDrawn)); ++i) await pause(100);
  const errors = await ask(browser, openEverything);
  await pause(SETTLE);
  return [
    ...errors,
    ...(await ask(browser, clippedParts)),
    ...(await ask(browser, brokenWords)),
    ...messages(browser.events),
  ];
}

/// The whole page as a picture.
async function shoot(browser, file) {
  const { cssContentSize: size } = await browser.send("Page.getLayoutMetrics");
  const clip = { ...size, height: Math.min(size.height, 16000), scale: 1 };
  const options = { captureBeyondViewport: true, clip };
  const { data } = await browser.send("Page.captureScreenshot", options);
  writeFileSync(file, Buffer.from(data, "base64"));
}

const folder = resolve(process.argv[2] ?? "../out");
const pictures = process.argv[3];
if (pictures) mkdirSync(pictures, { recursive: true });
const pages = readdirSync(folder).filter((name) => name.endsWith(".html"));
assert.ok(pages.length > 0, `no page in ${folder}`);
const browser = await startBrowser();
let count = 0;
try {
  for (const domain of ["Runtime", "Page", "Log"]) await browser.send(`${domain}.enable`);
  for (const page of pages)
    for (const width of WIDTHS)
      for (const scheme of SCHEMES) {
        for (const fault of await faultsOf(browser, join(folder, page), width, scheme)) {
          console.log(`${page} at ${width} px, ${scheme}: ${fault}`);
          ++count;
        }
        const picture = `${page.replace(/\.html$/, "")}_${width}_${scheme}.png`;
        if (pictures) await shoot(browser, join(pictures, picture));
      }
} finally {
  await browser.close();
}
assert.equal(count, 0, `${count} faults on ${pages.length} pages`);
console.log(`${pages.length} pages are whole at ${WIDTHS.join(", ")} px, light and dark`);
