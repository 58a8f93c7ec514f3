// A drawn figure as one SVG file that needs no style sheet.

import { svg } from "./dom.js";

const STYLES = [
  ...["fill", "fill-opacity", "fill-rule", "stroke", "stroke-width", "stroke-opacity"],
  ...["stroke-dasharray", "stroke-linejoin", "stroke-linecap", "opacity", "paint-order", "display"],
  ...["font-family", "font-size", "font-weight", "font-style", "text-anchor"],
];

/// Writes the styles that the page gives to `node` into `copy`, for both and all they hold.
function inline(node, copy) {
  const style = getComputedStyle(node);
  for (const name of STYLES) copy.style.setProperty(name, style.getPropertyValue(name));
  copy.style.removeProperty("color");
  copy.removeAttribute("class");
  [...node.children].forEach((child, i) => inline(child, copy.children[i]));
}

/// A copy of a drawn SVG at its place; `origin` is the corner of the whole.
function placed(node, box, origin) {
  const copy = node.cloneNode(true);
  inline(node, copy);
  const place = { x: box.x - origin.x, y: box.y - origin.y, width: box.width, height: box.height };
  for (const [key, value] of Object.entries(place)) copy.setAttribute(key, value);
  return copy;
}

/// Words of the page where they stand, in their own type.
function wordsAt(node, words, left, origin) {
  const box = node.getBoundingClientRect();
  const { color, fontFamily, fontSize, fontWeight } = getComputedStyle(node);
  const place = { x: left - origin.x, y: box.y + box.height / 2 + 4 - origin.y, fill: color };
  const style = `font-family: ${fontFamily}; font-size: ${fontSize}; font-weight: ${fontWeight}`;
  return svg("text", { ...place, style }, words);
}

/// The patch of colour of a legend's entry.
function patch(mark, seen, origin) {
  if (mark instanceof SVGElement) return placed(mark, seen, origin);
  const color = getComputedStyle(mark).getPropertyValue("--swatch").trim();
  const [x, y] = [seen.x - origin.x, seen.y - origin.y];
  const middle = y + seen.height / 2;
  if (mark.matches(".dash, .thin, .thick"))
    return svg("line", {
      ...{ x1: x, x2: x + seen.width, y1: middle, y2: middle, stroke: color },
      "stroke-width": mark.matches(".thick") ? 6 : 2.5,
      "stroke-opacity": mark.matches(".thick") ? 0.55 : 1,
      "stroke-dasharray": mark.matches(".dash") ? "5 4" : null,
    });
  if (mark.matches(".dot, .ring"))
    return svg("circle", {
      ...{ cx: x + seen.width / 2, cy: middle, r: seen.width / 2 - 1, stroke: color },
      fill: mark.matches(".ring") ? "none" : color,
      "stroke-width": 2,
    });
  return svg("rect", { x, y, width: seen.width, height: seen.height, rx: 2, fill: color });
}

/// Marks and words of a legend's entry.
function legendEntry(entry, origin) {
  const mark = entry.firstElementChild;
  const seen = mark.getBoundingClientRect();
  const { opacity } = getComputedStyle(entry);
  const words = wordsAt(entry, entry.textContent, seen.right + 6, origin);
  return svg("g", { opacity }, patch(mark, seen, origin), words);
}

/// Titles within a figure: names of planes, and the quantity that was chosen.
function titles(figure, origin) {
  const heads = [...figure.querySelectorAll(".plane > h3")].map((node) => [node, node.textContent]);
  const chosen = [...figure.querySelectorAll(".chooser select")].map((node) => [
    node,
    node.selectedOptions[0]?.textContent ?? "",
  ]);
  return [...heads, ...chosen].map(([node, words]) =>
    wordsAt(node, words, node.getBoundingClientRect().left, origin),
  );
}

/// `var(--name)` in a copied style has no meaning outside the page.
function resolved(root) {
  const page = getComputedStyle(document.documentElement);
  for (const node of root.querySelectorAll("[fill^='var('], [stroke^='var(']"))
    for (const key of ["fill", "stroke"]) {
      const name = node.getAttribute(key)?.match(/^var\((--[\w-]+)\)$/)?.[1];
      if (name) node.setAttribute(key, page.getPropertyValue(name).trim());
    }
  return root;
}

/// Everything a figure draws, with its legend, as the text of an SVG file. Frames of charts that
/// are not SVG in the page have a function `toSvg`.
export function figureSvg(figure) {
  const frames = [...figure.querySelectorAll(".chart")].filter((frame) => frame.toSvg);
  const rooms = frames.map((frame) => frame.getBoundingClientRect());
  const drawn = frames.map((frame) => frame.appendChild(frame.toSvg()));
  const boxes = new Map(drawn.map((node, i) => [node, rooms[i]]));
  const plots = [...figure.querySelectorAll("svg.plot")].filter((node) => !node.closest("button"));
  const entries = [...figure.querySelectorAll(".legend > *")];
  const boxOf = (node) => boxes.get(node) ?? node.getBoundingClientRect();
  const heads = figure.querySelectorAll(".plane > h3, .chooser select");
  const all = [...plots, ...entries, ...heads].map(boxOf);
  const origin = {
    x: Math.min(...all.map((b) => b.left)) - 8,
    y: Math.min(...all.map((b) => b.top)) - 8,
  };
  const width = Math.max(...all.map((b) => b.right)) + 8 - origin.x;
  const height = Math.max(...all.map((b) => b.bottom)) + 8 - origin.y;
  const page = getComputedStyle(document.documentElement).getPropertyValue("--page").trim();
  const whole = svg(
    "svg",
    { xmlns: "http://www.w3.org/2000/svg", width, height, viewBox: `0 0 ${width} ${height}` },
    svg("rect", { width, height, fill: page }),
    ...titles(figure, origin),
    ...entries.map((entry) => legendEntry(entry, origin)),
    ...plots.map((node) => placed(node, boxOf(node), origin)),
  );
  drawn.forEach((node) => node.remove());
  return new XMLSerializer().serializeToString(resolved(whole));
}
