// Canvases do not follow the style sheet: they ask here for colours, and are told when these
// change.

const listeners = new Set();
const notify = () => listeners.forEach((redraw) => redraw());

/// The present value of a custom property of the page, such as "--ink".
export const themeColor = (name) =>
  getComputedStyle(document.documentElement)
    .getPropertyValue(name.replace(/^var\(|\)$/g, ""))
    .trim();

/// Calls `redraw` when the reader switches between light and dark, or prints.
export const onThemeChange = (redraw) => listeners.add(redraw);

/// Whether the page is being laid out for paper.
export const isPrinting = () => document.documentElement.classList.contains("printing");

function printing(on) {
  document.documentElement.classList.toggle("printing", on);
  document.querySelectorAll("details").forEach((details) => {
    if (on) details.open = true;
  });
  notify();
}

/// Starts listening; called once by the page.
export function watchTheme() {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", notify);
  addEventListener("beforeprint", () => printing(true));
  addEventListener("afterprint", () => printing(false));
}
