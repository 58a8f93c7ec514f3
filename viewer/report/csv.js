// A table as CSV (RFC 4180), with units in the head and full precision in the cells.

const quoted = (value) => {
  const text = value === null || value === undefined ? "" : String(value);
  return /[",\r\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
};

export function csvOf({ columns, rows }) {
  const head = columns.map(({ name, unit }) => (unit ? `${name} [${unit}]` : name));
  return [head, ...rows].map((row) => row.map(quoted).join(",")).join("\r\n") + "\r\n";
}
