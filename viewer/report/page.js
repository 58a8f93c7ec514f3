// The page around the blocks: heading, table of contents, sections, provenance.

import { drawBlock } from "./blocks.js";
import { breakable, el, paragraphs } from "./dom.js";
import { errorBox } from "./figure.js";
import { foldingTitle, startFolding } from "./folding.js";
import { withMeshes } from "./meshes.js";
import { neighbours, openingParagraph, pageList, summaryList } from "./opening.js";
import { tableOfContents } from "./contents.js";

const heading = (report) =>
  el(
    "header",
    { class: "heading" },
    el("h1", {}, report.title),
    report.subtitle ? el("p", { class: "subtitle" }, report.subtitle) : null,
  );

/// A section without its blocks.
const emptySection = ({ id, title, text }) =>
  el(
    "section",
    { id, "aria-label": title },
    foldingTitle(
      title,
      el("a", { class: "anchor", href: `#${id}`, "aria-label": `Link to ${title}` }, "#"),
    ),
    el("div", { class: "section-body" }, el("div", { class: "prose" }, ...paragraphs(text))),
  );

/// Numbers figures and tables, each kind on its own. Style sheets cannot: what is folded away does
/// not count for them.
function numberCaptions(root) {
  for (const kind of ["figure", "table"])
    root
      .querySelectorAll(`.${kind}-caption`)
      .forEach((caption, i) => caption.setAttribute("data-number", i + 1));
}

function provenance(facts) {
  const rows = Object.entries(facts ?? {}).flatMap(([name, value]) => [
    el("dt", {}, ...breakable(name)),
    el("dd", {}, String(value ?? "n/a")),
  ]);
  return el(
    "footer",
    {},
    el(
      "details",
      {},
      el("summary", {}, `Provenance (${rows.length / 2} entries)`),
      rows.length ? el("dl", {}, ...rows) : el("p", {}, "This report carries no provenance."),
    ),
  );
}

/// Fills `root` with the whole report.
export function drawPage(root, report) {
  if (!Array.isArray(report.sections)) throw new Error('"sections" is missing');
  document.title = report.title ?? "thenar report";
  const sections = report.sections.map(emptySection);
  const tools = startFolding(sections);
  withMeshes(report).sections.forEach(({ blocks = [] }, i) =>
    sections[i].lastElementChild.append(...blocks.map(drawBlock)),
  );
  root.replaceChildren(
    heading(report),
    tableOfContents(root, report.sections, sections, tools, pageList(report.pages, report.file)),
    el(
      "div",
      { class: "sections" },
      openingParagraph(report.opening) ?? "",
      summaryList(report.summary) ?? "",
      ...(sections.length ? sections : [errorBox("This report has no sections.")]),
      neighbours(report.pages, report.file) ?? "",
    ),
    provenance(report.provenance),
  );
  numberCaptions(root);
}
