// Sections that can be folded away, so that a long report stays within reach.

import { el } from "./dom.js";

const LONG = 10; // sections, from which on a report starts folded
const OPEN = 2; // sections that a long report shows at the start

const bodyOf = (section) => section.querySelector(":scope > .section-body");
const buttonOf = (section) => section.querySelector(":scope > h2 > .fold");

export const isFolded = (section) => bodyOf(section).hasAttribute("hidden");

/// Folds a section, or opens it. Folded text is still found by the search of the browser, where it
/// knows how to.
export function setFolded(section, folded) {
  if (folded) bodyOf(section).setAttribute("hidden", "until-found");
  else bodyOf(section).removeAttribute("hidden");
  section.classList.toggle("is-folded", folded);
  buttonOf(section).setAttribute("aria-expanded", String(!folded));
}

/// A title that folds what stands below it.
export const foldingTitle = (title, ...more) =>
  el(
    "h2",
    {},
    el(
      "button",
      {
        type: "button",
        class: "fold",
        "aria-expanded": "true",
        title: "Fold or open this section",
        onclick: (event) => {
          const section = event.currentTarget.closest("section");
          setFolded(section, !isFolded(section));
        },
      },
      title,
    ),
    ...more,
  );

/// The section that a link within the page leads to.
const linked = (hash) =>
  hash.length > 1 && document.getElementById(hash.slice(1))?.closest("section");

function openLinked() {
  const section = linked(location.hash);
  if (!section || !bodyOf(section)) return;
  setFolded(section, false);
  section.scrollIntoView();
}

/// Everything is printed: sections are opened before, and folded again after.
function openForPrint(sections) {
  let folded = [];
  addEventListener("beforeprint", () => {
    folded = sections.filter(isFolded);
    folded.forEach((section) => setFolded(section, false));
  });
  addEventListener("afterprint", () => folded.forEach((section) => setFolded(section, true)));
}

/// Folds a long report but for its start, opens what links and searches lead to, and returns the
/// buttons for all sections. `sections` are filled by the caller afterwards.
export function startFolding(sections) {
  openForPrint(sections);
  addEventListener("hashchange", openLinked);
  document.addEventListener("click", (event) => {
    const hash = event.target.closest?.("a[href^='#']")?.getAttribute("href");
    const section = hash && linked(hash);
    if (section && bodyOf(section)) setFolded(section, false);
  });
  for (const section of sections)
    bodyOf(section).addEventListener("beforematch", () => setFolded(section, false));
  if (sections.length >= LONG) sections.slice(OPEN).forEach((section) => setFolded(section, true));
  requestAnimationFrame(openLinked);
  if (sections.length < 2) return null;
  const all = (folded) => () => sections.forEach((section) => setFolded(section, folded));
  return el(
    "div",
    { class: "tools" },
    el("button", { type: "button", onclick: all(false) }, "Open all"),
    el("button", { type: "button", onclick: all(true) }, "Fold all"),
  );
}
