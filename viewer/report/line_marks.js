// What uPlot does not draw by itself: names beside points, and reference lines.

import { seriesColors } from "./palette.js";
import { themeColor } from "./theme.js";

const onCanvas = (plot, draw) => {
  plot.ctx.save();
  plot.ctx.textAlign = "left";
  plot.ctx.font = `${12 * devicePixelRatio}px system-ui, sans-serif`;
  draw(plot.ctx, plot.bbox, devicePixelRatio);
  plot.ctx.restore();
};

/// Text over a rim of the page's colour, readable across curves.
function halo(ctx, text, x, y, ratio) {
  ctx.save();
  ctx.setLineDash([]);
  ctx.lineWidth = 4 * ratio;
  ctx.strokeStyle = themeColor("--page");
  ctx.strokeText(text, x, y);
  ctx.restore();
  ctx.fillText(text, x, y);
}

function referenceLine(ctx, box, plot, { axis = "y", label, value }, ratio) {
  const at = Math.round(plot.valToPos(value, axis, true));
  ctx.beginPath();
  if (axis === "y") {
    ctx.moveTo(box.left, at);
    ctx.lineTo(box.left + box.width, at);
  } else {
    ctx.moveTo(at, box.top);
    ctx.lineTo(at, box.top + box.height);
  }
  ctx.stroke();
  const [x, y] =
    axis === "y" ? [box.left + 6 * ratio, at - 6 * ratio] : [at + 5 * ratio, box.top + 12 * ratio];
  halo(ctx, label ?? "", x, y, ratio);
}

/// Dashed lines at given values of x or y.
export function drawReferences(plot, lines) {
  onCanvas(plot, (ctx, box, ratio) => {
    ctx.setLineDash([5 * ratio, 4 * ratio]);
    ctx.lineWidth = ratio;
    ctx.strokeStyle = ctx.fillStyle = themeColor("--muted");
    for (const line of lines) referenceLine(ctx, box, plot, line, ratio);
  });
}

/// A point's own label, or the name of a series that is a single point.
const labelOf = (series, point) =>
  point.label ?? (series.x.length === 1 && series.style === "points" ? series.name : null);

const overlaps = (a, b) =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/// The first free place beside a point: right, left, above, below; none if all are taken.
function freePlace(x, y, width, height, box, taken) {
  const gap = 0.7 * height;
  const places = [
    [x + gap, y - height / 2],
    [x - gap - width, y - height / 2],
    [x - width / 2, y - gap - height],
    [x - width / 2, y + gap],
  ];
  return places
    .map(([left, top]) => ({ left, top, right: left + width, bottom: top + height }))
    .find(
      (p) =>
        p.left >= box.left &&
        p.right <= box.left + box.width &&
        p.top >= box.top &&
        !taken.some((other) => overlaps(p, other)),
    );
}

/// The marks themselves, which no name may cover.
function marksOf(plot, points, shown, half) {
  return points
    .flatMap((list, s) => (shown[s] ? list : []))
    .filter(({ y }) => y !== null)
    .map((point) => {
      const x = plot.valToPos(point.x, "x", true);
      const y = plot.valToPos(point.y, "y", true);
      return { left: x - half, right: x + half, top: y - half, bottom: y + half };
    });
}

/// Names points where there is room; the tooltip names the others.
export function labelPoints(plot, block, points, shown) {
  const named = points
    .flatMap((list, s) =>
      shown[s] ? list.map((p) => ({ ...p, s, label: labelOf(block.series[s], p) })) : [],
    )
    .filter(({ label, y }) => label && y !== null);
  if (!named.length) return;
  const colors = seriesColors(block.series);
  onCanvas(plot, (ctx, box, ratio) => {
    const height = 13 * ratio;
    const taken = marksOf(plot, points, shown, 4 * ratio);
    ctx.textBaseline = "middle";
    for (const { x, y, s, label } of named) {
      const place = freePlace(
        plot.valToPos(x, "x", true),
        plot.valToPos(y, "y", true),
        ctx.measureText(label).width,
        height,
        box,
        taken,
      );
      if (!place) continue;
      taken.push(place);
      ctx.fillStyle = themeColor(colors[s]);
      halo(ctx, label, place.left, place.top + height / 2, ratio);
    }
  });
}
