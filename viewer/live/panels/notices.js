// Notices of the page: errors until they are dismissed, progress with Stop, the connection, and texts for
// screen readers.

import { el } from "../../report/dom.js";
import { button } from "./controls.js";

const LONG = 12000; // a note that is no error goes by itself after [ms]
const MOST = 4; // notes at once
const SHOW_AFTER = 250; // requests shorter than this show no bar [ms]

/// Everything below `root`; `stop()` asks the server to stop what it does.
export function makeNotices(root, stop) {
  const notes = el("div", { class: "notes" });
  const banner = el("div", { class: "lost", role: "alert", hidden: true });
  const live = el("div", { class: "hidden-words", role: "status", "aria-live": "polite" });
  const bar = el("progress", { max: 1 });
  const words = el("span", { class: "words" });
  const work = el(
    "div",
    { class: "work", role: "group", "aria-label": "Progress", hidden: true },
    words,
    bar,
    button("Stop", stop, { class: "stop" }),
  );
  root.append(banner, work, notes, live);

  function note(text, kind) {
    const same = [...notes.children].find((one) => one.dataset.text === text);
    same?.remove();
    while (notes.children.length >= MOST) notes.firstElementChild.remove();
    const made = el(
      "div",
      { class: `note-box ${kind}`, role: kind === "error" ? "alert" : "status" },
      el("p", {}, text),
    );
    made.dataset.text = text;
    made.append(button("\u00d7", () => made.remove(), { "aria-label": "Close this note" }));
    notes.append(made);
    if (kind !== "error") setTimeout(() => made.remove(), LONG);
  }

  let shown = null; // the timer of the bar
  const progress = ({ text, fraction }) => {
    words.textContent = text;
    if (Number.isFinite(fraction)) bar.value = fraction;
    else bar.removeAttribute("value");
  };
  const busy = (text) => {
    if (!text) {
      clearTimeout(shown);
      shown = null;
      work.hidden = true;
      return;
    }
    if (shown === null) {
      progress({ text });
      shown = setTimeout(() => (work.hidden = false), SHOW_AFTER);
    }
  };
  return {
    error: (text) => note(text, "error"),
    tell: (text) => note(text, "told"),
    say: (text) => (live.textContent = text),
    progress,
    busy,
    link: ({ connected, wait, lost = [] }) => {
      banner.hidden = connected;
      const what = lost.length ? ` No answer came to ${lost.join(", ")}.` : "";
      banner.textContent = connected
        ? ""
        : `The connection to thenar is lost; trying again in ${(wait / 1000).toFixed(1)}\u202fs.${what}`;
    },
  };
}
