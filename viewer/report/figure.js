// What every drawn block has in common: a frame, a caption, and a place for remarks.

import { el } from "./dom.js";

/// `kind` is "figure" or "table": each is numbered on its own by the page.
export const figure = (kind, caption, ...content) =>
  el(
    "figure",
    { class: kind },
    kind === "table" ? captionOf(kind, caption) : null,
    ...content,
    kind === "table" ? null : captionOf(kind, caption),
  );

const captionOf = (kind, caption) => el("figcaption", { class: `${kind}-caption` }, caption ?? "");

/// A remark about what could not be drawn; nothing if there is none.
export const remark = (text) => (text ? el("p", { class: "remark" }, text) : null);

/// A block that cannot be drawn says why, in its place.
export const errorBox = (message) => el("div", { class: "error", role: "alert" }, message);
