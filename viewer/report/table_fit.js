// Makes room for tables that are wider than their frame: denser in three steps, then as cards.

const NARROW = 560; // where a row that finds no room becomes a card [px]
const FEW = 3; // rows that become cards in any room
const STEPS = ["tight", "tighter", "tightest"];

const goesOver = (frame) => frame.scrollWidth > frame.clientWidth + 1;

/// Gives the frame of a table the classes that let it fit; where none does, it scrolls.
function fit(frame) {
  frame.classList.remove(...STEPS, "cards");
  for (const step of STEPS) {
    if (!goesOver(frame)) return;
    frame.classList.add(step);
  }
  const few = frame.querySelectorAll("tbody tr").length <= FEW;
  if (goesOver(frame) && (few || frame.clientWidth < NARROW)) {
    frame.classList.remove(...STEPS);
    frame.classList.add("cards");
  }
}

/// Fits a table anew whenever its room changes. Returns a function that does so when its rows have.
export function keepFitting(frame) {
  let width = 0;
  new ResizeObserver(() => {
    if (!frame.clientWidth || frame.clientWidth === width) return;
    width = frame.clientWidth;
    fit(frame);
  }).observe(frame);
  return () => fit(frame);
}
