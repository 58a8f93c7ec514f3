// A table that can be sorted, searched, unfolded and saved.

import { csvOf } from "./csv.js";
import { el } from "./dom.js";
import { figure } from "./figure.js";
import { fileName } from "./figure_csv.js";
import { download } from "./save.js";
import { keepFitting } from "./table_fit.js";
import { formatCell, sizeOf } from "../numbers/format.js";
import { bestRows, isNumeric, matching, sortedBy } from "./table_model.js";

const FOLDED_ROWS = 15;
const LONG_TEXT = 40; // characters

/// Sentences are broken into lines; names and numbers are not.
const isWords = (value) => typeof value === "string" && value.length > LONG_TEXT;

const withUnit = ({ name, unit }) => (unit ? `${name} [${unit}]` : name);

/// On cards the name of its column stands beside a cell.
const cell = (block, c, value, best, size) =>
  el(
    "td",
    {
      class: `${isNumeric(block, c) ? "number" : ""} ${best ? "best" : ""} ${isWords(value) ? "words" : ""}`,
      "data-column": withUnit(block.columns[c]),
    },
    formatCell(value, block.columns[c].digits, size),
    best ? el("span", { class: "hidden-words" }, " (best)") : null,
  );

/// The size of the numbers of each column, from all its rows.
const columnSizes = (block) => block.columns.map((_, c) => sizeOf(block.rows.map((row) => row[c])));

function bodyRows(block, rows, best, sizes) {
  if (!rows.length)
    return [el("tr", {}, el("td", { colspan: block.columns.length, class: "empty" }, "no rows"))];
  return rows.map((row) =>
    el(
      "tr",
      {},
      ...row.map((value, c) =>
        cell(block, c, value, c === block.highlight_best && best.has(row), sizes[c]),
      ),
    ),
  );
}

function headCell(block, c, onSort) {
  const { name, unit } = block.columns[c];
  const label = el(
    "button",
    { type: "button", title: `Sort by ${name}`, onclick: onSort },
    name,
    unit ? el("span", { class: "unit" }, ` [${unit}]`) : null,
  );
  return el("th", { scope: "col", class: isNumeric(block, c) ? "number" : "" }, label);
}

function saveButton(block) {
  const save = () => download(`${fileName(block.caption, "table")}.csv`, csvOf(block), "text/csv");
  return el("button", { type: "button", onclick: save }, "Save CSV");
}

const searchBox = (onSearch) =>
  el("input", {
    type: "search",
    placeholder: "Search rows",
    "aria-label": "Search rows",
    oninput: (event) => onSearch(event.target.value),
  });

function foldButton(frame, count, refit) {
  if (count <= FOLDED_ROWS) return null;
  frame.classList.add("long", "folded");
  const button = el(
    "button",
    { type: "button", "aria-expanded": "false" },
    `Show all ${count} rows`,
  );
  button.addEventListener("click", () => {
    const folded = frame.classList.toggle("folded");
    button.textContent = folded ? `Show all ${count} rows` : `Show the first ${FOLDED_ROWS} rows`;
    button.setAttribute("aria-expanded", String(!folded));
    refit();
  });
  return button;
}

/// Shows at which sides a table goes on beyond its frame.
function withEdges(frame) {
  const box = el("div", { class: "table-box" }, frame);
  const mark = () => {
    const rest = frame.scrollWidth - frame.clientWidth - frame.scrollLeft;
    box.classList.toggle("goes-left", frame.scrollLeft > 1);
    box.classList.toggle("goes-right", rest > 1);
  };
  frame.addEventListener("scroll", mark, { passive: true });
  new ResizeObserver(mark).observe(frame);
  return box;
}

export function drawTable(block) {
  const best = bestRows(block);
  const sizes = columnSizes(block);
  const view = { column: null, descending: false, text: "" };
  const body = el("tbody");
  const fillBody = () =>
    body.replaceChildren(
      ...bodyRows(block, sortedBy(matching(block.rows, view.text), view), best, sizes),
    );
  const sort = (c) => {
    view.descending = view.column === c && !view.descending;
    view.column = c;
    heads.forEach((head, i) =>
      head.setAttribute(
        "aria-sort",
        i !== c ? "none" : view.descending ? "descending" : "ascending",
      ),
    );
    fillBody();
  };
  const heads = block.columns.map((_, c) => headCell(block, c, () => sort(c)));
  const frame = el(
    "div",
    { class: "table-frame", tabindex: 0, role: "region", "aria-label": block.caption ?? "Table" },
    el("table", {}, el("thead", {}, el("tr", {}, ...heads)), body),
  );
  fillBody();
  const refit = keepFitting(frame);
  const tools = el(
    "div",
    { class: "tools" },
    block.search
      ? searchBox((text) => {
          view.text = text;
          fillBody();
          refit();
        })
      : null,
    foldButton(frame, block.rows.length, refit),
    saveButton(block),
  );
  return figure("table", block.caption, withEdges(frame), tools);
}
