// A floor grid of round spacing under the scene.

import { GridHelper, Vector3 } from "three";
import { niceStep } from "../numbers/ticks.js";

const Y = new Vector3(0, 1, 0);

/// Grid across `up`, at the lowest point of the box; returns it with its spacing in scene units.
export function buildGrid(box, size, up) {
  const step = niceStep(size / 12);
  const cells = 2 * Math.ceil((0.6 * size) / step);
  const grid = new GridHelper(cells * step, cells, "#888888", "#888888");
  grid.material.transparent = true;
  grid.material.opacity = 0.28;
  grid.quaternion.setFromUnitVectors(Y, up);
  const center = box.isEmpty() ? new Vector3() : box.getCenter(new Vector3());
  const half = box.isEmpty()
    ? 0
    : box
        .getSize(new Vector3())
        .multiply(new Vector3(...up.toArray().map(Math.abs)))
        .length() / 2;
  grid.position.copy(center).addScaledVector(up, -half);
  return { grid, step };
}
