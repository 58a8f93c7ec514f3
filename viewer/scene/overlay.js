// What is written on the picture: labels at points of the scene, the scale bar, and the axis triad.

import { Vector3 } from "three";
import { niceStep } from "../numbers/ticks.js";
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

/// Moves a label down until it covers none that was written before; gives up after a few lines.
function freeRow(x, y, width, taken) {
  const hit = (row) =>
    taken.some((t) => Math.abs(t.y - row) < 13 && x < t.x + t.width && t.x < x + width);
  const row = [0, 13, -13, 26, -26].map((dy) => y + dy).find((candidate) => !hit(candidate));
  return row ?? y;
}

export function drawLabels(context, labels, camera, { width, height, ink, page }) {
  context.font = `600 12px ${FONT}`;
  context.textBaseline = "middle";
  const taken = [];
  for (const { position, text } of labels) {
    const [x, y] = project(position, camera, width, height);
    const wide = context.measureText(text).width;
    const left = Math.min(x + 6, width - wide - 4);
    const row = freeRow(left, y, wide, taken);
    taken.push({ x: left, y: row, width: wide });
    halo(context, text, left, row, ink, page);
  }
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

/// Directions of the axes as the camera sees them, in the lower left corner.
export function drawTriad(context, camera, { height, ink, page }) {
  const origin = [38, height - 38];
  const length = 24;
  const seen = TRIAD.map(([name, color, axis]) => ({
    name,
    color,
    v: axis.clone().transformDirection(camera.matrixWorldInverse),
  }));
  context.font = `600 11px ${FONT}`;
  context.textAlign = "center";
  for (const { name, color, v } of seen.sort((a, b) => a.v.z - b.v.z)) {
    context.strokeStyle = color;
    context.lineWidth = 2.5;
    context.beginPath();
    context.moveTo(...origin);
    context.lineTo(origin[0] + length * v.x, origin[1] - length * v.y);
    context.stroke();
    halo(context, name, origin[0] + (length + 9) * v.x, origin[1] - (length + 9) * v.y, ink, page);
  }
  context.textAlign = "left";
}
