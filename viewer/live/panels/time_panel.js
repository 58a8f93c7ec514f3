// Time panel: play, pause, step, scrub, contact forces, energies.

import { el } from "../../report/dom.js";
import { formatNumber } from "../../numbers/format.js";
import { latestWins } from "../link/latest.js";
import {
  backToWorld,
  button,
  choice,
  fileRow,
  part,
  plainTable,
  refill,
  slowButton,
} from "./controls.js";
import { makeEnergyChart } from "./energy_chart.js";
import { makeMotionInputs } from "./motion_inputs.js";

const SPEEDS = ["0.05", "0.1", "0.25", "0.5", "1", "2"];
const ROWS = 12; // contacts in the table
const SAME_TIME = 1e-9; // [s]

const speedWords = SPEEDS.map((value) => ({ value, text: `${value} \u00d7` }));

/// The largest contact forces of a frame, as rows of a table.
export function contactRows(scene, { contacts }) {
  const name = (i) => scene.bodies[i]?.name ?? "world";
  return contacts
    .map((c) => ({ ...c, size: Math.hypot(...c.force) }))
    .sort((a, b) => b.size - a.size)
    .slice(0, ROWS)
    .map((c) => [
      `${name(c.a)} on ${name(c.b)}`,
      formatNumber(c.size, 2),
      formatNumber(c.friction, 2),
    ]);
}

/// The motion of the session, if it is what is shown.
function shownMotion(app) {
  const motion = app.store.state?.motion;
  return motion?.shown ? motion : null;
}

/// Returns true if a scene is at the end of its duration, where playback pauses.
export function standsAtEnd(motion, time) {
  if (!motion || motion.playing || motion.recorded || motion.duration == null) return false;
  return Math.abs(time - motion.duration) <= SAME_TIME;
}

/// Play, steps, the slider of time and the speed; `energy` forgets what a reset undoes. Returns { element,
/// follow(frame), show(motion), forget(), toggle(), step(steps) }.
function makePlayer(app, energy) {
  const motion = () => shownMotion(app);
  const clock = el("output", { class: "clock" });
  const play = button("Play", () => toggle(), { id: "play", class: "main" });
  const scrub = el("input", {
    ...{ type: "range", min: 0, max: 1, value: 0, step: "any" },
    ...{ "aria-label": "Time [s]", class: "scrub" },
  });
  const asked = () => ({ speed: Number(speed.value()) });
  const speed = choice("Speed", () => motion()?.playing && app.ask("motion.play", asked()));
  speed.set(speedWords, "1");
  const seek = latestWins((t) => app.ask("motion.seek", { t }));
  scrub.addEventListener("input", () => seek(Number(scrub.value)));
  let furthest = 0;
  const end = el(
    "p",
    { class: "hint", id: "scene-end", role: "status", hidden: true },
    "The time of the scene ends here. Play goes on.",
  );
  const tellEnd = (time) => (end.hidden = !standsAtEnd(motion(), time));

  async function toggle() {
    if (!motion()) return;
    if (motion().playing) await app.ask("motion.pause");
    else await app.ask("motion.play", asked());
  }
  const step = (steps) => app.ask("motion.step", { steps });
  const forget = () => (furthest = 0);
  async function back() {
    energy.clear();
    forget();
    await app.ask("motion.reset");
  }
  const live = [
    slowButton("Step", () => step(1), { id: "step", title: "One step of time" }),
    slowButton("10 steps", () => step(10)),
    slowButton("Reset", back, { title: "Back to the beginning" }),
  ];
  const follow = ({ time }) => {
    const { duration, recorded } = motion() ?? {};
    furthest = Math.max(furthest, time, (recorded && duration) || 0);
    scrub.max = furthest || 1;
    scrub.value = time;
    scrub.setAttribute("aria-valuetext", `${time.toFixed(3)} s`);
    const whole = duration && time <= duration + SAME_TIME ? ` of ${duration.toFixed(3)}` : "";
    clock.textContent = `${time.toFixed(3)}${whole}\u202fs`;
    tellEnd(time);
  };
  const show = (open) => {
    play.textContent = open?.playing ? "Pause" : "Play";
    play.setAttribute("aria-pressed", String(Boolean(open?.playing)));
    if (open?.speed) speed.set(speedWords, String(open.speed));
    for (const one of live) one.hidden = Boolean(open?.recorded);
    // The state that tells of the pause comes after the frame of it.
    tellEnd(app.store.frame?.time ?? NaN);
  };
  const element = [
    el("div", { class: "buttons" }, play, ...live),
    el("div", { class: "scrubber" }, scrub, clock),
    end,
    speed,
  ];
  return { element, follow, show, forget, toggle, step };
}

/// Buttons that open a motion or show it again: { hint, buttons, show(here, motion) }.
function makeBeginning(app, energy) {
  const start = () => {
    energy.clear();
    return app.ask("motion.open");
  };
  const hint = el("p", { class: "hint" });
  const resume = slowButton("Show the motion", () => app.ask("session.mode", { mode: "motion" }));
  const fresh = slowButton("Begin from this world", start, { id: "begin-motion" });
  const scenes = slowButton("Open a scene\u2026", () => app.openDialog("scenes"));
  const show = (here, open) => {
    hint.textContent = here
      ? ""
      : open
        ? "A motion is open, but not shown."
        : "No motion is open: begin with the world as it stands, or open a scene.";
    hint.hidden = here;
    resume.hidden = here || !open;
    fresh.textContent = here ? "Begin anew from the world" : "Begin from this world";
  };
  const buttons = el("div", { class: "buttons" }, resume, fresh, scenes, backToWorld(app));
  return { hint, buttons, show };
}

export function makeTimePanel(app) {
  const { store } = app;
  const energy = makeEnergyChart(app);
  const inputs = makeMotionInputs(app);
  const player = makePlayer(app, energy);
  const beginning = makeBeginning(app, energy);
  const contacts = plainTable(["contact", "force [N]", "friction"], [], "Contacts");
  const energies = part("Energy", energy.element);
  const running = el(
    "div",
    { class: "parts" },
    ...player.element,
    energy.warning,
    inputs.element,
    part("Contacts", contacts),
    part("Reliability", energy.account),
    energies,
  );
  const run = fileRow("Run", (file) => app.ask("motion.record", { file }));
  const panel = el(
    "div",
    { class: "page time" },
    ...[beginning.hint, beginning.buttons, run, running],
  );

  const here = () => store.scene?.mode === "motion";
  const motion = () => shownMotion(app);
  const follow = () => {
    if (panel.hidden || !store.frame || !here()) return;
    player.follow(store.frame);
    refill(contacts.querySelector("tbody"), contactRows(store.scene, store.frame));
    if (!motion()?.recorded) energy.follow();
  };
  const show = () => {
    running.hidden = !here();
    energies.hidden = Boolean(motion()?.recorded);
    beginning.show(here(), store.state?.motion ?? null);
    player.show(motion());
  };
  store.on(["scene", "state", "tab"], show);
  store.on(["frame", "tab"], follow);
  let known = null; // revision of the scene whose energies and end these are
  store.on(["link"], ({ link }) => (known = link ? known : null));
  store.on(["scene"], ({ scene }) => {
    // Another scene has energies and an end of its own; the same one is told anew when a program connects.
    if (scene.revision === known) return;
    known = scene.revision;
    energy.clear();
    player.forget();
    if (!here()) return;
    inputs.element.hidden = Boolean(motion()?.recorded);
    if (motion()?.recorded) energy.tell();
    else inputs.refill();
  });
  app.togglePlay = player.toggle;
  app.stepTime = player.step;
  show();
  return panel;
}
