// Controls of panels: rows with a slider and a number, buttons, choices, tabs.

import { el } from "../../report/dom.js";
import { clamped, told, typed } from "../link/quantities.js";

let names = 0;
export const freshId = (word) => `${word}-${++names}`;

export const button = (words, onclick, more = {}) =>
  el("button", { type: "button", onclick, ...more }, words);

/// Button for slow actions; disabled until the action is done.
export function slowButton(words, work, more = {}) {
  const made = button(
    words,
    async () => {
      if (made.disabled) return;
      made.disabled = true;
      try {
        await work();
      } finally {
        made.disabled = false;
      }
    },
    more,
  );
  return made;
}

/// A button that shows the world again, while something else is shown.
export function backToWorld(app) {
  const back = slowButton("Back to the world", () => app.ask("session.mode", { mode: "world" }));
  const show = () => (back.hidden = (app.store.scene?.mode ?? "world") === "world");
  app.store.on(["scene"], show);
  show();
  return back;
}

/// A row that opens a file of the server's folder by its name; `open(file)` hears of it.
export function fileRow(label, open) {
  const id = freshId("file");
  const input = el("input", { id, type: "text", autocomplete: "off", placeholder: "file" });
  const take = () => input.value.trim() && open(input.value.trim());
  input.addEventListener("keydown", ({ key }) => key === "Enter" && take());
  return el(
    "div",
    { class: "choice file-row" },
    el("label", { for: id }, label),
    input,
    slowButton("Open", take, { "aria-label": `Open ${label.toLowerCase()}` }),
  );
}

/// A titled part of a panel.
export const part = (title, ...content) =>
  el("section", { class: "part", "aria-label": title }, el("h3", {}, title), ...content);

/// The options of a choice: those of one `group` that follow each other stand under its name.
function optionsOf(all) {
  const out = [];
  for (const { value, text, group } of all) {
    const option = el("option", { value }, text);
    if (!group) out.push(option);
    else if (out.at(-1)?.label === group) out.at(-1).append(option);
    else out.push(el("optgroup", { label: group }, option));
  }
  return out;
}

/// A choice; `options` are texts or { value, text, group }. `change(value)` hears of it; set(options, value).
export function choice(label, change) {
  const id = freshId("choice");
  const select = el("select", { id, onchange: () => change(select.value) });
  const row = el("div", { class: "choice" }, el("label", { for: id }, label), select);
  row.set = (options, value) => {
    const all = options.map((one) => (typeof one === "string" ? { value: one, text: one } : one));
    const key = JSON.stringify(all);
    if (select.dataset.key !== key) {
      select.dataset.key = key;
      select.replaceChildren(...optionsOf(all));
    }
    if (value !== undefined && value !== null) select.value = value;
  };
  row.value = () => select.value;
  row.select = select;
  return row;
}

/// A box to tick; `change(on)` hears of it.
export function tick(label, on, change) {
  const box = el("input", { type: "checkbox", onchange: () => change(box.checked) });
  box.checked = on;
  const row = el("label", { class: "tick" }, box, label);
  row.box = box;
  return row;
}

const KEYS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 };

/// Where a key takes a value: arrows by a step (with Shift a tenth), pages by a big one, Home and End to
/// the limits; null for other keys.
export function keyed(event, value, { lower, upper }, quantity) {
  const { step, big, scale } = quantity;
  if (event.ctrlKey || event.altKey || event.metaKey) return null;
  if (event.key === "Home") return lower;
  if (event.key === "End") return upper;
  if (event.key in KEYS)
    return clamped(
      value + KEYS[event.key] * step * scale * (event.shiftKey ? 0.1 : 1),
      lower,
      upper,
    );
  if (event.key === "PageUp") return clamped(value + big * scale, lower, upper);
  if (event.key === "PageDown") return clamped(value - big * scale, lower, upper);
  return null;
}

/// A row { name, title, lower, upper, quantity, note, off } whose slider and number ask `change(value)` for
/// a value in SI. set(value) shows what the server says, unless a hand is on it; tell(on) marks it.
export function sliderRow({ name, title, lower, upper, quantity, note, off }, change) {
  const { scale, unit, digits } = quantity;
  let value = clamped(0, lower, upper);
  let held = false;
  const limits = `${told(lower, quantity)} to ${told(upper, quantity)}`;
  const slider = el("input", {
    ...{ type: "range", min: lower / scale, max: upper / scale, step: "any", disabled: off },
    ...{ "aria-label": `${name} ${unit}`.trim(), title: limits },
  });
  const number = el("input", {
    ...{ type: "text", inputmode: "decimal", class: "value", disabled: off },
    ...{ "aria-label": `${name}, typed ${unit}`.trim(), title: limits, autocomplete: "off" },
  });
  const show = () => {
    slider.value = value / scale;
    slider.setAttribute("aria-valuetext", told(value, quantity));
    if (document.activeElement !== number) number.value = (value / scale).toFixed(digits);
    const full = upper > lower ? (value - lower) / (upper - lower) : 0;
    slider.style.setProperty("--full", `${100 * full}%`);
  };
  const ask = (next) => {
    value = clamped(next, lower, upper);
    show();
    change(value);
  };
  slider.addEventListener("input", () => ask(Number(slider.value) * scale));
  slider.addEventListener("pointerdown", () => (held = true));
  for (const kind of ["pointerup", "pointercancel", "blur", "change"])
    slider.addEventListener(kind, () => (held = false));
  slider.addEventListener("keydown", (event) => {
    const next = keyed(event, value, { lower, upper }, quantity);
    if (next === null) return;
    event.preventDefault();
    ask(next);
  });
  const enter = () => {
    const next = typed(number.value, quantity);
    if (next !== null && Math.abs(next - value) > 0.5 * scale * 10 ** -digits) ask(next);
    // Show the current value, which may be at a limit.
    number.value = (value / scale).toFixed(digits);
  };
  number.addEventListener("change", enter);
  number.addEventListener("keydown", (event) => {
    if (event.key === "Enter") enter();
    if (event.key === "Escape") number.value = (value / scale).toFixed(digits);
  });
  const row = el(
    "div",
    { class: off ? "slider off" : "slider" },
    el("span", { class: "name", title: title ?? name }, name),
    slider,
    number,
    el("span", { class: "unit" }, unit),
    note ? el("span", { class: "note" }, note) : null,
  );
  row.dataset.name = name;
  row.set = (next) => {
    if (held || !Number.isFinite(next) || next === value) return;
    value = next;
    show();
  };
  row.value = () => value;
  row.mark = (on) => row.classList.toggle("marked", on);
  show();
  return row;
}

/// Tabs by the pattern of WAI-ARIA: arrows go between them. `pages` are { id, title, element }.
export function tabs(pages, label, changed) {
  const buttons = pages.map(({ id, title, element }) => {
    Object.assign(element, { id: `page-${id}`, tabIndex: -1 });
    element.setAttribute("role", "tabpanel");
    element.setAttribute("aria-labelledby", `tab-${id}`);
    return button(title, () => choose(id), {
      ...{ role: "tab", id: `tab-${id}`, "aria-controls": `page-${id}` },
    });
  });
  let chosen = null;
  function choose(id) {
    if (chosen === id) return;
    chosen = id;
    pages.forEach((page, i) => {
      const on = page.id === id;
      page.element.hidden = !on;
      buttons[i].setAttribute("aria-selected", String(on));
      buttons[i].tabIndex = on ? 0 : -1;
    });
    changed(id);
  }
  const list = el("div", { class: "tabs", role: "tablist", "aria-label": label }, ...buttons);
  list.addEventListener("keydown", ({ key }) => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[key];
    if (!by) return;
    const at = buttons.indexOf(document.activeElement);
    const next = (at + by + buttons.length) % buttons.length;
    buttons[next].focus();
    choose(pages[next].id);
  });
  return { list, choose, chosen: () => chosen };
}

/// Warnings: one line for a single warning, else a list to unfold.
export function warnings(words) {
  if (!words?.length) return [];
  const lines = words.map((text) => el("p", { class: "warning" }, text));
  if (lines.length === 1) return lines;
  return [
    el("details", { class: "warnings" }, el("summary", {}, `${lines.length} remarks`), ...lines),
  ];
}

/// A table of plain cells; the first row is its head.
export const plainTable = (head, rows, label) =>
  el(
    "div",
    { class: "table-frame", tabindex: 0, role: "region", "aria-label": label },
    el(
      "table",
      {},
      el("thead", {}, el("tr", {}, ...head.map((cell) => el("th", { scope: "col" }, cell)))),
      el("tbody", {}, ...rows.map((row) => el("tr", {}, ...row.map((cell) => el("td", {}, cell))))),
    ),
  );

/// Puts a table's rows in place of the old ones only where a text changed.
export function refill(body, rows) {
  while (body.rows.length > rows.length) body.deleteRow(-1);
  rows.forEach((cells, r) => {
    const row = body.rows[r] ?? body.insertRow();
    cells.forEach((text, c) => {
      const cell = row.cells[c] ?? row.insertCell();
      if (cell.textContent !== text) cell.textContent = text;
    });
  });
}

/// Facts as a list of terms.
export const facts = (entries) =>
  el(
    "dl",
    { class: "facts" },
    ...entries.flatMap(([name, value]) => [el("dt", {}, name), el("dd", {}, value)]),
  );
