// Help with all keys, questions before something is lost, and where to save.

import { el } from "../../report/dom.js";
import { button, freshId } from "./controls.js";

const HELP = [
  [
    "Everywhere",
    [
      ["Tab, Shift+Tab", "go through everything that can be used"],
      ["?", "this help"],
      ["Ctrl+Z, Ctrl+Y", "undo, redo"],
      ["Ctrl+O, Ctrl+S", "open, save"],
      ["Esc", "deselect; close a dialog"],
      ["1 to 5", "the tabs Pose, Grasp, Tendons, Fit, Time"],
      ["G, O, C", "grasp, open the hand, close it"],
      ["Space", "play or pause; . one step of time"],
    ],
  ],
  [
    "On the picture",
    [
      ["drag, right drag, wheel", "turn, move, zoom the view"],
      ["click", "select a body and its joint"],
      ["arrow keys", "turn the view; with a selection move it"],
      ["+ and \u2212", "zoom; with a joint selected turn that by 1\u00b0 or 1 mm (Shift: 10)"],
      ["0 or Home", "show everything"],
      ["PageUp, PageDown", "the previous and the next thing"],
      ["[ and ]", "the previous and the next joint of the hand"],
      ["x, y, z", "choose the axis that arrow keys move along or turn about"],
      ["t, r", "arrow keys move, or turn, what is selected"],
      ["Left, Right", "by 1 mm or 1\u00b0; Up, Down: by 10 mm or 10\u00b0"],
      ["Shift while dragging", "steps of 10 mm and 15\u00b0"],
    ],
  ],
  [
    "On a slider",
    [
      ["arrow keys", "one step; with Shift a tenth"],
      ["PageUp, PageDown", "ten steps up, ten steps down"],
      ["Home, End", "to the limits"],
    ],
  ],
];

function dialogOf(title, ...content) {
  const id = freshId("dialog");
  const dialog = el(
    "dialog",
    { "aria-labelledby": id },
    el(
      "div",
      { class: "dialog-head" },
      el("h2", { id }, title),
      button("\u00d7", () => dialog.close(), { "aria-label": "Close" }),
    ),
    ...content,
  );
  document.body.append(dialog);
  return dialog;
}

/// The help; returns a function that opens it.
export function makeHelp() {
  const dialog = dialogOf(
    "Keys and gestures",
    el(
      "div",
      { class: "help" },
      ...HELP.flatMap(([title, rows]) => [
        el("h3", {}, title),
        el("dl", {}, ...rows.flatMap(([keys, words]) => [el("dt", {}, keys), el("dd", {}, words)])),
      ]),
    ),
  );
  dialog.classList.add("help-dialog");
  return () => dialog.showModal();
}

/// Asks a question with two answers; promises whether the first was given.
export function ask(question, yes, no = "Cancel") {
  return new Promise((done) => {
    const dialog = dialogOf(
      question,
      el(
        "div",
        { class: "buttons" },
        button(yes, () => dialog.close("yes"), { class: "main" }),
        button(no, () => dialog.close("")),
      ),
    );
    dialog.addEventListener("close", () => {
      dialog.remove();
      done(dialog.returnValue === "yes");
    });
    dialog.showModal();
  });
}

/// Asks for the name of a file; promises { name, where: "here" | "download" }, or null.
export function askFile(before) {
  return new Promise((done) => {
    const id = freshId("file");
    const input = el("input", { id, type: "text", value: before, autocomplete: "off" });
    let answer = null;
    const take = (where) => {
      if (!input.value.trim()) return input.focus();
      answer = { name: input.value.trim(), where };
      dialog.close();
    };
    const dialog = dialogOf(
      "Save the world",
      el("div", { class: "choice" }, el("label", { for: id }, "File"), input),
      el(
        "p",
        { class: "hint" },
        "A relative path that ends in .toml, below the folder thenar was started in.",
      ),
      el(
        "div",
        { class: "buttons" },
        button("Save", () => take("here"), { class: "main", id: "save-here" }),
        button("Download", () => take("download"), { id: "save-download" }),
      ),
    );
    input.addEventListener("keydown", (event) => event.key === "Enter" && take("here"));
    dialog.addEventListener("close", () => {
      dialog.remove();
      done(answer);
    });
    dialog.showModal();
    input.focus();
    input.select();
  });
}
