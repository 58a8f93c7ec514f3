// The page around the blocks: heading, table of contents, sections, provenance.

import { drawBlock } from "./blocks.js";
import { el, paragraphs } from "./dom.js";
import { errorBox } from "./figure.js";
import { withMeshes } from "./meshes.js";
import { tableOfContents } from "./contents.js";

const heading = (report) =>
  el(
    "header",
    { class: "heading" },
    el("h1", {}, report.title),
    report.subtitle ? el("p", { class: "subtitle" }, report.subtitle) : null,
  );

const section = ({ id, title, text, blocks = [] }) =>
  el(
    "section",
    { id, "aria-label": title },
    el(
      "h2",
      {},
      title,
      el("a", { class: "anchor", href: `#${id}`, "aria-label": `Link to ${title}` }, "#"),
    ),
    el("div", { class: "prose" }, ...paragraphs(text)),
    ...blocks.map(drawBlock),
  );

function provenance(facts) {
  const rows = Object.entries(facts ?? {}).flatMap(([name, value]) => [
    el("dt", {}, name),
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
  const sections = withMeshes(report).sections.map(section);
  root.replaceChildren(
    heading(report),
    tableOfContents(report.sections, sections),
    el(
      "div",
      { class: "sections" },
      ...(sections.length ? sections : [errorBox("This report has no sections.")]),
    ),
    provenance(report.provenance),
  );
}
