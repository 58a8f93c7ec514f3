// What uPlot does not draw by itself: names beside points, and reference lines with their words.

import { clearPlace, freePlace, pointsAlong } from "./line_places.js";
import { seriesLooks } from "./palette.js";
import { themeColor } from "./theme.js";

const FONT_SIZE = 12; // [px]
const fontAt = (ratio) => `${FONT_SIZE * ratio}px system-ui, sans-serif`;

/// A point's own label, or the name of a series that is a single point.
const labelOf = (series, point) =>
  point.label ?? (series.x.length === 1 && series.style === "points" ? series.name : null);

/// Where points stand on the canvas; null for those without a value.
const pixelsOf = (plot, list) =>
  list.map(({ x, y }) =>
    y === null ? null : [plot.valToPos(x, "x", true), plot.valToPos(y, "y", true)],
  );

/// Reference lines and their words, clear of the curves.
function references(plot, lines, curves, sizeOfText, taken) {
  const { left, top, width, height } = plot.bbox;
  const drawn = { lines: [], texts: [] };
  for (const { axis = "y", value, label } of lines) {
    const at = Math.round(plot.valToPos(value, axis, true));
    drawn.lines.push(axis === "y" ? [left, at, left + width, at] : [at, top, at, top + height]);
    if (!label) continue;
    const place = clearPlace({ axis, at }, sizeOfText(label), plot.bbox, curves, taken);
    taken.push(place);
    drawn.texts.push({ text: label, place, color: "--muted" });
  }
  return drawn;
}

/// Names of points where there is room; the tooltip names the others.
function pointNames(plot, block, points, shown, sizeOfText, taken) {
  const looks = seriesLooks(block.series);
  const named = [];
  points.forEach((list, s) => {
    if (!shown[s]) return;
    const pixels = pixelsOf(plot, list);
    list.forEach((point, i) => {
      const text = labelOf(block.series[s], point);
      if (text && pixels[i]) named.push({ text, at: pixels[i], color: looks[s].color });
    });
  });
  return named.flatMap(({ text, at, color }) => {
    const place = freePlace(at, sizeOfText(text), plot.bbox, taken);
    if (!place) return [];
    taken.push(place);
    return [{ text, place, color }];
  });
}

/// { lines: [[x, y, x, y]], texts: [{ text, place, color }] } in pixels of the canvas.
export function marksOf(plot, block, points, shown) {
  const ratio = devicePixelRatio;
  plot.ctx.save();
  plot.ctx.font = fontAt(ratio);
  const sizeOfText = (text) => ({
    width: plot.ctx.measureText(text).width,
    height: 13 * ratio,
  });
  const lists = points.map((list, s) => (shown[s] ? pixelsOf(plot, list) : []));
  const half = 4 * ratio;
  const taken = lists
    .flat()
    .filter(Boolean)
    .map(([x, y]) => ({ left: x - half, right: x + half, top: y - half, bottom: y + half }));
  const curves = lists.flatMap((list, s) =>
    block.series[s].style === "points" ? list.filter(Boolean) : pointsAlong(list),
  );
  const words = [];
  const drawn = references(plot, block.reference_lines ?? [], curves, sizeOfText, words);
  taken.push(...words);
  drawn.texts.push(...pointNames(plot, block, points, shown, sizeOfText, taken));
  plot.ctx.restore();
  return drawn;
}

/// Text over a rim of the page's colour, readable across curves.
function halo(ctx, { text, place, color }, ratio) {
  const middle = (place.top + place.bottom) / 2;
  ctx.lineWidth = 4 * ratio;
  ctx.strokeStyle = themeColor("--page");
  ctx.strokeText(text, place.left, middle);
  ctx.fillStyle = themeColor(color);
  ctx.fillText(text, place.left, middle);
}

/// Draws the marks onto the canvas of a chart.
export function drawMarks(plot, { lines, texts }) {
  const { ctx } = plot;
  const ratio = devicePixelRatio;
  ctx.save();
  ctx.setLineDash([5 * ratio, 4 * ratio]);
  ctx.lineWidth = ratio;
  ctx.strokeStyle = themeColor("--muted");
  for (const [x1, y1, x2, y2] of lines) {
    ctx.beginPath();
    ctx.moveTo(x1, y1);
    ctx.lineTo(x2, y2);
    ctx.stroke();
  }
  ctx.setLineDash([]);
  ctx.font = fontAt(ratio);
  ctx.textAlign = "left";
  ctx.textBaseline = "middle";
  for (const text of texts) halo(ctx, text, ratio);
  ctx.restore();
}
