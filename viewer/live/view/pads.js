// Points of pressed pads: blue where they stick, orange where they slip, larger under more pressure.

import { Color, InstancedMesh, Matrix4, MeshBasicMaterial, SphereGeometry, Vector3 } from "three";

const STICKS = new Color("#0072b2");
const SLIPS = new Color("#e69f00");
const RADIUS = 6e-4; // at the largest pressure [m]

/// Points under `parent`: show(points) with point [m], pressure and sticks; clear() takes them away.
export function makePads(parent, draw) {
  let shown = null;
  const clear = () => {
    if (!shown) return;
    shown.removeFromParent();
    shown.geometry.dispose();
    shown.material.dispose();
    shown.dispose();
    shown = null;
  };
  const show = (points) => {
    clear();
    if (!points.length) return;
    const most = points.reduce((a, { pressure }) => Math.max(a, pressure), 0) || 1;
    const look = { depthTest: false, transparent: true };
    const material = new MeshBasicMaterial(look);
    shown = new InstancedMesh(new SphereGeometry(1, 8, 6), material, points.length);
    points.forEach(({ point, pressure, sticks }, i) => {
      const radius = RADIUS * (0.25 + 0.75 * Math.sqrt(Math.max(0, pressure) / most));
      const size = new Vector3(radius, radius, radius);
      shown.setMatrixAt(i, new Matrix4().makeTranslation(...point).scale(size));
      shown.setColorAt(i, sticks ? STICKS : SLIPS);
    });
    shown.frustumCulled = false;
    shown.raycast = () => {};
    shown.renderOrder = 7;
    parent.add(shown);
    draw();
  };
  return { show, clear };
}
