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

/// Marks and words of a legend's entry, where they stand.
function legendEntry(entry, origin) {
  const mark = entry.firstElementChild;
  const seen = mark.getBoundingClientRect();
  const words = entry.getBoundingClientRect();
  const { color, fontFamily, fontSize, opacity } = getComputedStyle(entry);
  const patch =
    mark instanceof SVGElement
      ? placed(mark, seen, origin)
      : svg("rect", {
          x: seen.x - origin.x,
          y: seen.y - origin.y,
          width: seen.width,
          height: Math.max(2, seen.height),
          rx: mark.matches(".dot, .ring") ? seen.width / 2 : 0,
          fill: getComputedStyle(mark).getPropertyValue("--swatch").trim(),
        });
  const text = svg(
    "text",
    {
      x: seen.right + 6 - origin.x,
      y: words.y + words.height / 2 + 4 - origin.y,
      style: `font-family: ${fontFamily}; font-size: ${fontSize}`,
      fill: color,
    },
    entry.textContent,
  );
  return svg("g", { opacity }, patch, text);
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
  const all = [...plots.map(boxOf), ...entries.map(boxOf)];
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
    ...entries.map((entry) => legendEntry(entry, origin)),
    ...plots.map((node) => placed(node, boxOf(node), origin)),
  );
  drawn.forEach((node) => node.remove());
  return new XMLSerializer().serializeToString(resolved(whole));
}
