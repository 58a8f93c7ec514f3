// The bar on top: files, undo, export, what is shown, and whether thenar is there.

import { el } from "../../report/dom.js";
import { button, freshId, sliderRow, slowButton, tick } from "./controls.js";
import { QUANTITIES } from "../link/quantities.js";

/// A button with what opens below it; closes by Escape and by a click elsewhere.
function menu(words, content, more = {}) {
  const id = freshId("menu");
  content.id = id;
  content.classList.add("items");
  const opener = button(words, () => show(opener.getAttribute("aria-expanded") !== "true"), {
    ...{ class: "opener", "aria-expanded": "false", "aria-controls": id },
    ...more,
  });
  const box = el("div", { class: "menu" }, opener, content);
  function show(on) {
    opener.setAttribute("aria-expanded", String(on));
    box.classList.toggle("open", on);
    if (on) {
      const { left, bottom } = opener.getBoundingClientRect();
      content.style.setProperty("--left", `${Math.max(8, Math.min(left, innerWidth - 250))}px`);
      content.style.setProperty("--top", `${bottom + 4}px`);
      content.querySelector("button, input")?.focus();
    }
  }
  box.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !box.classList.contains("open")) return;
    event.stopPropagation();
    show(false);
    opener.focus();
  });
  addEventListener("pointerdown", ({ target }) => box.contains(target) || show(false));
  box.addEventListener("click", ({ target }) => {
    if (target.closest(".items") && target.matches("button")) show(false);
  });
  return box;
}

function fileGroup(app) {
  const items = el(
    "div",
    {},
    slowButton("New", app.newWorld, { id: "new", title: "An empty world" }),
    button("Open", () => app.openDialog(), {
      id: "open",
      title: "Worlds, scenes, digits, hands, objects (Ctrl+O)",
    }),
    slowButton("Save", app.save, { id: "save", title: "Save or download the world (Ctrl+S)" }),
    button("Import", () => app.importFiles(), {
      id: "import",
      title: "Meshes, robots, worlds; or drop files onto the picture",
    }),
  );
  const group = menu("File", items);
  group.classList.add("file");
  return group;
}

function exportMenu(app) {
  const film = slowButton(
    "Begin a film",
    async () => {
      film.textContent = (await app.film()) ? "End the film" : "Begin a film";
    },
    { id: "film" },
  );
  return menu(
    "Export",
    el(
      "div",
      {},
      slowButton("Picture (PNG)", app.savePicture, { id: "export-png" }),
      slowButton("Scene (glTF)", app.saveGltf, { id: "export-gltf" }),
      slowButton("Charts (SVG)", app.saveCharts, { id: "export-svg" }),
      film,
      button("Print the picture", () => print()),
    ),
  );
}

function viewMenu(app) {
  const { picture, view } = app;
  const opacity = (name, layer) => {
    const row = sliderRow({ name, lower: 0, upper: 1, quantity: QUANTITIES.share }, (value) =>
      view.opacity(layer, value),
    );
    row.set(picture.bodies.opacities[layer]);
    return row;
  };
  const box = (words, on, change) => tick(words, on, change);
  return menu(
    "View",
    el(
      "div",
      { class: "view-menu" },
      opacity("skin", "hands"),
      opacity("objects", "objects"),
      box("grid", true, view.grid),
      box("shadows", true, view.shadows),
      box("names", false, view.names),
      box("contacts", true, (on) => view.contacts("contacts", on)),
      box("friction cones", true, (on) => view.contacts("cones", on)),
      box("contact forces", true, (on) => view.contacts("forces", on)),
      box("tendons", true, view.lines),
      box("arrows", true, view.vectors),
      button("Show everything", () => view.fit()),
    ),
  );
}

export function makeBar(app) {
  const { store } = app;
  const name = el("span", { class: "world-name" });
  const link = el("span", { class: "link", role: "status" });
  const undo = slowButton("Undo", () => app.ask("session.undo"), { id: "undo" });
  const redo = slowButton("Redo", () => app.ask("session.redo"), { id: "redo" });
  const bar = el(
    "header",
    { class: "bar" },
    el("h1", {}, "thenar"),
    fileGroup(app),
    el("div", { class: "group" }, undo, redo),
    exportMenu(app),
    viewMenu(app),
    button("?", () => app.help(), {
      id: "help",
      "aria-label": "Help: all keys",
      title: "Help (?)",
    }),
    name,
    link,
  );
  const show = () => {
    const { state, link: there } = store;
    undo.disabled = !state?.undo;
    redo.disabled = !state?.redo;
    undo.title = state?.undo ? `Undo: ${state.undo} (Ctrl+Z)` : "Nothing to undo";
    redo.title = state?.redo ? `Redo: ${state.redo} (Ctrl+Y)` : "Nothing to redo";
    const world = state?.world ?? {};
    name.textContent = [world.name ?? "", world.unsaved ? "(not saved)" : ""]
      .filter(Boolean)
      .join(" ");
    document.title = world.name ? `${world.name} \u2013 thenar` : "thenar";
    const others = (state?.clients ?? 1) - 1;
    link.className = there ? "link on" : "link off";
    link.textContent = there
      ? others > 0
        ? `connected, with ${others} more`
        : "connected"
      : "not connected";
  };
  store.on(["state", "link"], show);
  show();
  return bar;
}
