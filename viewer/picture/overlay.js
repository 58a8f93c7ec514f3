// What is written on the picture: labels at points of the scene, the scale bar, and the axis triad.

import { Vector3 } from "three";
import { niceStep } from "../numbers/ticks.js";
import { placeLabels } from "./label_places.js";
import { formatNumber } from "../numbers/format.js";

const FONT = "system-ui, sans-serif";
const TRIAD = [
  ["x", "#d55e00", new Vector3(1, 0, 0)],
  ["y", "#009e73", new Vector3(0, 1, 0)],
  ["z", "#0072b2", new Vector3(0, 0, 1)],
];

/// Text with a halo of the page's colour, readable over anything.
function halo(context, text, x, y, ink, page) {
  context.lineJoin = "round";
  context.lineWidth = 3.5;
  context.strokeStyle = page;
  context.strokeText(text, x, y);
  context.fillStyle = ink;
  context.fillText(text, x, y);
}

/// Canvas position in CSS pixels of a point of the scene.
function project(point, camera, width, height) {
  const p = point.clone().project(camera);
  return [((p.x + 1) / 2) * width, ((1 - p.y) / 2) * height];
}

/// Boxes that the triad and the scale bar stand in.
const corners = ({ width, height, compact }) => [
  { left: width - 110, right: width, top: height - 36, bottom: height },
  ...(compact ? [] : [{ left: 0, right: 84, top: height - 84, bottom: height }]),
];

/// Words at points of the scene, none over another; `covered` are boxes of the picture that
/// something else covers.
export function drawLabels(context, labels, camera, look, covered = []) {
  const { width, height, ink, page, muted } = look;
  context.font = `600 12px ${FONT}`;
  context.textBaseline = "middle";
  const wanted = labels.map(({ position, text }) => {
    const seen = position.clone().project(camera);
    const [x, y] = project(position, camera, width, height);
    return { x, y, depth: seen.z, text, width: context.measureText(text).width };
  });
  const placed = placeLabels(wanted, look, [...corners(look), ...covered]);
  context.strokeStyle = muted ?? ink;
  context.lineWidth = 1;
  for (const { label, place } of placed.filter((one) => one.place.far)) {
    context.beginPath();
    context.moveTo(label.x, label.y);
    context.lineTo(
      place.left > label.x ? place.left - 2 : place.right + 2,
      (place.top + place.bottom) / 2,
    );
    context.stroke();
  }
  for (const { label, place } of placed)
    halo(context, label.text, place.left, (place.top + place.bottom) / 2, ink, page);
}

/// A bar of round length, in the unit of the scene.
export function drawScaleBar(context, camera, unit, { width, height, ink, page }) {
  const pixelsPerUnit = (width * camera.zoom) / (camera.right - camera.left);
  const length = niceStep(50 / pixelsPerUnit);
  const end = width - 16;
  const y = height - 14;
  context.strokeStyle = ink;
  context.lineWidth = 2;
  context.beginPath();
  const start = end - length * pixelsPerUnit;
  context.moveTo(start, y - 4);
  context.lineTo(start, y);
  context.lineTo(end, y);
  context.lineTo(end, y - 4);
  context.stroke();
  context.font = `12px ${FONT}`;
  context.textAlign = "center";
  halo(context, `${formatNumber(length)} ${unit}`, (start + end) / 2, y - 10, ink, page);
  context.textAlign = "left";
}

/// " up" for the axis that points upwards in this scene, " down" for the one that points down.
function sense(axis, up) {
  const along = axis.dot(up);
  return along > 0.999 ? " up" : along < -0.999 ? " down" : "";
}

/// Directions of the axes as the camera sees them, in the lower left corner, and which of them is
/// up. @param axes  words for x, y and z, each may be empty
export function drawTriad(context, camera, { height, ink, page }, axes = []) {
  const origin = [axes.some(Boolean) ? 64 : 42, height - 40];
  const length = 24;
  const seen = TRIAD.map(([name, color, axis], i) => ({
    name: (axes[i] ? `${name} ${axes[i]}` : name) + sense(axis, camera.up),
    color,
    v: axis.clone().transformDirection(camera.matrixWorldInverse),
  }));
  context.font = `600 11px ${FONT}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const { name, color, v } of seen.sort((a, b) => a.v.z - b.v.z)) {
    context.strokeStyle = color;
    context.lineWidth = 2.5;
    context.beginPath();
    context.moveTo(...origin);
    context.lineTo(origin[0] + length * v.x, origin[1] - length * v.y);
    context.stroke();
    const away = length + 9;
    const half = context.measureText(name).width / 2 + 3;
    // Words stand beside what they name, and within the picture.
    const beside = Math.sign(v.x) * Math.max(0, half - 9) * Math.min(1, 2 * Math.abs(v.x));
    const x = Math.max(half, origin[0] + away * v.x + beside);
    halo(context, name, x, origin[1] - away * v.y, ink, page);
  }
  context.textAlign = "left";
}
