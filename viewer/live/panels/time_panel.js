// Time: play, pause, step, scrub, what forces act, and where the energy is.

import { el } from "../../report/dom.js";
import { formatNumber } from "../../numbers/format.js";
import { latestWins } from "../link/latest.js";
import { button, choice, part, plainTable, refill, slowButton } from "./controls.js";
import { liveChart } from "./live_chart.js";

const SPEEDS = ["0.05", "0.1", "0.25", "0.5", "1", "2"];
const ASK = 200; // at least between two questions for energies [ms]
const MOST = 1500; // points of a chart
const ROWS = 12; // contacts in the table

/// Numbers of an object by name, also those one level down: { kinetic: 1 }.
const numbersOf = (object) =>
  Object.fromEntries(Object.entries(object ?? {}).filter(([, value]) => Number.isFinite(value)));

/// Energies over time, which forget what comes after a step back.
export function makeHistory() {
  const history = { t: [], values: new Map() };
  history.add = (t, values) => {
    while (history.t.length && history.t.at(-1) >= t) {
      history.t.pop();
      for (const list of history.values.values()) list.pop();
    }
    for (const name of Object.keys(values))
      if (!history.values.has(name))
        history.values.set(
          name,
          history.t.map(() => null),
        );
    history.t.push(t);
    for (const [name, list] of history.values) list.push(values[name] ?? null);
    if (history.t.length > MOST) {
      // Every second point of the older half goes: the whole run stays in sight.
      const keep = (_, i) => i % 2 === 0 || i > MOST / 2;
      history.t = history.t.filter(keep);
      for (const [name, list] of history.values) history.values.set(name, list.filter(keep));
    }
  };
  history.clear = () => {
    history.t = [];
    history.values = new Map();
  };
  history.series = () => [...history.values].map(([name, y]) => ({ name, x: history.t, y }));
  return history;
}

function energyBlock(history) {
  return {
    caption: "Energies",
    x_label: "time [s]",
    y_label: "energy [J]",
    height: 200,
    series: history.series(),
  };
}

export function makeTimePanel(app) {
  const { store } = app;
  const history = makeHistory();
  const chartBox = el("div", { class: "charts" });
  const contacts = plainTable(["contact", "force [N]", "friction"], [], "Contacts");
  const clock = el("output", { class: "clock" });
  const play = button("Play", () => toggle(), { id: "play", class: "main" });
  const scrub = el("input", {
    ...{
      type: "range",
      min: 0,
      max: 1,
      value: 0,
      step: "any",
      "aria-label": "Time [s]",
      class: "scrub",
    },
  });
  const speed = choice(
    "Speed",
    () => motion()?.playing && app.ask("motion.play", { speed: Number(speed.value()) }),
  );
  speed.set(
    SPEEDS.map((value) => ({ value, text: `${value} \u00d7` })),
    "1",
  );
  let chart = null;
  let asked = 0;
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
    history.clear();
    await app.ask("motion.open");
  }
  async function back() {
    history.clear();
    furthest = 0;
    await app.ask("motion.reset");
  }

  async function measure() {
    const now = performance.now();
    if (panel.hidden || motion()?.recorded || now - asked < ASK) return;
    asked = now;
    const state = await app.call("motion.state", { want: ["energy"] }).catch(() => null);
    const values = numbersOf(state?.energy);
    if (!state || !Object.keys(values).length) return;
    history.add(state.t, values);
    const names = [...history.values.keys()].join();
    const block = energyBlock(history);
    if (chart?.names === names) chart.update(block);
    else {
      chart = { ...liveChart(block), names };
      chartBox.replaceChildren(chart.figure);
    }
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
    const forces = store.frame.contacts
      .map((c) => ({ ...c, size: Math.hypot(...c.force) }))
      .sort((a, b) => b.size - a.size);
    const name = (i) => store.scene.bodies[i]?.name ?? "world";
    refill(
      contacts.querySelector("tbody"),
      forces
        .slice(0, ROWS)
        .map((c) => [
          `${name(c.a)} on ${name(c.b)}`,
          formatNumber(c.size, 2),
          formatNumber(c.friction, 2),
        ]),
    );
    measure();
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
    if (open?.speed)
      speed.set(
        SPEEDS.map((value) => ({ value, text: `${value} \u00d7` })),
        String(open.speed),
      );
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
    part("Contacts", contacts),
    part("Energy", chartBox),
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
    ),
    running,
  );
  store.on(["scene", "state", "tab"], state);
  store.on(["frame", "tab"], follow);
  store.on(["scene"], () => {
    if (store.scene?.mode === "motion") return;
    history.clear();
    furthest = 0;
  });
  app.togglePlay = toggle;
  app.stepTime = step;
  state();
  return panel;
}
