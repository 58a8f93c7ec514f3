// Whether the numbers of a page may be believed, before any of them.

import { el } from "./dom.js";

const MARK = { true: "\u2713", false: "\u26a0" };
const SHOWN = 8; // reasons; more are behind a fold

const listOf = (reasons) => el("ul", {}, ...reasons.map((reason) => el("li", {}, reason)));

function listed(reasons) {
  if (!reasons.length) return [];
  const more = reasons.slice(SHOWN);
  return [
    listOf(reasons.slice(0, SHOWN)),
    more.length
      ? el("details", {}, el("summary", {}, `${more.length} more reasons`), listOf(more))
      : null,
  ];
}

/// `ok` false: a red bar over the whole width, with every reason.
export const drawBanner = ({ ok, title, text, reasons = [] }) =>
  el(
    "div",
    { class: `banner ${ok ? "good" : "bad"}`, role: ok ? "status" : "alert" },
    el("p", { class: "banner-title" }, el("span", { "aria-hidden": "true" }, MARK[ok]), title),
    ...listed(reasons),
    text ? el("p", {}, text) : null,
  );
