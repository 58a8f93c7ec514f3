// Reads the report that was embedded in the page, and draws it.

import { errorBox } from "./figure.js";
import { drawPage } from "./page.js";
import { watchTheme } from "./theme.js";

const root = document.getElementById("report");

function readReport() {
  const holder = document.getElementById("thenar-report");
  if (!holder) throw new Error("the page has no element thenar-report");
  return JSON.parse(holder.textContent);
}

try {
  watchTheme();
  drawPage(root, readReport());
} catch (error) {
  root.replaceChildren(errorBox(`The report cannot be shown: ${error.message}`));
}
