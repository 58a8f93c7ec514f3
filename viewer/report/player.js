// Plays a scene whose layers are instants of a motion.

import { el } from "./dom.js";
import { instantAt, instantsOf, speedsFor } from "../picture/frames.js";
import { formatNumber } from "../numbers/format.js";
import { record } from "./movie.js";

/// From so many instants on, a view begins at the first instead of showing all.
const kManyInstants = 10;

/// Calls `tick(seconds since the last call)` every frame until it returns false.
function everyFrame(tick) {
  let last = null;
  const step = (now) => {
    const passed = last === null ? 0 : (now - last) / 1000;
    last = now;
    if (tick(passed)) requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

/// Shows of all timed layers those of one instant, or with null all of them.
function show(view, instant) {
  for (const { group, time } of view.layers)
    if (time !== null) group.visible = instant === null || time === instant;
  view.draw();
}

/// Controls of a view with timed layers: play and pause, a slider, the speed, and all instants at
/// once, as a view of few instants begins. Returns { element, film }: film(canvas, colour) plays
/// the whole motion once at the speed chosen, with all controls disabled, and promises the film; the
/// promise fails where the browser cannot record. Null for a view without instants.
export function playerOf(view) {
  const instants = instantsOf(view.layers);
  if (!instants.length) return null;
  const [first, last] = [instants[0], instants.at(-1)];
  const { speeds, chosen } = speedsFor(instants);
  let playing = false;
  let run = 0; // number of the loop that moves `now`; older ones end
  let now = first;
  const button = el("button", { type: "button", class: "play" });
  const told = el("output", {});
  const slider = el("input", {
    ...{ type: "range", min: 0, max: instants.length - 1, step: 1, value: 0 },
    "aria-label": "Instant",
  });
  const speed = el(
    "select",
    { "aria-label": "Speed" },
    ...speeds.map((value) =>
      el("option", { value, selected: value === chosen }, `${formatNumber(value)} \u00d7`),
    ),
  );
  // A few instants are read at once; many would hide each other.
  const all = el("input", { type: "checkbox", checked: instants.length < kManyInstants });
  const update = () => {
    const instant = instantAt(instants, now);
    button.textContent = playing ? "Pause" : "\u25b6 Play";
    slider.value = String(instants.indexOf(instant));
    told.textContent = all.checked ? "" : `${formatNumber(instant)} s`;
    show(view, all.checked ? null : instant);
  };
  /// Ends the motion that plays.
  const pause = () => {
    playing = false;
    ++run;
  };
  /// `shown` is called after every instant; the promise is kept when the motion ends, and fails with
  /// what `shown` throws.
  const play = (shown = () => {}) =>
    new Promise((ended, failed) => {
      pause();
      const mine = run;
      playing = true;
      all.checked = false;
      if (now >= last) now = first;
      everyFrame((passed) => {
        if (mine === run) {
          now = Math.min(last, now + passed * Number(speed.value));
          if (now >= last) pause();
          update();
          try {
            shown();
          } catch (error) {
            pause();
            failed(error);
          }
        }
        if (mine !== run) ended();
        return mine === run;
      });
    });
  const film = async (canvas, color) => {
    const controls = [button, slider, speed, all];
    pause();
    for (const control of controls) control.disabled = true;
    try {
      now = first;
      const recording = record(canvas, color);
      try {
        await play(() => {
          view.paintNow();
          recording.frame();
        });
      } finally {
        recording.stop();
      }
      return await recording.film;
    } finally {
      for (const control of controls) control.disabled = false;
      pause();
      update();
    }
  };
  button.addEventListener("click", () => {
    if (playing) pause();
    else play();
    update();
  });
  slider.addEventListener("input", () => {
    pause();
    all.checked = false;
    now = instants[Number(slider.value)];
    update();
  });
  all.addEventListener("change", () => {
    pause();
    update();
  });
  update();
  const element = el(
    "div",
    { class: "tools player", role: "group", "aria-label": "Motion" },
    ...[button, slider, told, speed, el("label", {}, all, " all instants")],
  );
  return { element, film };
}
