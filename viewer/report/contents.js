// The table of contents: a column beside the page that marks the section being read, and can be
// put away.

import { el } from "./dom.js";
import { groupedTitles } from "./contents_model.js";

/// The last section whose top has passed the upper third of the window.
function current(elements) {
  const passed = elements.filter(
    (element) => element.getBoundingClientRect().top < innerHeight / 3,
  );
  return passed.at(-1) ?? elements[0];
}

/// Marks the link of the section in view, and opens the group it stands in, and no other.
function follow(links, elements) {
  let opened = null;
  const mark = () => {
    const here = links[elements.indexOf(current(elements))];
    if (here.hasAttribute("aria-current")) return;
    links.forEach((link) => link.toggleAttribute("aria-current", link === here));
    const group = here.closest("details");
    if (opened && opened !== group) opened.open = false;
    if (group) group.open = true;
    opened = group;
  };
  addEventListener("scroll", mark, { passive: true });
  requestAnimationFrame(mark);
}

/// The button that shows the list and puts it away.
function switcher(page, list) {
  const button = el("button", { type: "button", class: "contents-switch" });
  const set = (shown) => {
    list.hidden = !shown;
    page.classList.toggle("no-contents", !shown);
    button.setAttribute("aria-expanded", String(shown));
    button.title = shown ? "Put the contents away" : "Show the contents";
    button.textContent = shown ? "Contents \u2039" : "\u203a Contents";
  };
  button.addEventListener("click", () => set(list.hidden));
  const narrow = matchMedia("(max-width: 1100px)");
  narrow.addEventListener("change", () => set(!narrow.matches));
  set(!narrow.matches);
  return button;
}

/// Links to `sections`, whose drawn `elements` tell what is in view; `tools` stand below them, the
/// list of `pages` above them if there is one, and `page` is the element that makes room for it all.
export function tableOfContents(page, sections, elements, tools, pages) {
  const links = sections.map(({ id }) => el("a", { href: `#${id}` }));
  const entry = ({ index, title }) => {
    links[index].textContent = title;
    return el("li", {}, links[index]);
  };
  const groups = groupedTitles(sections.map(({ title }) => title)).map((group) =>
    group.entries
      ? el(
          "li",
          {},
          el(
            "details",
            {},
            el("summary", {}, group.title),
            el("ol", {}, ...group.entries.map(entry)),
          ),
        )
      : entry(group),
  );
  if (links.length) follow(links, elements);
  const here = pages ? el("p", {}, "On this page") : null;
  const list = el("div", { class: "contents-list" }, pages, here, el("ol", {}, ...groups), tools);
  return el("nav", { class: "contents", "aria-label": "Contents" }, switcher(page, list), list);
}
