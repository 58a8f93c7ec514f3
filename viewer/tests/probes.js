// Functions that are sent into the page and run there.

/// Whether everything that draws itself a frame later has its canvas.
export function isReady() {
  const count = (selector) => document.querySelectorAll(selector).length;
  return (
    document.readyState === "complete" &&
    count("#report > header") === 1 &&
    count(".scene:not(.compact)") ===
      count(".scene:not(.compact) canvas, .scene:not(.compact) .error") &&
    count(".uplot canvas") > 0
  );
}

/// What a reader would see. The background of a canvas is transparent: `covered` is the share of
/// its pixels that something was painted on, `colors` how many different ones.
export function look() {
  const paint = (canvas) => {
    const { width, height } = canvas;
    const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
    const pixels = new Uint32Array(data.buffer).filter((pixel) => pixel >>> 24 > 200);
    return { covered: pixels.length / (width * height), colors: new Set(pixels).size };
  };
  const all = (selector) => [...document.querySelectorAll(selector)];
  return {
    scenes: all(".scene:not(.compact) canvas").map(paint),
    charts: all(".uplot canvas").map(paint),
    errors: all(".error").map((box) => box.textContent),
    tables: all("table").length,
    plots: all("svg.plot").length,
    overflow: document.documentElement.scrollWidth - innerWidth,
  };
}

/// Where an element stands on the page, with a margin.
export function boxOf(selector) {
  const { x, y, width, height } = document.querySelector(selector).getBoundingClientRect();
  const left = Math.max(0, x - 16);
  return { x: left, y: y + scrollY, width: Math.min(innerWidth - left, width + 32), height };
}

/// The picture of one scene, and the middle of its canvas in the window, scrolled into view.
export function picture(index) {
  const canvas = document.querySelectorAll(".scene canvas")[index];
  canvas.scrollIntoView({ block: "center", behavior: "instant" });
  const { x, y, width, height } = canvas.getBoundingClientRect();
  return { image: canvas.toDataURL(), x: x + width / 2, y: y + height / 2 };
}

/// How many compact scenes are drawn.
export const compactCanvases = () => document.querySelectorAll(".scene.compact canvas").length;

/// Clicks the first legend button and tells how many force pairs are hidden.
export function hideFirstTendon() {
  document.querySelector(".legend button").click();
  return [...document.querySelectorAll(".pair")].filter((pair) => pair.style.display === "none")
    .length;
}

/// The middle of an element, scrolled into view.
export function middleOf(selector) {
  const element = document.querySelector(selector);
  element.scrollIntoView({ block: "center", behavior: "instant" });
  const { x, y, width, height } = element.getBoundingClientRect();
  return { x: x + width / 2, y: y + height / 2 };
}

/// The tooltip's text; empty while it is hidden.
export function tooltipText() {
  const box = document.querySelector(".tooltip");
  return box && !box.hidden ? box.innerText : "";
}

/// Picks another quantity of the chains; tells what stands beside the choice, and whether the trace
/// changed.
export function chooseQuantity(index) {
  const figure = document.querySelector(".chain-panels").closest("figure");
  const trace = () => figure.querySelector(".chain-panel svg").innerHTML;
  const before = trace();
  const select = figure.querySelector(".chooser select");
  select.value = String(index);
  select.dispatchEvent(new Event("change"));
  return { facts: figure.querySelector(".facts").textContent, changed: trace() !== before };
}

/// Leaves the first quantity out of the corner plot; tells how many panels were there and are.
export function leaveOutQuantity() {
  const panels = () => document.querySelectorAll(".corner-plot .panel-frame").length;
  const before = panels();
  document.querySelector(".chip").click();
  return [before, panels()];
}

/// Whether the first chart changes when its first series is switched off.
export function chartWithoutSeries() {
  const figure = document.querySelector(".uplot").closest("figure");
  const image = () => figure.querySelector("canvas").toDataURL();
  const before = image();
  figure.querySelector(".legend button").click();
  return new Promise((resolve) => setTimeout(() => resolve(image() !== before), 300));
}

/// Shares of the pictures for paper that something is painted on, white left out, and how many
/// scenes there are.
export function printedShares() {
  dispatchEvent(new Event("beforeprint"));
  const share = (canvas) => {
    const { width, height } = canvas;
    const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
    const pixels = new Uint32Array(data.buffer);
    return pixels.filter((pixel) => pixel !== 0xffffffff).length / pixels.length;
  };
  const printed = [...document.querySelectorAll(".printed")].map(share);
  dispatchEvent(new Event("afterprint"));
  return { printed, scenes: document.querySelectorAll(".scene").length };
}

/// Heights of the page with all sections open and folded, and whether a link opens its section.
export async function foldAll() {
  const frame = () => new Promise((resolve) => setTimeout(resolve, 100));
  const height = () => document.documentElement.scrollHeight;
  const [openAll, fold] = document.querySelectorAll(".contents-list .tools button");
  const open = height();
  fold.click();
  await frame();
  const folded = height();
  const link = document.querySelector(".contents-list a[href^='#']");
  link.click();
  await frame();
  const linked = height();
  openAll.click();
  await frame();
  return { open, folded, linked, again: height() };
}

/// What the buttons below the figures of a type of block save: the beginning of each file, and of
/// pictures how many colours they have.
export async function savedFiles(selector) {
  const blobs = [];
  const make = URL.createObjectURL;
  URL.createObjectURL = (blob) => {
    blobs.push(blob);
    return make.call(URL, blob);
  };
  const figure = document.querySelector(selector).closest("figure");
  figure.querySelectorAll(".tools.save button").forEach((button) => button.click());
  for (let i = 0; i < 50 && !blobs.some(({ type }) => type === "image/png"); ++i)
    await new Promise((resolve) => setTimeout(resolve, 100));
  URL.createObjectURL = make;
  const colors = async (blob) => {
    const image = await createImageBitmap(blob);
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    return new Set(new Uint32Array(data.buffer)).size;
  };
  const told = async (blob) => ({
    type: blob.type,
    start: (await blob.text()).slice(0, 60),
    colors: blob.type === "image/png" ? await colors(blob) : null,
  });
  // The drawing that becomes a picture is no file of its own.
  return Promise.all(blobs.filter((blob, i) => i === 0 || blob.type !== blobs[0].type).map(told));
}

/// The still pictures of a motion: times, shares that something is painted on, how many differ.
export function stills() {
  const all = [...document.querySelectorAll(".still")];
  const share = (canvas) => {
    const { width, height } = canvas;
    const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
    const pixels = new Uint32Array(data.buffer);
    return pixels.filter((pixel) => pixel !== pixels[0]).length / pixels.length;
  };
  const canvases = all.map((still) => still.querySelector("canvas"));
  return {
    told: all.map((still) => still.textContent),
    shares: canvases.map(share),
    different: new Set(canvases.map((canvas) => canvas.toDataURL())).size,
  };
}

/// The film that the button below the motion saves.
export function savedFilm() {
  const make = URL.createObjectURL;
  const film = new Promise((done) => {
    URL.createObjectURL = (blob) => {
      URL.createObjectURL = make;
      done({ type: blob.type, size: blob.size });
      return make.call(URL, blob);
    };
  });
  const figure = document.querySelector(".strip").closest("figure");
  [...figure.querySelectorAll(".tools.save button")]
    .find((button) => button.textContent === "WebM")
    .click();
  return film;
}

/// Presses a key on the first element of a selector, which gets the focus; tells what the tooltip
/// says then.
export function pressKey(selector, key) {
  const element = document.querySelector(selector);
  element.scrollIntoView({ block: "center", behavior: "instant" });
  element.focus();
  element.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
  return document.querySelector(".tooltip")?.innerText ?? "";
}

/// Whether the focus is in a panel of layers, and how its outline is drawn.
export function focusSeen() {
  const element = document.activeElement;
  const { outlineStyle } = getComputedStyle(element);
  return { inPanel: element.closest(".lil-gui") !== null, outline: outlineStyle };
}

/// What a reader cannot see whole: parts beyond the window that cannot be scrolled to, words that
/// their box cuts, words of drawings beyond the drawing, and tables that go on beyond their frame.
export function clippedParts() {
  const seen = (element) => {
    const { width, height } = element.getBoundingClientRect();
    return width > 0 && height > 0 && !element.closest(".hidden-words, [hidden]");
  };
  const says = (element) => `${element.tagName} ${element.getAttribute("class")} "${element.textContent.trim().slice(0, 40)}"`;
  const all = (selector) => [...document.querySelectorAll(selector)].filter(seen);
  const scrolls = (element) => ["auto", "scroll"].includes(getComputedStyle(element).overflowX);
  const inScroller = (element) => {
    for (let up = element.parentElement; up; up = up.parentElement) if (scrolls(up)) return true;
    return false;
  };
  const width = document.documentElement.clientWidth;
  const beyond = all("#report *").filter((element) => {
    const { left, right } = element.getBoundingClientRect();
    return (right > width + 1 || left < -1) && !inScroller(element);
  });
  const cut = all("#report *").filter((element) => {
    const { overflowX } = getComputedStyle(element);
    const hides = overflowX === "hidden" || overflowX === "clip";
    return hides && element.clientWidth > 0 && element.scrollWidth > element.clientWidth + 1;
  });
  const low = all("#report *").filter((element) => {
    const { overflowY } = getComputedStyle(element);
    const hides = overflowY === "hidden" || overflowY === "clip";
    const height = element.clientHeight;
    return hides && height > 0 && element.scrollHeight > height + 1 && element.innerText?.trim();
  });
  const drawn = all("svg.plot").flatMap((plot) => {
    const box = plot.getBoundingClientRect();
    return [...plot.querySelectorAll("text")].filter((text) => {
      const { left, right, top, bottom, width: wide } = text.getBoundingClientRect();
      const out = left < box.left - 2 || right > box.right + 2;
      return wide > 0 && (out || top < box.top - 2 || bottom > box.bottom + 2);
    });
  });
  const wide = all(".table-frame, .chart, .corner").filter(
    (frame) => frame.scrollWidth > frame.clientWidth + 1,
  );
  const sizes = (e) => `${says(e)} ${e.scrollWidth} in ${e.clientWidth}`;
  const heights = (e) => `${says(e)} ${e.scrollHeight} high in ${e.clientHeight}`;
  return [...[...beyond, ...drawn].map(says), ...[...cut, ...wide].map(sizes), ...low.map(heights)];
}

/// Words of headers of tables and cards, of titles and of buttons that are broken over two lines.
/// A browser may break a word behind a hyphen or a slash, as a writer would.
export function brokenWords() {
  const broken = [];
  const range = document.createRange();
  for (const element of document.querySelectorAll("#report :is(th, h1, h2, h3, button, dt)")) {
    const texts = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
    for (let text = texts.nextNode(); text; text = texts.nextNode())
      for (const { 0: word, index } of text.data.matchAll(/[^\s\u00ad\u200b/\u2010\u2013-]+/g)) {
        range.setStart(text, index);
        range.setEnd(text, index + word.length);
        const lines = new Set([...range.getClientRects()].map(({ top }) => Math.round(top)));
        if (lines.size > 1) broken.push(`${element.tagName} breaks "${word}"`);
      }
  }
  return broken;
}

/// How the page begins and how it leads on: its first paragraph, how many lines its summary has, and
/// where the links to other pages go.
export function beginning() {
  const links = (selector) =>
    [...document.querySelectorAll(`${selector} a`)].map((link) => link.getAttribute("href"));
  return {
    first: document.querySelector(".sections p").textContent,
    lines: document.querySelectorAll(".summary li").length,
    pages: links(".page-list"),
    marked: document.querySelector(".page-list [aria-current='page']").getAttribute("href"),
    next: links(".neighbours"),
  };
}

/// Whether the page has drawn its frame.
export const isDrawn = () =>
  document.readyState === "complete" && document.querySelector("#report > header") !== null;

/// Opens all sections; tells what could not be drawn.
export async function openEverything() {
  const open = [...document.querySelectorAll(".contents-list .tools button")][0];
  open?.click();
  await new Promise((resolve) => setTimeout(resolve, 1000));
  return [...document.querySelectorAll(".error")].map((box) => `error: ${box.textContent}`);
}
