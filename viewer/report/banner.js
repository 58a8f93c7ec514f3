// Whether the numbers of a page may be believed, before any of them.

import { el } from "./dom.js";

const MARK = { true: "\u2713", false: "\u26a0" };

/// `ok` false: a red bar over the whole width, with every reason.
export const drawBanner = ({ ok, title, text, reasons = [] }) =>
  el(
    "div",
    { class: `banner ${ok ? "good" : "bad"}`, role: ok ? "status" : "alert" },
    el("p", { class: "banner-title" }, el("span", { "aria-hidden": "true" }, MARK[ok]), title),
    reasons.length ? el("ul", {}, ...reasons.map((reason) => el("li", {}, reason))) : null,
    text ? el("p", {}, text) : null,
  );
