// Time: play, pause, step, scrub, what forces act, and where the energy is.

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

export function makeTimePanel(app) {
  const { store } = app;
  const energy = makeEnergyChart(app);
  const inputs = makeMotionInputs(app);
  const contacts = plainTable(["contact", "force [N]", "friction"], [], "Contacts");
  const clock = el("output", { class: "clock" });
  const play = button("Play", () => toggle(), { id: "play", class: "main" });
  const scrub = el("input", {
    ...{ type: "range", min: 0, max: 1, value: 0, step: "any" },
    ...{ "aria-label": "Time [s]", class: "scrub" },
  });
  const speed = choice(
    "Speed",
    () => motion()?.playing && app.ask("motion.play", { speed: Number(speed.value()) }),
  );
  speed.set(speedWords, "1");
  let furthest = 0;

  const motion = () => store.state?.motion ?? null;
  const seek = latestWins((t) => app.ask("motion.seek", { t }));
  scrub.addEventListener("input", () => seek(Number(scrub.value)));

  async function toggle() {
    if (!motion()) return;
    if (motion().playing) await app.ask("motion.pause");
    else await app.ask("motion.play", { speed: Number(speed.value()) });
  }
  const step = (steps) => app.ask("motion.step", { steps });
  async function start() {
    energy.clear();
    await app.ask("motion.open");
  }
  async function back() {
    energy.clear();
    furthest = 0;
    await app.ask("motion.reset");
  }

  function follow() {
    if (panel.hidden || !store.frame) return;
    const here = store.scene?.mode === "motion";
    if (!here) return;
    const { time } = store.frame;
    furthest = Math.max(furthest, time, motion()?.duration ?? 0);
    scrub.max = furthest || 1;
    scrub.value = time;
    scrub.setAttribute("aria-valuetext", `${time.toFixed(3)} s`);
    clock.textContent = `${time.toFixed(3)}\u202fs`;
    refill(contacts.querySelector("tbody"), contactRows(store.scene, store.frame));
    if (!motion()?.recorded) energy.follow();
  }
  const state = () => {
    const open = motion();
    const here = store.scene?.mode === "motion";
    running.hidden = !here;
    hint.textContent = here
      ? ""
      : open
        ? "A motion is open, but not shown."
        : "No motion is open: begin with the world as it stands, or open a scene.";
    resume.hidden = here || !open;
    play.textContent = open?.playing ? "Pause" : "Play";
    play.setAttribute("aria-pressed", String(Boolean(open?.playing)));
    if (open?.speed) speed.set(speedWords, String(open.speed));
    fresh.textContent = here ? "Begin anew from the world" : "Begin from this world";
    for (const one of live) one.hidden = Boolean(open?.recorded);
  };
  const hint = el("p", { class: "hint" });
  const resume = slowButton("Show the motion", () => app.ask("session.mode", { mode: "motion" }));
  const fresh = slowButton("Begin from this world", start, { id: "begin-motion" });
  const live = [
    slowButton("Step", () => step(1), { id: "step", title: "One step of time" }),
    slowButton("10 steps", () => step(10)),
    slowButton("Reset", back, { title: "Back to the beginning" }),
  ];
  const running = el(
    "div",
    {},
    el("div", { class: "buttons" }, play, ...live),
    el("div", { class: "scrubber" }, scrub, clock),
    speed,
    energy.warning,
    inputs.element,
    part("Contacts", contacts),
    part("Energy", energy.element),
  );
  const panel = el(
    "div",
    { class: "page time" },
    hint,
    el(
      "div",
      { class: "buttons" },
      resume,
      fresh,
      slowButton("Open a scene\u2026", () => app.openDialog("scenes")),
      backToWorld(app),
    ),
    fileRow("Run", (file) => app.ask("motion.record", { file })),
    running,
  );
  store.on(["scene", "state", "tab"], state);
  store.on(["frame", "tab"], follow);
  store.on(["scene"], () => {
    if (store.scene?.mode === "motion") {
      inputs.element.hidden = Boolean(motion()?.recorded);
      if (!motion()?.recorded) inputs.refill();
      return;
    }
    energy.clear();
    furthest = 0;
  });
  app.togglePlay = toggle;
  app.stepTime = step;
  state();
  return panel;
}
