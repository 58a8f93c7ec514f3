// The tree of the world: hands, objects, obstacles; each can be selected, hidden, removed.

import { el } from "../../report/dom.js";
import { ownersOf } from "../link/store.js";
import { button } from "./controls.js";

const GROUPS = [
  ["hand", "Hands"],
  ["object", "Objects"],
  ["obstacle", "Obstacles"],
];

function entry(app, { name, movable }) {
  const { store, picture } = app;
  const hidden = picture.bodies.hidden.has(name);
  const select = button(name, () => app.select({ owner: name }), {
    ...{ class: "pick", "aria-pressed": String(store.selected?.owner === name) },
    title: movable ? `Select ${name}` : `Select ${name}, which stands fast`,
  });
  const eye = button(hidden ? "\u25cb" : "\u25cf", () => app.hide(name, !hidden), {
    ...{ class: "eye", "aria-pressed": String(!hidden), "aria-label": `Show ${name}` },
    title: hidden ? "Show" : "Hide",
  });
  const away = button("\u00d7", () => app.ask("world.remove", { name }), {
    ...{ class: "away", "aria-label": `Remove ${name}`, title: "Remove from the world" },
  });
  return el("li", {}, eye, select, store.scene.mode === "world" ? away : null);
}

/// The tree; it follows the scene and the selection.
export function makeTree(app) {
  const { store } = app;
  const body = el("div", { class: "tree-body" });
  const tree = el("nav", { class: "tree", "aria-label": "World" }, el("h2", {}, "World"), body);
  const draw = () => {
    const owners = store.scene ? ownersOf(store.scene) : [];
    // The button that has the focus keeps it.
    const focus = document.activeElement?.closest(".tree") ? document.activeElement : null;
    const key = focus && [focus.className, focus.closest("li")?.textContent];
    const groups = GROUPS.flatMap(([kind, title]) => {
      const members = owners.filter((owner) => owner.kind === kind);
      if (!members.length) return [];
      return [el("h3", {}, title), el("ul", {}, ...members.map((one) => entry(app, one)))];
    });
    const nothing = el(
      "p",
      { class: "hint" },
      "Nothing is here yet. Open a world, add a hand or an object, or drop files onto the picture.",
    );
    body.replaceChildren(...(groups.length ? groups : [nothing]));
    if (key)
      [...body.querySelectorAll("button")]
        .find((one) => one.className === key[0] && one.closest("li").textContent === key[1])
        ?.focus();
  };
  store.on(["scene", "selected", "hidden"], draw);
  draw();
  return tree;
}
