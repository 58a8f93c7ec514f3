// The numbers of a drawn block as a table { columns, rows }, for CSV. Without the browser.

const columnsOf = (...names) => names.map((name) => ({ name }));

/// A row for each entry with these keys; what an entry lacks is left empty.
const pick = (keys, entry) => keys.map((key) => entry[key] ?? null);

function linesTable({ series, x_label, y_label }) {
  const rows = series.flatMap((s) =>
    s.x.map((x, i) => [
      s.name,
      x,
      s.y[i],
      s.band_low?.[i] ?? null,
      s.band_high?.[i] ?? null,
      s.labels?.[i] ?? s.hints?.[i] ?? null,
    ]),
  );
  const columns = columnsOf(
    "series",
    x_label || "x",
    y_label || "y",
    "band_low",
    "band_high",
    "label",
  );
  return { columns, rows };
}

const BAR = ["series", "value", "low", "high"];
const barsTable = ({ groups }) => ({
  columns: columnsOf("group", ...BAR),
  rows: groups.flatMap((g) => g.values.map((v) => [g.name, ...pick(BAR, v)])),
});

const INTERVAL = [
  ...["name", "unit", "estimate", "low", "high", "inner_low", "inner_high"],
  ...["prior_low", "prior_high", "truth", "display"],
];
const intervalTable = ({ rows }) => ({
  columns: columnsOf(...INTERVAL),
  rows: rows.map((row) => pick(INTERVAL, row)),
});

const FORCES = ["measured", "predicted", "sd", "predicted_sd"];
const vectorsTable = ({ planes }) => ({
  columns: columnsOf(
    ...["plane", "panel", "group"],
    ...FORCES.flatMap((name) => [`${name}_x`, `${name}_y`]),
  ),
  rows: planes.flatMap((plane) =>
    plane.panels.flatMap((panel) =>
      panel.arrows.map((arrow) => [
        ...[plane.name, panel.title, arrow.group],
        ...FORCES.flatMap((name) => arrow[name] ?? [null, null]),
      ]),
    ),
  ),
});

const PREDICTED = ["measured", "median", "inner_low", "inner_high", "low", "high"];
const predictiveTable = ({ components, groups }) => ({
  columns: columnsOf("group", "row", "component", ...PREDICTED),
  rows: groups.flatMap((g) =>
    g.rows.flatMap((row) =>
      row.values.map((v, c) => [g.name, row.name, components[c], ...pick(PREDICTED, v)]),
    ),
  ),
});

const chainsTable = ({ chains, draws, quantities }) => ({
  columns: columnsOf("quantity", "unit", "chain", "draw", "value"),
  rows: quantities.flatMap((q) =>
    q.traces.flatMap((trace, c) =>
      trace.map((value, i) => [q.name, q.unit ?? null, chains[c], draws[i], value]),
    ),
  ),
});

const cornerTable = ({ quantities }) => ({
  columns: quantities.map(({ name, unit }) => ({ name, unit })),
  rows: quantities[0].draws.map((_, i) => quantities.map((q) => q.draws[i])),
});

const TABLES = {
  lines: linesTable,
  bars: barsTable,
  interval: intervalTable,
  vectors: vectorsTable,
  predictive: predictiveTable,
  chains: chainsTable,
  corner: cornerTable,
};

/// Null for a block that is no chart.
export const figureTable = (block) => TABLES[block.type]?.(block) ?? null;

/// A file name from a caption: its first words, in lower case.
export const fileName = (caption, fallback) =>
  (caption ?? "")
    .toLowerCase()
    .split(/[^a-z0-9]+/)
    .filter(Boolean)
    .slice(0, 6)
    .join("-") || fallback;
