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

const classOf = (ok, caution) => (caution ? "caution" : ok ? "good" : "bad");

/// `ok` false: a red bar over the whole width, with every reason. `caution`: a yellow one.
export const drawBanner = ({ ok, caution = false, title, text, reasons = [] }) =>
  el(
    "div",
    { class: `banner ${classOf(ok, caution)}`, role: ok || caution ? "status" : "alert" },
    el(
      "p",
      { class: "banner-title" },
      el("span", { "aria-hidden": "true" }, MARK[ok && !caution]),
      title,
    ),
    ...listed(reasons),
    text ? el("p", {}, text) : null,
  );
