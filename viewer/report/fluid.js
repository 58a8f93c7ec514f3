// Charts whose text keeps its size: they are drawn anew when their room changes.

import { el } from "./dom.js";

/// A frame that holds what `draw(width)` returns for its present width [px]; `frame.redraw()` draws
/// it again.
export function fluid(attributes, draw) {
  const frame = el("div", attributes);
  let width = 0;
  frame.redraw = () => width && frame.replaceChildren(...draw(width));
  const fit = () => {
    const room = Math.floor(frame.clientWidth);
    if (!room || room === width) return;
    width = room;
    frame.redraw();
  };
  new ResizeObserver(fit).observe(frame);
  addEventListener("beforeprint", fit);
  return frame;
}
