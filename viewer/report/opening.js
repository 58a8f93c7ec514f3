// How a page begins: what was asked, done and learnt, and a summary in lines; and how its reader
// comes to the other pages of the same folder.

import { el } from "./dom.js";

const PAGE = /^[\w-]+\.html$/;

/// Whether a text names a page beside this one; links lead nowhere else.
export const isPage = (file) => typeof file === "string" && PAGE.test(file);

const LEADS = [
  ["asked", "Asked."],
  ["done", "Done."],
  ["learnt", "Learnt."],
];

/// The first paragraph of a page; nothing without one.
export function openingParagraph(opening) {
  const parts = LEADS.filter(([key]) => opening?.[key]);
  if (!parts.length) return null;
  const words = parts.flatMap(([key, lead]) => [
    el("strong", {}, lead),
    ` ${String(opening[key]).trim()} `,
  ]);
  return el("div", { class: "prose opening" }, el("p", {}, ...words));
}

const linkOf = ({ file, link }) =>
  isPage(file) ? el("a", { href: file }, link ?? "Details") : null;

/// A numbered list of lines, each with a link to the page that says more; nothing without lines.
export function summaryList(lines) {
  if (!lines?.length) return null;
  const items = lines.map((line) => el("li", {}, `${line.text} `, linkOf(line)));
  return el(
    "div",
    { class: "summary", role: "region", "aria-label": "Summary" },
    el("h2", {}, "Summary"),
    el("ol", {}, ...items),
  );
}

/// The pages of a folder, the present one marked; nothing where it is the only one.
export function pageList(pages, file) {
  const known = (pages ?? []).filter((page) => isPage(page.file));
  if (known.length < 2) return null;
  const items = known.map((page) =>
    el(
      "li",
      {},
      el(
        "a",
        { href: page.file, "aria-current": page.file === file ? "page" : null },
        page.title ?? page.file,
      ),
    ),
  );
  return el("div", { class: "page-list" }, el("p", {}, "Pages"), el("ol", {}, ...items));
}

/// Links to the page before and after this one, for its end.
export function neighbours(pages, file) {
  const known = (pages ?? []).filter((page) => isPage(page.file));
  const at = known.findIndex((page) => page.file === file);
  if (at < 0 || known.length < 2) return null;
  const to = (page, before, after) =>
    page ? el("a", { href: page.file }, `${before}${page.title ?? page.file}${after}`) : el("span");
  return el(
    "nav",
    { class: "neighbours", "aria-label": "Pages before and after" },
    to(known[at - 1], "\u2190 ", ""),
    to(known[at + 1], "", " \u2192"),
  );
}
