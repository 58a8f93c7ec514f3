// What esbuild makes of the sources: the files that the C++ side embeds, of reports and of the live page.

const licences =
  "/*! Contains three.js (MIT, three.js authors), uPlot (MIT, Leon Sorokin), " +
  "lil-gui (MIT, George Michael Brower). */";

const shared = {
  absWorkingDir: import.meta.dirname,
  bundle: true,
  minify: true,
  target: "es2020",
  charset: "ascii", // the page need not declare how the embedded text is encoded
  legalComments: "eof",
};

export const BUNDLES = [
  {
    ...shared,
    entryPoints: ["report/main.js"],
    outfile: "bundle/report.js",
    format: "iife",
    banner: { js: licences },
  },
  {
    ...shared,
    entryPoints: ["report/style/report.css"],
    outfile: "bundle/report.css",
    banner: { css: licences },
  },
  {
    ...shared,
    entryPoints: ["live/main.js"],
    outfile: "bundle/live.js",
    format: "iife",
    banner: { js: licences },
  },
  {
    ...shared,
    entryPoints: ["live/style/live.css"],
    outfile: "bundle/live.css",
    banner: { css: licences },
  },
  {
    absWorkingDir: import.meta.dirname,
    entryPoints: ["live/live.html"],
    outfile: "bundle/live.html",
    loader: { ".html": "copy" },
  },
];
