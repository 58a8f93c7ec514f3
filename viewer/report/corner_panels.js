// The triangle of a corner plot, as SVG: densities on the diagonal, pairs below it.

import { svg } from "./dom.js";
import { pathThrough } from "./panel.js";
import { formatNumber, isNumber } from "../numbers/format.js";
import { correlation, density, regions, spreadOf } from "../numbers/density.js";
import { linear, ticks } from "../numbers/ticks.js";
import { describe, hideTooltip, showTooltip } from "./tooltip.js";

const GAP = 7;
const TOP = 18;
const BOTTOM = 74; // room for ticks and names [px]
const SHARES = [0.9, 0.5];

/// What is seen of a quantity: all its draws, and of its prior as much as leaves them readable.
export function rangeOf({ draws, prior = [], truth }) {
  const low = Math.min(...draws);
  const high = Math.max(...draws);
  const width = high - low || Math.abs(low) || 1;
  const sorted = [...prior].sort((a, b) => a - b);
  const at = (share) => sorted[Math.floor(share * (sorted.length - 1))];
  const ends = [low - 0.06 * width, high + 0.06 * width];
  if (sorted.length) {
    ends[0] = Math.min(ends[0], Math.max(at(0.05), low - 0.5 * width));
    ends[1] = Math.max(ends[1], Math.min(at(0.95), high + 0.5 * width));
  }
  if (isNumber(truth)) {
    ends[0] = Math.min(ends[0], Math.max(truth - 0.05 * width, low - 2 * width));
    ends[1] = Math.max(ends[1], Math.min(truth + 0.05 * width, high + 2 * width));
  }
  return ends;
}

/// A name in lines of at most `width` pixels, broken after "/" and ": " where it can be.
export function brokenName(text, width) {
  const most = Math.max(6, Math.floor(width / 6.2));
  const lines = [];
  for (const part of text.split(/(?<=[/\s])/)) {
    const last = lines.at(-1);
    if (last !== undefined && (last + part).trimEnd().length <= most)
      lines[lines.length - 1] += part;
    else lines.push(part);
  }
  return lines.map((line) => line.trim());
}

const nameOf = ({ name, unit }) => (unit ? `${name} [${unit}]` : name);

function lines(text, width, attributes, lineHeight) {
  const broken = brokenName(text, width);
  const kept = broken.length > 3 ? [...broken.slice(0, 2), `${broken[2]}\u2026`] : broken;
  return svg(
    "text",
    { class: "name", "text-anchor": "middle", ...attributes },
    ...kept.map((line, i) => svg("tspan", { x: 0, dy: i === 0 ? 0 : lineHeight }, line)),
  );
}

const truthLine = (class_name, attributes) => svg("line", { class: class_name, ...attributes });

function diagonal(quantity, box) {
  const own = density(quantity.draws);
  const before = quantity.prior ? density(quantity.prior) : { x: [], y: [] };
  const top = Math.max(...own.y, 0) * 1.08 || 1;
  const y = linear([0, top], [box.bottom, box.top]);
  const points = ({ x, y: heights }) => x.map((v, i) => [box.x(v), y(heights[i])]);
  const outline = points(own);
  const closed = outline.length
    ? `${pathThrough(outline)}L${outline.at(-1)[0].toFixed(1)} ${box.bottom}L${outline[0][0].toFixed(1)} ${box.bottom}Z`
    : "";
  const mean = quantity.draws.reduce((a, b) => a + b, 0) / quantity.draws.length;
  const node = svg(
    "g",
    { role: "img", "clip-path": `url(#${box.clip})` },
    svg("rect", { class: "catch", x: box.left, y: box.top, width: box.side, height: box.side }),
    svg("path", { class: "prior-line", d: pathThrough(points(before)) }),
    svg("path", { class: "density", d: closed }),
    isNumber(quantity.truth)
      ? truthLine("truth", {
          x1: box.x(quantity.truth),
          x2: box.x(quantity.truth),
          y1: box.top,
          y2: box.bottom,
        })
      : null,
  );
  return describe(node, [
    nameOf(quantity),
    `mean ${formatNumber(mean)}, sd ${formatNumber(spreadOf(quantity.draws))}`,
    ...(isNumber(quantity.truth) ? [`truth ${formatNumber(quantity.truth)}`] : []),
  ]);
}

const ringPath = (rings, box) =>
  rings.map((ring) => `${pathThrough(ring.map(([x, y]) => [box.x(x), box.y(y)]))}Z`).join("");

function pair(across, up, box) {
  const { rings, outside } = regions(across.draws, up.draws, SHARES);
  const r = correlation(across.draws, up.draws);
  const same = across.prior && up.prior && across.prior.length === up.prior.length;
  const before = same ? regions(across.prior, up.prior, [0.9]).rings[0] : [];
  const dots = outside.map(([x, y]) => `M${box.x(x).toFixed(1)} ${box.y(y).toFixed(1)}h0`).join("");
  const vertical = {
    x1: box.x(across.truth),
    x2: box.x(across.truth),
    y1: box.top,
    y2: box.bottom,
  };
  const level = { y1: box.y(up.truth), y2: box.y(up.truth), x1: box.left, x2: box.right };
  const node = svg(
    "g",
    {
      role: "img",
      "clip-path": `url(#${box.clip})`,
      "aria-label": `${up.name} over ${across.name}, correlation ${r.toFixed(2)}`,
    },
    svg("rect", { class: "catch", x: box.left, y: box.top, width: box.side, height: box.side }),
    svg("path", { class: "prior-line", d: ringPath(before, box) }),
    svg("path", { class: "outside", d: dots }),
    ...rings.map((of_share) => svg("path", { class: "region", d: ringPath(of_share, box) })),
    isNumber(across.truth) ? truthLine("truth", vertical) : null,
    isNumber(up.truth) ? truthLine("truth", level) : null,
  );
  node.addEventListener("pointermove", (event) => {
    const frame = node.ownerSVGElement.getBoundingClientRect();
    const at = [event.clientX - frame.left, event.clientY - frame.top];
    showTooltip(event, [
      `${up.name} over ${across.name}`,
      `correlation ${r.toFixed(2)}`,
      `here ${formatNumber(Number(box.valueX(at[0]).toPrecision(3)))} ${across.unit ?? ""}, ${formatNumber(Number(box.valueY(at[1]).toPrecision(3)))} ${up.unit ?? ""}`,
    ]);
  });
  node.addEventListener("pointerleave", hideTooltip);
  return node;
}

let clips = 0;

function boxOf(i, j, side, left, ranges) {
  const x0 = left + i * side + GAP;
  const y0 = TOP + j * side;
  const inner = side - GAP;
  const xs = ranges[i];
  const ys = ranges[j];
  return {
    left: x0,
    right: x0 + inner,
    top: y0,
    bottom: y0 + inner,
    side: inner,
    clip: `corner-clip-${++clips}`,
    x: linear(xs, [x0, x0 + inner]),
    y: linear(ys, [y0 + inner, y0]),
    valueX: linear([x0, x0 + inner], xs),
    valueY: linear([y0 + inner, y0], ys),
  };
}

function frame(box, i, j, last, range) {
  const count = box.side < 100 ? 2 : 3;
  const rect = { x: box.left, y: box.top, width: box.side, height: box.side };
  const parts = [
    svg("clipPath", { id: box.clip }, svg("rect", rect)),
    svg("rect", { class: "panel-frame", ...rect }),
  ];
  const below = ticks(...range.across, count).flatMap((v) => [
    svg("line", { class: "grid", x1: box.x(v), x2: box.x(v), y1: box.top, y2: box.bottom }),
    j === last
      ? svg("text", { x: box.x(v), y: box.bottom + 14, "text-anchor": "middle" }, formatNumber(v))
      : null,
  ]);
  const beside =
    i === j
      ? []
      : ticks(...range.up, count).flatMap((v) => [
          svg("line", { class: "grid", x1: box.left, x2: box.right, y1: box.y(v), y2: box.y(v) }),
          i === 0
            ? svg(
                "text",
                { x: box.left - 4, y: box.y(v) + 4, "text-anchor": "end" },
                formatNumber(v),
              )
            : null,
        ]);
  return [...parts, ...below, ...beside];
}

/// The whole triangle; `side` of one panel and room at the left [px].
export function cornerSvg(quantities, side, left) {
  const ranges = quantities.map(rangeOf);
  const last = quantities.length - 1;
  const panels = [];
  quantities.forEach((up, j) => {
    for (let i = 0; i <= j; ++i) {
      const box = boxOf(i, j, side, left, ranges);
      panels.push(
        ...frame(box, i, j, last, { across: ranges[i], up: ranges[j] }),
        i === j ? diagonal(up, box) : pair(quantities[i], up, box),
      );
    }
    const middle = TOP + (j + 0.5) * side - GAP / 2;
    const across = left + (j + 0.5) * side + GAP / 2;
    panels.push(
      j > 0
        ? lines(nameOf(up), side, { transform: `translate(14 ${middle}) rotate(-90)` }, 13)
        : null,
      lines(
        nameOf(up),
        side,
        { transform: `translate(${across} ${TOP + quantities.length * side + 26})` },
        13,
      ),
    );
  });
  const width = left + quantities.length * side + 4;
  const height = TOP + quantities.length * side + BOTTOM;
  return svg(
    "svg",
    {
      class: "plot corner-plot",
      width,
      height,
      viewBox: `0 0 ${width} ${height}`,
      role: "group",
      "aria-label": `Corner plot of ${quantities.map(({ name }) => name).join(", ")}`,
    },
    ...panels,
  );
}
