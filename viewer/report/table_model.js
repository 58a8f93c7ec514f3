// What a table shows, without the browser: order, matches, best values.

import { isNumber } from "../numbers/format.js";

/// A column of numbers, some of which may be missing.
export const isNumeric = (block, c) =>
  block.rows.some((row) => typeof row[c] === "number") &&
  block.rows.every((row) => row[c] === null || typeof row[c] === "number");

/// The rows that hold the best value of the column `highlight_best`: the lowest, unless `best` is
/// "highest".
export function bestRows(block) {
  const c = block.highlight_best;
  const rows = block.rows.filter((row) => isNumber(row[c]));
  if (c === undefined || c === null || !rows.length) return new Set();
  const pick = block.best === "highest" ? Math.max : Math.min;
  const value = rows.map((row) => row[c]).reduce((a, b) => pick(a, b));
  return new Set(rows.filter((row) => row[c] === value));
}

/// Rows in which any cell contains the text.
export function matching(rows, text) {
  const wanted = text.trim().toLowerCase();
  return wanted
    ? rows.filter((row) =>
        row.some((value) =>
          String(value ?? "n/a")
            .toLowerCase()
            .includes(wanted),
        ),
      )
    : rows;
}

const compare = (a, b) =>
  typeof a === "number" && typeof b === "number"
    ? a - b
    : String(a).localeCompare(String(b), undefined, { numeric: true });

/// A sorted copy; missing values always come last.
export function sortedBy(rows, { column, descending }) {
  if (column === null) return rows;
  const known = rows.filter((row) => row[column] !== null);
  const missing = rows.filter((row) => row[column] === null);
  known.sort((a, b) => compare(a[column], b[column]) * (descending ? -1 : 1));
  return [...known, ...missing];
}
