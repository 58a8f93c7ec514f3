// Dialog for opening and adding things by name, with a search.

import { el } from "../../report/dom.js";
import { button, freshId } from "./controls.js";

// Request of an entry, for each kind of the catalogue.
const KINDS = {
  worlds: { title: "Worlds", verb: "Open", ask: (name) => ["world.load", { world: name }] },
  scenes: {
    title: "Scenes in time",
    verb: "Open",
    ask: (name) => ["motion.open", { scene: name }],
  },
  subjects: { title: "Digits with tendons", verb: "Open" },
  hands: { title: "Hands", verb: "Add", ask: (name) => ["world.add_hand", { hand: name }] },
  objects: { title: "Objects", verb: "Add", ask: (name) => ["world.add_object", { object: name }] },
};

/// Returns true if an entry contains all words of a search.
export const matches = (entry, search) => {
  const text = [entry.name, entry.kind, entry.about].join(" ").toLowerCase();
  return search
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
};

/// An entry of the list.
const rowOf = ({ name, about }, verb, work) =>
  el(
    "li",
    {},
    button(el("span", {}, el("b", {}, name), el("span", { class: "about" }, about ?? "")), work, {
      "aria-label": `${verb} ${name}`,
    }),
  );

/// The list, in which arrows go from entry to entry, and Enter in the search takes the first.
function makeCatalogue(search) {
  const list = el("ul", { class: "catalogue" });
  search.addEventListener("keydown", ({ key }) => {
    if (key === "Enter") list.querySelector("button")?.click();
    if (key === "ArrowDown") list.querySelector("button")?.focus();
  });
  list.addEventListener("keydown", ({ key }) => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[key];
    if (!by) return;
    const all = [...list.querySelectorAll("button")];
    all[all.indexOf(document.activeElement) + by]?.focus();
  });
  return list;
}

/// Returns the catalogue of a kind; requested once.
function entriesFrom(app) {
  const cache = new Map();
  return async (what) => {
    if (!cache.has(what)) {
      const found = await app.ask("catalogue.list", { what });
      if (!found) return [];
      cache.set(what, found.entries);
    }
    return cache.get(what);
  };
}

/// Digits of a subject, each as an entry of the list that opens it; where there is one it is opened at once.
async function takeSubject(app, subject, list, close) {
  const found = await app.ask("catalogue.list", { what: "digits", of: subject.name });
  const digits = found?.entries ?? [];
  const openDigit = (digit) => {
    close();
    app.ask("tendons.open", { subject: subject.name, ...(digit ? { digit } : {}) });
  };
  if (digits.length < 2) return openDigit(digits[0]?.name);
  const row = ({ name, about }) =>
    rowOf({ name, about: about || subject.name }, "Open", () => openDigit(name));
  list.replaceChildren(...digits.map(row));
  list.querySelector("button").focus();
}

/// The buttons of the kinds; `choose(name)` hears which is pressed.
const kindButtons = (choose) =>
  Object.entries(KINDS).map(([name, { title }]) => {
    const one = button(title, () => choose(name), { class: "kind" });
    one.dataset.kind = name;
    return one;
  });

/// The dialog; open(kind) shows it.
export function makeOpenDialog(app) {
  const entriesOf = entriesFrom(app);
  const search = el("input", {
    ...{ type: "search", placeholder: "Search", "aria-label": "Search", autocomplete: "off" },
  });
  const list = makeCatalogue(search);
  const id = freshId("open");
  const kinds = kindButtons(choose);
  const close = () => dialog.close();
  const head = el(
    "div",
    { class: "dialog-head" },
    el("h2", { id }, "Open or add"),
    button("\u00d7", close, { "aria-label": "Close" }),
  );
  const dialog = el(
    "dialog",
    { "aria-labelledby": id, class: "open-dialog" },
    head,
    el("div", { class: "kinds", role: "group", "aria-label": "Kind" }, ...kinds),
    search,
    list,
  );
  let kind = "worlds";

  async function take(entry) {
    if (kind === "subjects") return takeSubject(app, entry, list, close);
    close();
    const [method, params] = KINDS[kind].ask(entry.name);
    if (kind === "worlds" && !(await app.mayLeave())) return;
    await app.ask(method, params);
  }
  async function fill() {
    const wanted = kind;
    const all = await entriesOf(wanted);
    if (wanted !== kind) return;
    const found = all.filter((entry) => matches(entry, search.value));
    list.replaceChildren(
      ...found.map((entry) => rowOf(entry, KINDS[wanted].verb, () => take(entry))),
      ...(found.length ? [] : [el("li", { class: "hint" }, "Nothing has that name.")]),
    );
  }
  function choose(next) {
    kind = next;
    for (const one of kinds) one.setAttribute("aria-pressed", String(one.dataset.kind === kind));
    fill();
  }
  search.addEventListener("input", fill);
  document.body.append(dialog);
  return (first) => {
    dialog.showModal();
    search.value = "";
    choose(first ?? kind);
    search.focus();
  };
}
