// The table of contents, which marks the section being read.

import { el } from "./dom.js";

/// The last section whose top has passed the upper third of the window.
function current(elements) {
  const passed = elements.filter(
    (element) => element.getBoundingClientRect().top < innerHeight / 3,
  );
  return passed.at(-1) ?? elements[0];
}

function follow(links, elements) {
  const mark = () => {
    const here = current(elements);
    links.forEach((link, i) => link.toggleAttribute("aria-current", elements[i] === here));
  };
  addEventListener("scroll", mark, { passive: true });
  requestAnimationFrame(mark);
}

/// Links to `sections`, whose drawn `elements` tell what is in view.
export function tableOfContents(sections, elements) {
  const links = sections.map(({ id, title }) => el("a", { href: `#${id}` }, title));
  if (links.length) follow(links, elements);
  return el(
    "nav",
    { class: "contents", "aria-label": "Contents" },
    el("ol", {}, ...links.map((link) => el("li", {}, link))),
  );
}
