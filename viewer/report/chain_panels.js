// One quantity of several chains: the draws in order, the counts of their ranks, and how long each
// chain remembers.

import { svg } from "./dom.js";
import { panelAxes, panelBox, panelSvg, pathThrough } from "./panel.js";
import { nearestOf } from "./line_reading.js";
import { formatNumber, isNumber } from "../numbers/format.js";
import { cssColor, dashOf } from "./palette.js";
import { extent, linear } from "../numbers/ticks.js";
import { describe, hideTooltip, readingRow, showTooltip } from "./tooltip.js";

const HEIGHT = 230;
const MARGIN = { left: 62, right: 10, top: 10, bottom: 40 };
const STRIP = 44; // of the ranks of one chain [px]

/// "tilt [deg]".
export const withUnit = ({ name, unit }) => (unit ? `${name} [${unit}]` : name);

/// Tells about all chains that are shown, at the place nearest to the pointer. `lists` are of
/// { x, y }, one a chain, all with the same x; `head` says where, `value` what.
function followPlace(node, box, block, lists, shown, head, value) {
  const tell = (event) => {
    const xs = (lists[0] ?? []).map(({ x }) => x);
    const along = linear([box.left, box.right], box.xs);
    const x = along(event.clientX - node.getBoundingClientRect().left);
    const i = xs.indexOf(nearestOf(xs, x));
    const rows = lists.map((list, c) =>
      shown[c] && list[i]
        ? readingRow({ color: cssColor(c), dash: dashOf(c) }, block.chains[c], value(list[i].y))
        : null,
    );
    const told = rows.filter(Boolean);
    if (told.length) showTooltip(event, [head(xs[i]), ...told]);
    else hideTooltip();
  };
  node.addEventListener("pointermove", tell);
  node.addEventListener("pointerleave", hideTooltip);
  return node;
}

function curves(box, lists, shown) {
  return lists.map((list, c) =>
    shown[c]
      ? svg("path", {
          class: "trace",
          style: `color: ${cssColor(c)}`,
          "stroke-dasharray": dashOf(c)?.join(" "),
          d: pathThrough(list.map((p) => [box.x(p.x), box.y(p.y ?? NaN)])),
        })
      : null,
  );
}

const pointsOf = (lists, places) =>
  lists.map((list) => list.map((y, i) => ({ x: places[i], y: y ?? NaN })));

/// Draws in order, warm-up left out.
export function tracePanel(block, quantity, shown, width) {
  const lists = pointsOf(quantity.traces, block.draws);
  const ys = extent(
    lists.flatMap((list) => list.map((p) => p.y)),
    0.05,
  );
  const box = panelBox(width, HEIGHT, MARGIN, [1, block.draws.at(-1)], ys);
  const every = block.draws.length > 1 ? block.draws[1] - block.draws[0] : 1;
  const axes = panelAxes(box, {
    x_label: `draw after warm-up${every > 1 ? `, one in ${every} shown` : ""}`,
    y_label: withUnit({ name: "value", unit: quantity.unit }),
  });
  const node = panelSvg(
    box,
    `Trace of ${withUnit(quantity)}, ${lists.length} chains`,
    ...axes,
    ...curves(box, lists, shown),
  );
  const value = (y) => `${formatNumber(y)} ${quantity.unit ?? ""}`;
  return followPlace(node, box, block, lists, shown, (x) => `draw ${x}`, value);
}

/// Correlation of each chain with itself some draws later.
export function memoryPanel(block, quantity, shown, width) {
  const step = quantity.lag_step;
  const lists = quantity.autocorrelation.map((list) =>
    list.map((y, i) => ({ x: i * step, y: y ?? NaN })),
  );
  const low = Math.min(-0.2, ...lists.flat().map((p) => (isNumber(p.y) ? p.y : 0)));
  const last = Math.max(1, ...lists.map((list) => (list.length - 1) * step));
  const box = panelBox(width, HEIGHT - 30, MARGIN, [0, last], [low, 1]);
  const node = panelSvg(
    box,
    `Autocorrelation of ${withUnit(quantity)}`,
    ...panelAxes(box, { x_label: "lag [draws]", y_label: "autocorrelation" }),
    svg("line", { class: "zero", x1: box.left, x2: box.right, y1: box.y(0), y2: box.y(0) }),
    ...curves(box, lists, shown),
  );
  return followPlace(
    node,
    box,
    block,
    lists,
    shown,
    (x) => `lag ${x}`,
    (y) => formatNumber(y),
  );
}

function rankBar(block, { counts, mean, low, high }, c, i, { x, y, bottom }) {
  const value = counts[c][i];
  const share = 100 / counts[c].length;
  const bar = svg("rect", {
    class: value < low || value > high ? "rank out" : "rank",
    x: x(i) + 0.5,
    width: Math.max(0.5, x(i + 1) - x(i) - 1),
    y: y(value),
    height: Math.max(0, bottom - y(value)),
  });
  return describe(bar, [
    `${block.chains[c]}, ranks ${formatNumber(i * share)} to ${formatNumber((i + 1) * share)} %`,
    `${formatNumber(value)} draws, expected ${formatNumber(mean)}`,
    `95 % of counts lie within ${formatNumber(low)} to ${formatNumber(high)}`,
  ]);
}

/// How many draws of each chain fall into each part of all ranks: level if the chains agree.
export function rankPanel(block, quantity, shown, width) {
  const { ranks } = quantity;
  const chains = ranks.counts.map((_, c) => c).filter((c) => shown[c]);
  const strip = Math.max(STRIP, (HEIGHT - 50) / Math.max(1, chains.length));
  const height = MARGIN.top + strip * chains.length + MARGIN.bottom;
  const bins = ranks.counts[0]?.length ?? 1;
  const top = Math.max(ranks.high, ...ranks.counts.flat()) * 1.05 || 1;
  const whole = panelBox(width, height, MARGIN, [0, 100], [0, 1]);
  const rows = chains.flatMap((c, k) => {
    const bottom = MARGIN.top + (k + 1) * strip;
    const margin = { ...MARGIN, top: bottom - strip + 4, bottom: height - bottom };
    const box = panelBox(width, height, margin, [0, bins], [0, top]);
    const level = (v) => ({ x1: box.left, x2: box.right, y1: box.y(v), y2: box.y(v) });
    return [
      svg("rect", {
        class: "rank-band",
        x: box.left,
        width: box.right - box.left,
        y: box.y(ranks.high),
        height: box.y(ranks.low) - box.y(ranks.high),
      }),
      svg(
        "g",
        { style: `color: ${cssColor(c)}` },
        ...ranks.counts[c].map((_, i) => rankBar(block, ranks, c, i, box)),
      ),
      svg("line", { class: "reference", ...level(ranks.mean) }),
      svg("line", { class: "zero", ...level(0) }),
      svg("text", { x: box.left - 5, y: bottom - 4, "text-anchor": "end" }, block.chains[c]),
    ];
  });
  const axis = [0, 50, 100].map((v) =>
    svg(
      "text",
      { x: whole.x(v), y: whole.bottom + 14, "text-anchor": v === 100 ? "end" : "middle" },
      formatNumber(v),
    ),
  );
  return panelSvg(
    whole,
    `Rank histograms of ${withUnit(quantity)}`,
    ...rows,
    ...axis,
    svg(
      "text",
      {
        class: "label",
        x: (whole.left + whole.right) / 2,
        y: whole.bottom + 30,
        "text-anchor": "middle",
      },
      "rank among all draws [%]",
    ),
  );
}

/// The trace alone, small.
export function thumbnail(block, quantity, width, height) {
  const lists = pointsOf(quantity.traces, block.draws);
  const ys = extent(
    lists.flatMap((list) => list.map((p) => p.y)),
    0.05,
  );
  const margin = { left: 1, right: 1, top: 2, bottom: 2 };
  const box = panelBox(width, height, margin, [1, block.draws.at(-1)], ys);
  const node = panelSvg(
    box,
    `Trace of ${quantity.name}`,
    ...curves(
      box,
      lists,
      lists.map(() => true),
    ),
  );
  node.setAttribute("preserveAspectRatio", "none");
  return node;
}
