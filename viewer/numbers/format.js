// Numbers as a reader wants them: true minus signs, "n/a" for what could not be computed.

export const MISSING = "n/a";

export const isNumber = (value) => typeof value === "number" && Number.isFinite(value);

const minus = (text) => text.replace(/-/g, "\u2212");

/// Drops the trailing zeros of a mantissa, and the plus sign of an exponent: 1.500e+7 to 1.5e7.
const tidy = (text) =>
  text
    .replace(/(\.\d*?)0+(?=e|$)/, "$1")
    .replace(/\.(?=e|$)/, "")
    .replace("e+", "e");

function significant(value, figures) {
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) return tidy(value.toExponential(figures - 1));
  return tidy(
    value.toPrecision(figures).includes("e") ? value.toFixed(0) : value.toPrecision(figures),
  );
}

function fixed(value, digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0 && value !== 0 ? tidy(value.toExponential(1)) : text;
}

/// `digits` counts those after the decimal point; without it four figures are significant.
/// A small number that would round to zero is shown with an exponent instead.
export function formatNumber(value, digits) {
  if (!isNumber(value)) return MISSING;
  return minus(
    digits === undefined || digits === null ? significant(value, 4) : fixed(value, digits),
  );
}

/// Any table cell.
export function formatCell(value, digits) {
  if (value === null || value === undefined) return MISSING;
  if (typeof value === "boolean") return value ? "yes" : "no";
  return typeof value === "number" ? formatNumber(value, digits) : String(value);
}
