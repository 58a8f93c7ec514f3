// What esbuild makes of the sources: the two files that the C++ side embeds.

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
];
