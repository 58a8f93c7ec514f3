// Lays out the live page and connects it.

import { el } from "../report/dom.js";
import { watchTheme } from "../report/theme.js";
import { makeApp } from "./app.js";
import { pageKeys, pictureKeys } from "./keys.js";
import { makeBar } from "./panels/bar.js";
import { button, tabs } from "./panels/controls.js";
import { makeHelp } from "./panels/dialogs.js";
import { makeFitPanel } from "./panels/fit_panel.js";
import { makeGraspPanel } from "./panels/grasp_panel.js";
import { makeOpenDialog } from "./panels/open_dialog.js";
import { makePosePanel } from "./panels/pose_panel.js";
import { makeTendonPanel } from "./panels/tendon_panel.js";
import { makeTimePanel } from "./panels/time_panel.js";
import { makeTree } from "./panels/tree.js";

const OF_MODE = { world: "pose", motion: "time", tendons: "tendons", fit: "fit" };
const NARROW = matchMedia("(max-width: 700px)");

/// The panel at the side, whose tabs follow the mode.
function makeSide(app, tree) {
  const pages = [
    { id: "pose", title: "Pose", element: makePosePanel(app) },
    { id: "grasp", title: "Grasp", element: makeGraspPanel(app) },
    { id: "tendons", title: "Tendons", element: makeTendonPanel(app) },
    { id: "fit", title: "Fit", element: makeFitPanel(app) },
    { id: "time", title: "Time", element: makeTimePanel(app) },
    { id: "world", title: "World", element: el("div", { class: "page world" }) },
  ];
  app.tabs = tabs(pages, "Panels", (tab) => app.store.set({ tab }));
  const fold = button(
    "\u25be",
    () => {
      const folded = side.classList.toggle("folded");
      fold.setAttribute("aria-expanded", String(!folded));
      fold.textContent = folded ? "\u25b4" : "\u25be";
      arrange(app);
    },
    { class: "fold-panel", "aria-expanded": "true", "aria-label": "Fold the panel" },
  );
  const side = el(
    "aside",
    { class: "side", "aria-label": "Controls" },
    el("div", { class: "side-head" }, app.tabs.list, fold),
    el("div", { class: "pages" }, ...pages.map(({ element }) => element)),
  );
  // In a narrow window the tree is one of the tabs.
  const home = el("div", { class: "tree-home" });
  const settle = () => {
    (NARROW.matches ? pages.at(-1).element : home).append(tree);
    if (!NARROW.matches && app.tabs.chosen() === "world") app.tabs.choose("pose");
  };
  NARROW.addEventListener("change", settle);
  settle();
  app.tabs.choose("pose");
  let mode = "world";
  app.store.on(["scene"], ({ scene }) => {
    if (scene.mode !== mode) app.tabs.choose(OF_MODE[scene.mode] ?? "pose");
    mode = scene.mode;
  });
  return { side, home };
}

/// Sets the insets of the picture to the area between the panels.
function arrange(app) {
  const room = (selector) => document.querySelector(selector)?.getBoundingClientRect();
  const [bar, side, home] = [room(".bar"), room(".side"), room(".tree-home")];
  const narrow = NARROW.matches;
  const insets = {
    top: bar?.bottom ?? 0,
    left: narrow || !home?.width ? 0 : home.right,
    right: narrow ? 0 : innerWidth - (side?.left ?? innerWidth),
    bottom: narrow ? innerHeight - (side?.top ?? innerHeight) : 0,
  };
  for (const [name, value] of Object.entries(insets))
    document.documentElement.style.setProperty(`--inset-${name}`, `${value}px`);
  app.legend.measure();
  app.picture.stage.setInsets(insets);
}

function start() {
  const view = el("main", { class: "view", "aria-label": "Picture" });
  document.body.append(view);
  const app = makeApp(document.body, view);
  app.help = makeHelp();
  app.openDialog = makeOpenDialog(app);
  const { side, home } = makeSide(app, makeTree(app));
  document.body.prepend(makeBar(app), home);
  view.after(side);
  app.picture.stage.canvas.setAttribute("role", "application");
  app.picture.stage.canvas.setAttribute("aria-label", "3D picture; press ? for its keys");
  app.picture.stage.canvas.addEventListener("dblclick", () => app.view.fit());
  pageKeys(app);
  pictureKeys(app);
  watchTheme();
  addEventListener("resize", () => arrange(app));
  arrange(app);
  // Expose the app for tests and the console.
  globalThis.thenarLive = app;
}

try {
  start();
} catch (error) {
  document.body.append(
    el("p", { class: "broken", role: "alert" }, `The page cannot be shown: ${error.message}`),
  );
  throw error;
}
