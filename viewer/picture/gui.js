// The panel that switches layers and surfaces.

import GUI from "lil-gui";

const NARROW = 700; // [px] below this the panel starts folded
const UNFOLDING = 400; // until a panel that was opened or closed is still [ms]

function addLayer(gui, { group, name, color }, draw) {
  const control = gui.add(group, "visible").name(name).onChange(draw);
  control.domElement.style.setProperty("--layer", color);
  control.domElement.classList.add("layer");
}

/// Materials of all hulls.
function hullMaterials(layers) {
  const found = [];
  for (const { group } of layers)
    group.traverse((object) => object.userData.hull && found.push(object.material));
  return found;
}

function addOpacity(gui, layers, draw) {
  const materials = hullMaterials(layers);
  if (!materials.length) return;
  const state = { "surface opacity": materials[0].opacity };
  gui.add(state, "surface opacity", 0, 1, 0.05).onChange((opacity) => {
    for (const material of materials) material.opacity = opacity;
    draw();
  });
}

/// `view` has layers, grid, show (labels), and the functions draw and fit. Layers that are frames of a
/// motion are left to its player.
export function addPanel(container, view) {
  const gui = new GUI({ container, title: "Layers", width: 190 });
  for (const layer of view.layers) if (layer.time === null) addLayer(gui, layer, view.draw);
  addOpacity(gui, view.layers, view.draw);
  if (view.layers.some((layer) => layer.labels.length))
    gui.add(view.show, "labels").onChange(view.draw);
  gui.add(view.grid, "visible").name("grid").onChange(view.draw);
  gui.add(view, "fit").name("fit view");
  if (container.clientWidth < NARROW) gui.close();
  gui.onOpenClose(() => setTimeout(view.draw, UNFOLDING));
  return gui;
}
