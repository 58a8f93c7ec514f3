// Tendons and bands as lines: coloured by tension, dashed where slack, thin and grey where unknown.

import { Color, Group } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { niceStep } from "../../numbers/ticks.js";
import { colorOf } from "../../picture/color_scale.js";

const LEAST_SCALE = 1; // end of the scale of tensions that are all smaller [N]
const SLACK = new Color("#8a8f99");
const KINDS = {
  taut: { linewidth: 3.2 },
  slack: { linewidth: 2.2, dashed: true, dashSize: 0.003, gapSize: 0.002 }, // [px], [m]
  unknown: { linewidth: 1.3 },
};

/// "unknown" without a number, "slack" at zero.
export const kindOf = (tension) =>
  Number.isNaN(tension) ? "unknown" : tension > 0 ? "taut" : "slack";

/// A round end of the scale for the largest of these tensions [N].
export function scaleEnd(tensions) {
  const most = tensions.reduce((a, b) => (b > a ? b : a), 0);
  return most > LEAST_SCALE ? niceStep(most) : LEAST_SCALE;
}

/// One object for all segments of a kind, with room for `most` of them.
function segments(kind, most) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(new Float32Array(6 * most));
  geometry.setColors(new Float32Array(6 * most));
  const object = new LineSegments2(
    geometry,
    new LineMaterial({ ...KINDS[kind], vertexColors: true }),
  );
  object.computeLineDistances();
  object.frustumCulled = false;
  object.renderOrder = 1;
  object.raycast = () => {};
  return object;
}

function write(object, at, from, to, color, distance) {
  const { instanceStart, instanceColorStart, instanceDistanceStart } = object.geometry.attributes;
  const places = instanceStart.data.array;
  places.set(from, 6 * at);
  places.set(to, 6 * at + 3);
  const colors = instanceColorStart.data.array;
  color.toArray(colors, 6 * at);
  color.toArray(colors, 6 * at + 3);
  const distances = instanceDistanceStart.data.array;
  const length = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  distances[2 * at] = distance;
  distances[2 * at + 1] = distance + length;
  return distance + length;
}

function finish(object, count) {
  const { instanceStart, instanceColorStart, instanceDistanceStart } = object.geometry.attributes;
  object.geometry.instanceCount = count;
  object.visible = count > 0;
  for (const { data } of [instanceStart, instanceColorStart, instanceDistanceStart])
    data.needsUpdate = true;
}

/// Lines under `parent`: show(scene), pose(frame) which returns the end of the colour scale [N] or null
/// where no tension is known, visible(on), plain(): one of them, by whose program most are drawn.
export function makeLines(parent) {
  const group = new Group();
  parent.add(group);
  let lines = [];
  let objects = {};

  const show = (scene) => {
    lines = scene.lines;
    for (const object of Object.values(objects)) {
      object.geometry.dispose();
      object.material.dispose();
    }
    group.clear();
    const most = lines.reduce((sum, { points }) => sum + Math.max(0, points - 1), 0);
    objects = most
      ? Object.fromEntries(Object.keys(KINDS).map((kind) => [kind, segments(kind, most)]))
      : {};
    for (const object of Object.values(objects)) group.add(object);
  };

  const pose = ({ tensions, points }) => {
    if (!Object.keys(objects).length) return null;
    const end = scaleEnd(tensions);
    const counts = { taut: 0, slack: 0, unknown: 0 };
    const color = new Color();
    let first = 0;
    lines.forEach((line, i) => {
      const kind = kindOf(tensions[i]);
      if (kind === "taut") color.set(colorOf(tensions[i], { low: 0, high: end }));
      else color.copy(SLACK);
      let distance = 0;
      for (let k = first; k < first + line.points - 1; ++k) {
        const [from, to] = [
          points.subarray(3 * k, 3 * k + 3),
          points.subarray(3 * k + 3, 3 * k + 6),
        ];
        distance = write(objects[kind], counts[kind]++, from, to, color, distance);
      }
      first += line.points;
    });
    for (const [kind, count] of Object.entries(counts)) finish(objects[kind], count);
    return counts.taut + counts.slack > 0 ? end : null;
  };

  const sharpen = (ratio) =>
    Object.entries(objects).forEach(([kind, { material }]) => {
      material.linewidth = KINDS[kind].linewidth * ratio;
    });
  return { show, pose, sharpen, visible: (on) => (group.visible = on), plain: () => objects.unknown };
}
