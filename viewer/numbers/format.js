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

const ROUND_OFF = 1e-12; // of the largest value: what is left where numbers of that size cancel
const BELOW_DIGITS = 1e-6; // of the last digit shown

/// Whether a value is what rounding leaves of zero, beside values of size `scale` or in a column
/// of so many `digits`.
function isRoundOff(value, digits, scale) {
  const last = digits === undefined || digits === null ? 0 : BELOW_DIGITS * 10 ** -digits;
  return Math.abs(value) < Math.max(last, ROUND_OFF * scale);
}

/// `digits` counts those after the decimal point; without it four figures are significant.
/// A small number that would round to zero is shown with an exponent instead, unless it is what
/// rounding leaves of zero: less than 1e-12 of `scale`, the size of the numbers it stands among.
export function formatNumber(value, digits, scale = 0) {
  if (!isNumber(value)) return MISSING;
  const told = isRoundOff(value, digits, scale) ? 0 : value;
  return minus(
    digits === undefined || digits === null ? significant(told, 4) : fixed(told, digits),
  );
}

/// The largest size among values, 0 if there is none: the scale for formatNumber().
export const sizeOf = (values) =>
  values.reduce((most, v) => (isNumber(v) ? Math.max(most, Math.abs(v)) : most), 0);

/// Any table cell.
export function formatCell(value, digits, scale) {
  if (value === null || value === undefined) return MISSING;
  if (typeof value === "boolean") return value ? "yes" : "no";
  return typeof value === "number" ? formatNumber(value, digits, scale) : String(value);
}

const MOST_DECIMALS = 12;

/// The least number of decimals that tells all values apart and shows each of them exactly.
function decimalsOf(values, step) {
  for (let d = 0; d < MOST_DECIMALS; ++d)
    if (values.every((v) => Math.abs(v - Number(v.toFixed(d))) < 1e-6 * step)) return d;
  return MOST_DECIMALS;
}

/// Labels of the ticks of one linear axis: all with the same number of decimals, as many as their
/// steps need, and with one exponent where they are very large or small.
export function tickLabels(values) {
  const size = sizeOf(values);
  const gaps = values.slice(1).map((v, i) => Math.abs(v - values[i]));
  const step = Math.min(...gaps.filter((gap) => gap > 0), size || 1);
  const power = size !== 0 && (size < 1e-3 || size >= 1e6) ? Math.floor(Math.log10(size)) : 0;
  const scaled = values.map((v) => (Math.abs(v) < 1e-6 * step ? 0 : v / 10 ** power));
  const decimals = decimalsOf(scaled, step / 10 ** power);
  const exponent = (v) => (power && v !== 0 ? `e${power}` : "");
  return scaled.map((v) => minus(`${v.toFixed(v === 0 && power ? 0 : decimals)}${exponent(v)}`));
}
