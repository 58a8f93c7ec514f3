// Wraps a report as the C++ writer does: one file that needs nothing else.

import { readFileSync } from "node:fs";
import { join } from "node:path";

const bundle = (name) => readFileSync(join(import.meta.dirname, "../bundle", name), "utf8");

/// "<" is written as \u003c, so that no text of the report can end the script element.
const embedded = (report) => JSON.stringify(report).replace(/</g, "\\u003c");

export const pageOf = (report) => `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>thenar report</title><style>${bundle("report.css")}</style></head>
<body><main id="report"></main><script type="application/json" id="thenar-report">${embedded(report)}</script>
<script>${bundle("report.js")}</script></body></html>
`;
