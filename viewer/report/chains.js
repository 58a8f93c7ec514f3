// Whether chains agree: one quantity at a time, chosen by the reader, the worst ones first.

import { memoryPanel, rankPanel, thumbnail, tracePanel, withUnit } from "./chain_panels.js";
import { breakable, el } from "./dom.js";
import { figure } from "./figure.js";
import { fluid } from "./fluid.js";
import { legend } from "./legend.js";
import { formatNumber, isNumber } from "../numbers/format.js";
import { cssColor, dashOf } from "./palette.js";

const THUMBNAILS = 6;
const R_HAT = 1.01; // above which chains disagree. Source: Vehtari et al. 2021

export const disagrees = ({ r_hat }) => !isNumber(r_hat) || r_hat > R_HAT;

const rHat = ({ r_hat }) => (isNumber(r_hat) ? r_hat.toFixed(3) : "n/a");

function facts(quantity) {
  const ess = (value) => (isNumber(value) ? formatNumber(Math.round(value)) : "n/a");
  return el(
    "span",
    { class: `facts ${disagrees(quantity) ? "bad" : ""}` },
    `R-hat ${rHat(quantity)}, bulk ESS ${ess(quantity.bulk_ess)}, tail ESS ${ess(quantity.tail_ess)}`,
  );
}

function chooser(quantities, onChoice) {
  const select = el(
    "select",
    { "aria-label": "Quantity", onchange: () => onChoice(Number(select.value)) },
    ...quantities.map((q, i) =>
      el("option", { value: i }, `${disagrees(q) ? "\u26a0 " : ""}${withUnit(q)} (${rHat(q)})`),
    ),
  );
  const step = (by, text, label) =>
    el(
      "button",
      {
        type: "button",
        "aria-label": label,
        title: label,
        onclick: () =>
          onChoice((Number(select.value) + by + quantities.length) % quantities.length),
      },
      text,
    );
  const buttons = [step(-1, "\u2039", "Previous quantity"), step(1, "\u203a", "Next quantity")];
  return { select, buttons: quantities.length > 1 ? buttons : [] };
}

/// Small traces of the first quantities, as buttons.
function gallery(block, onChoice) {
  const shown = block.quantities.slice(0, THUMBNAILS);
  const buttons = shown.map((quantity, i) =>
    el(
      "button",
      { type: "button", class: "thumbnail", onclick: () => onChoice(i) },
      el("span", { class: "thumbnail-name" }, ...breakable(quantity.name)),
      el("span", { class: `facts ${disagrees(quantity) ? "bad" : ""}` }, `R-hat ${rHat(quantity)}`),
      thumbnail(block, quantity, 150, 46),
    ),
  );
  return { buttons, frame: el("div", { class: "gallery" }, ...buttons) };
}

export function drawChains(block) {
  const { quantities } = block;
  const shown = block.chains.map(() => true);
  let chosen = 0;
  const about = el("span", { "aria-live": "polite" });
  const frames = [tracePanel, rankPanel, memoryPanel].map((panel) =>
    fluid({ class: "chain-panel" }, (width) => [panel(block, quantities[chosen], shown, width)]),
  );
  const choose = (i) => {
    chosen = i;
    select.value = String(i);
    about.replaceChildren(facts(quantities[i]));
    small.buttons.forEach((button, k) => button.setAttribute("aria-pressed", String(k === i)));
    frames.forEach((frame) => frame.redraw());
  };
  const { select, buttons } = chooser(quantities, choose);
  const small = gallery(block, choose);
  choose(0);
  const [trace, ranks, memory] = frames;
  const worst =
    quantities.length > 1
      ? el("div", { class: "chain-panel" }, el("h3", {}, "Largest R-hat first"), small.frame)
      : null;
  return figure(
    "figure",
    block.caption,
    el("div", { class: "tools chooser" }, select, ...buttons, about),
    legend(
      block.chains.map((name, c) => ({ name, color: cssColor(c), dash: dashOf(c), mark: "line" })),
      (name, on) => {
        shown[block.chains.indexOf(name)] = on;
        frames.forEach((frame) => frame.redraw());
      },
    ),
    el("div", { class: "chain-panels" }, trace, ranks, memory, worst),
  );
}
