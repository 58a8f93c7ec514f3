// Writes sample/report.json: every block type, at the size of a fit of one finger. All numbers are
// invented.

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { evidence, forces } from "./fit_sections.js";
import { MESHES, meshes } from "./mesh_sections.js";
import { axes, speed } from "./model_sections.js";
import { posterior } from "./posterior_sections.js";

const report = {
  title: "Middle finger: joint axes from fingertip forces",
  subtitle:
    "A sample report. Every number in it is invented; it shows what each kind of block looks like.",
  provenance: {
    command: "thenar fit data/experiments/sample.toml --digit middle --seed 7",
    version: "0.1.0",
    seed: "7",
    fidelity: "static, hinge axes, constant moment arms, fixed force fractions",
    "data/subjects/sample.toml":
      "sha256 3f9a0c1e7b52d84a6c0f1d2e3b4a59687786950a1b2c3d4e5f60718293a4b5c6",
    Eigen: "3.4.0",
    Ceres: "2.1.0",
  },
  file: "report.html",
  pages: [
    { file: "report.html", title: "The sample" },
    { file: "other.html", title: "Another page" },
  ],
  opening: {
    asked: "Where are the axes of a middle finger, and what do forces at its tip tell of them?",
    done: "A finger was invented and fitted to invented forces.",
    learnt: "Nothing about fingers; but each kind of block was seen.",
  },
  summary: [
    { text: "The forces are explained within their noise." },
    { text: "Another page would say more.", file: "other.html", link: "Another page" },
  ],
  meshes: MESHES,
  sections: [forces(), evidence(), axes(), speed(), meshes(), ...posterior()],
};

// Numbers of one list stand in one line.
const text = JSON.stringify(report, null, 1).replace(/\[[-\s\d.,enul]*\]/g, (list) =>
  list.replace(/\s+/g, " "),
);

writeFileSync(join(import.meta.dirname, "report.json"), text + "\n");
