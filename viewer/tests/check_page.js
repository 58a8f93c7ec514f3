// Opens the sample report in Chromium, asserts that it draws and answers, and leaves screenshots in
// tests/screenshots. Run `npm run bundle` first. Needs chromium on the path, or its path in
// CHROMIUM.

import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pageOf } from "../sample/page.js";
import { startBrowser } from "./browser.js";
import {
  beginning,
  boxOf,
  chartWithoutSeries,
  chooseQuantity,
  clippedParts,
  compactCanvases,
  foldAll,
  focusSeen,
} from "./probes.js";
import { hideFirstTendon, isReady } from "./probes.js";
import { leaveOutQuantity, look, middleOf, picture, pressKey } from "./probes.js";
import { printedShares, savedFiles, savedFilm, stills, tooltipText } from "./probes.js";

const SHOTS = join(import.meta.dirname, "screenshots");
const VIEWS = {
  light: { width: 1400, scheme: "light" },
  dark: { width: 1400, scheme: "dark" },
  tablet: { width: 1024, scheme: "light" },
  phone: { width: 390, scheme: "light" },
};
const LEAST_COVERED = 0.02; // of a scene's canvas; labels, triad and scale bar alone stay below it
const SETTLE = 800; // [ms] for the frames that follow the first

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/// Runs a probe in the page.
async function ask(browser, probe, ...values) {
  const { result, exceptionDetails } = await browser.send("Runtime.evaluate", {
    expression: `(${probe})(${values.map((value) => JSON.stringify(value)).join(",")})`,
    returnByValue: true,
    awaitPromise: true,
  });
  assert.equal(exceptionDetails, undefined, exceptionDetails?.exception?.description);
  return result.value;
}

async function open(browser, path, { width, scheme }) {
  const metrics = { width, height: 900, deviceScaleFactor: 1, mobile: false };
  await browser.send("Emulation.setDeviceMetricsOverride", metrics);
  const features = [{ name: "prefers-color-scheme", value: scheme }];
  await browser.send("Emulation.setEmulatedMedia", { features });
  await browser.send("Page.navigate", { url: `file://${path}` });
  for (let i = 0; i < 100 && !(await ask(browser, isReady)); ++i) await pause(100);
  await pause(SETTLE);
}

async function shoot(browser, name, selector) {
  const clip = { ...(await ask(browser, boxOf, selector)), scale: 1 };
  const options = { captureBeyondViewport: true, clip };
  const { data } = await browser.send("Page.captureScreenshot", options);
  writeFileSync(join(SHOTS, `${name}.png`), Buffer.from(data, "base64"));
}

/// The whole page, and each section by itself.
async function shootAll(browser, name, sections) {
  await shoot(browser, name, "html");
  for (const { id } of sections) await shoot(browser, `${name}-${id}`, `#${id}`);
}

function judge(name, seen) {
  assert.deepEqual(seen.errors, [], `${name}: error boxes`);
  assert.equal(seen.scenes.length, 6, `${name}: number of scenes`);
  for (const [i, { covered }] of seen.scenes.entries())
    assert.ok(covered > LEAST_COVERED, `${name}: scene ${i} is blank, ${covered} of it covered`);
  for (const [i, { colors }] of seen.charts.entries())
    assert.ok(colors > 5, `${name}: chart ${i} has only ${colors} colours`);
  assert.equal(seen.tables, 2, `${name}: number of tables`);
  assert.equal(seen.plots, 24, `${name}: number of SVG plots`);
  assert.ok(seen.overflow <= 0, `${name}: the page is ${seen.overflow} px wider than its window`);
}

/// Compact scenes are drawn when the reader comes to them, and not before.
async function checkCompact(browser) {
  const before = await ask(browser, compactCanvases);
  await ask(browser, middleOf, ".scene.compact");
  await pause(SETTLE);
  assert.deepEqual([before, await ask(browser, compactCanvases)], [0, 2], "compact scenes drawn");
}

async function drag(browser, { x, y }, dx) {
  const mouse = (type, at, buttons) =>
    browser.send("Input.dispatchMouseEvent", { type, x: at, y, button: "left", buttons });
  await mouse("mousePressed", x, 1);
  await mouse("mouseMoved", x + dx, 1);
  await mouse("mouseReleased", x + dx, 0);
  await pause(SETTLE);
}

/// A drag turns a scene, and the one that is linked to it, and no other.
async function checkTurning(browser) {
  const pictures = async () => [
    await ask(browser, picture, 0),
    await ask(browser, picture, 2),
    await ask(browser, picture, 1),
  ];
  const before = await pictures();
  await drag(browser, before[2], 80);
  const after = await pictures();
  const changed = after.map(({ image }, i) => image !== before[i].image);
  assert.deepEqual(changed, [false, true, true], "scenes changed: first, linked, dragged");
}

/// The pointer over an arrow tells its numbers. A first move only brings the pointer into the page.
async function checkTooltip(browser) {
  const { x, y } = await ask(browser, middleOf, ".pair line.measured");
  for (const dx of [2, 0])
    await browser.send("Input.dispatchMouseEvent", { type: "mouseMoved", x: x + dx, y });
  await pause(SETTLE);
  assert.match(await ask(browser, tooltipText), /measured.*predicted.*difference/s);
}

/// The pointer over a scene tells what is below it, and where.
async function checkReading(browser) {
  const { x, y } = await ask(browser, middleOf, ".scene canvas");
  const told = [];
  for (let step = 0; step < 80; ++step) {
    const place = { x: x - 200 + 50 * (step % 8), y: y - 120 + 24 * Math.floor(step / 8) };
    await browser.send("Input.dispatchMouseEvent", { type: "mouseMoved", ...place });
    await pause(50);
    told.push(await ask(browser, tooltipText));
  }
  assert.match(told.join("\n"), /x .*, y .*, z .* mm/, "nothing below the pointer was told");
}

/// A page begins with what was asked, and leads to the others.
async function checkBeginning(browser) {
  const { first, lines, pages, marked, next } = await ask(browser, beginning);
  assert.match(first, /^Asked\..*Done\..*Learnt\./s);
  assert.deepEqual([lines, marked, next], [2, "report.html", ["other.html"]]);
  assert.deepEqual(pages, ["report.html", "other.html"]);
}

/// The reader chooses which quantities to see.
async function checkChoices(browser) {
  const { facts, changed } = await ask(browser, chooseQuantity, 3);
  assert.match(facts, /^R-hat 1\.\d+, bulk ESS \d+, tail ESS \d+$/);
  assert.ok(changed, "another quantity has another trace");
  assert.deepEqual(await ask(browser, leaveOutQuantity), [21, 15], "panels of 6 and 5 quantities");
}

/// The panel of layers shows which of its parts has the focus, and is reached by the tab key.
async function checkFocus(browser) {
  await browser.send("Emulation.setFocusEmulationEnabled", { enabled: true });
  await ask(browser, pressKey, ".scene canvas", "0");
  const tab = { key: "Tab", code: "Tab", windowsVirtualKeyCode: 9 };
  for (const type of ["keyDown", "keyUp"])
    await browser.send("Input.dispatchKeyEvent", { type, ...tab });
  const { inPanel, outline } = await ask(browser, focusSeen);
  assert.deepEqual([inPanel, outline], [true, "solid"], "focus in the panel of layers");
}

/// Every scene is on paper, also those that were not drawn before.
async function checkPrinted(browser) {
  const { printed, scenes } = await ask(browser, printedShares);
  assert.equal(printed.length, scenes, "pictures for paper");
  for (const [i, share] of printed.entries())
    assert.ok(share > LEAST_COVERED, `picture ${i} for paper is blank, ${share} of it covered`);
}

/// Folded sections leave their titles, and a link opens what it leads to.
async function checkFolding(browser) {
  const { open, folded, linked, again } = await ask(browser, foldAll);
  assert.ok(folded < 0.3 * open, `the page is ${open} px high, folded ${folded}`);
  assert.ok(linked > folded, "a link opens its section");
  assert.ok(Math.abs(again - open) < 0.02 * open, `opened again it is ${again} px high`);
}

/// Figures are saved as what their buttons say.
async function checkSaving(browser) {
  const chart = await ask(browser, savedFiles, ".uplot");
  assert.match(chart[0].start, /^<svg xmlns/);
  assert.match(chart.find(({ type }) => type === "text/csv").start, /^series,/);
  const png = chart.find(({ type }) => type === "image/png");
  assert.ok(png.colors > 5, `the saved picture has only ${png.colors} colours`);
  const [scene] = await ask(browser, savedFiles, ".scene canvas");
  assert.equal(scene.type, "image/png");
}

/// A motion stands in still pictures below its scene, and is saved as a film.
async function checkMotion(browser) {
  const { told, shares, different } = await ask(browser, stills);
  assert.deepEqual(told, ["0 s", "0.1 s", "0.2 s"], "times of the still pictures");
  assert.ok(Math.min(...shares) > LEAST_COVERED, `a still picture is blank: ${shares}`);
  assert.equal(different, told.length, "still pictures of different instants differ");
  const film = await ask(browser, savedFilm);
  assert.equal(film.type, "video/webm");
  assert.ok(film.size > 1000, `the film has ${film.size} bytes`);
}

/// Keys read values off a chart.
async function checkKeys(browser) {
  const told = await ask(browser, pressKey, ".chart[tabindex]", "ArrowRight");
  assert.match(told, /:/, "the arrow key tells nothing");
}

async function print(browser) {
  const options = { printBackground: true, preferCSSPageSize: true };
  const { data } = await browser.send("Page.printToPDF", options);
  writeFileSync(join(SHOTS, "print.pdf"), Buffer.from(data, "base64"));
}

/// Nothing was thrown, and nothing was asked from outside the file.
function judgeEvents(events) {
  const thrown = events.filter(({ method }) => method === "Runtime.exceptionThrown");
  assert.deepEqual(
    thrown.map(({ params }) => params.exceptionDetails.exception?.description),
    [],
    "exceptions in the page",
  );
  const requests = events.filter(({ method }) => method === "Network.requestWillBeSent");
  const urls = requests.map(({ params }) => params.request.url);
  assert.ok(urls.length > 0, "no request was seen, not even that of the page");
  const outside = urls.filter((url) => !/^(file|blob|data):/.test(url));
  assert.deepEqual(outside, [], "requests to the network");
}

mkdirSync(SHOTS, { recursive: true });
const path = join(mkdtempSync(join(tmpdir(), "thenar-report-")), "report.html");
const sample = join(import.meta.dirname, "../sample/report.json");
const report = JSON.parse(readFileSync(sample, "utf8"));
writeFileSync(path, pageOf(report));
const browser = await startBrowser();
try {
  for (const domain of ["Runtime", "Page", "Network"]) await browser.send(`${domain}.enable`);
  for (const [name, view] of Object.entries(VIEWS)) {
    await open(browser, path, view);
    const seen = await ask(browser, look);
    assert.deepEqual(await ask(browser, clippedParts), [], `${name}: what is clipped`);
    await shootAll(browser, name, report.sections);
    judge(name, seen);
    const shares = seen.scenes.map(({ covered }) => `${(100 * covered).toFixed(1)} %`);
    console.log(`${name}: scenes covered ${shares.join(", ")}`);
  }
  await open(browser, path, VIEWS.light);
  await checkCompact(browser);
  await checkTurning(browser);
  await checkTooltip(browser);
  await checkReading(browser);
  await checkBeginning(browser);
  assert.ok(await ask(browser, chartWithoutSeries), "a legend switches its series off");
  assert.equal(
    await ask(browser, hideFirstTendon),
    8,
    "a tendon is hidden in 4 panels of 2 planes",
  );
  await checkChoices(browser);
  await checkKeys(browser);
  await checkFocus(browser);
  await checkSaving(browser);
  await checkMotion(browser);
  await checkFolding(browser);
  await open(browser, path, VIEWS.light);
  await checkPrinted(browser);
  await print(browser);
  judgeEvents(browser.events);
} finally {
  await browser.close();
}
console.log(`the page draws and answers; see ${SHOTS}`);
