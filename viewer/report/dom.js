// Makes elements. Text only ever enters the page as text, so a report cannot inject HTML.

const SVG = "http://www.w3.org/2000/svg";

function fill(node, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (key.startsWith("on")) node.addEventListener(key.slice(2), value);
    // Pages whose policy forbids inline styles allow those that a script sets.
    else if (key === "style") node.style.cssText = value;
    else node.setAttribute(key, value === true ? "" : value);
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

/// An HTML element: el("p", { class: "note", onclick: f }, "text", other).
export const el = (tag, attributes = {}, ...children) =>
  fill(document.createElement(tag), attributes, children);

/// The same for SVG.
export const svg = (tag, attributes = {}, ...children) =>
  fill(document.createElementNS(SVG, tag), attributes, children);

/// A name as children of an element, which may be broken behind its slashes and nowhere else.
export const breakable = (name) =>
  name.split(/(?<=\/)/).flatMap((part, i) => (i === 0 ? [part] : [el("wbr"), part]));

/// Plain text as paragraphs; an empty line separates them.
export const paragraphs = (text) =>
  String(text ?? "")
    .split(/\n\s*\n/)
    .filter((part) => part.trim())
    .map((part) => el("p", {}, part.trim()));
