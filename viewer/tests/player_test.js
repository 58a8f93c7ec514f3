// Tests for report/player.js and the film's button of report/save.js, on a page that has only what
// they need.

import assert from "node:assert/strict";
import test from "node:test";
import { playerOf } from "../report/player.js";
import { filmButton } from "../report/save.js";

/// An element of the page.
class Element {
  constructor(tag) {
    Object.assign(this, { tag, children: [], listeners: {} });
  }
  setAttribute(key, value) {
    this[key] = key === "checked" || key === "selected" ? true : value;
  }
  append(...children) {
    this.children.push(...children);
    if (this.tag === "select") this.value = this.children.find(({ selected }) => selected).value;
  }
  addEventListener(kind, call) {
    this.listeners[kind] = call;
  }
  tell(kind) {
    return this.listeners[kind]();
  }
  getContext = () => ({ fillRect() {}, drawImage: () => Element.draws() });
  captureStream = () => ({});
}

/// Records, or fails as a browser would.
class Recorder {
  listeners = {};
  state = "inactive";
  addEventListener(kind, call) {
    this.listeners[kind] = call;
  }
  start() {
    this.state = "recording";
  }
  stop() {
    this.state = "inactive";
    this.listeners.stop();
  }
}

let frames = [];
Element.draws = () => {};
globalThis.document = { createElement: (tag) => new Element(tag) };
globalThis.requestAnimationFrame = (step) => frames.push(step);
globalThis.MediaRecorder = Recorder;

/// Draws the picture of an instant of the clock [ms].
function frameAt(time) {
  const due = frames;
  frames = [];
  for (const step of due) step(time);
}

/// Lets promises go on.
const settle = () => new Promise((done) => setImmediate(done));

/// A player of 101 instants within 10 s, played as fast as they are, and its controls.
function player() {
  frames = [];
  const layers = Array.from({ length: 101 }, (_, i) => ({ group: {}, time: i / 10 }));
  const { element, film } = playerOf({ layers, draw() {}, paintNow() {} });
  const [button, slider, told, speed, label] = element.children;
  return { film, button, slider, told, speed, all: label.children[0] };
}

test("a motion plays in the time of the clock", () => {
  const { button, slider } = player();
  button.tell("click");
  [0, 1000, 2000].forEach(frameAt);
  assert.equal(slider.value, "20");
  button.tell("click");
  frameAt(3000);
  assert.equal(slider.value, "20");
  assert.equal(frames.length, 0);
});

test("a motion that is stopped and played within a picture does not go twice as fast", () => {
  const { button, slider } = player();
  button.tell("click");
  frameAt(0);
  button.tell("click");
  button.tell("click");
  [500, 1500].forEach(frameAt);
  assert.equal(slider.value, "10");
  assert.equal(frames.length, 1);
});

test("a film begins anew, at the speed of the clock, while a motion plays", async () => {
  const { film, button, slider } = player();
  button.tell("click");
  [0, 4000].forEach(frameAt);
  const saved = film({}, "#fff");
  [5000, 6000, 7000].forEach(frameAt);
  assert.equal(slider.value, "20");
  assert.equal(frames.length, 1);
  frameAt(20000);
  assert.equal((await saved).type, "video/webm");
});

test("nothing disturbs a film, and all can be used after it", async () => {
  const { film, ...controls } = player();
  const saved = film({}, "#fff");
  const disabled = () =>
    ["button", "slider", "speed", "all"].map((name) => controls[name].disabled);
  assert.deepEqual(disabled(), [true, true, true, true]);
  [0, 20000].forEach(frameAt);
  await saved;
  assert.deepEqual(disabled(), [false, false, false, false]);
  assert.equal(controls.button.textContent, "\u25b6 Play");
});

test("a film that fails, at its start or on its way, says so and leaves all usable", async () => {
  for (const picture of [0, 2]) {
    const { film, button } = player();
    let drawn = 0;
    Element.draws = () => {
      if (drawn++ === picture) throw new Error("the canvas is tainted");
    };
    const [save, told] = filmButton({ toMovie: () => film({}, "#fff") }, "motion");
    const ended = save.tell("click");
    assert.equal(save.disabled, true);
    [0, 1000, 2000].forEach(frameAt);
    await ended;
    Element.draws = () => {};
    assert.equal(told.textContent, "No film was saved: the canvas is tainted");
    assert.deepEqual([save.disabled, button.disabled, frames.length], [false, false, 0]);
  }
});

test("a recorder that breaks off fails the film", async () => {
  const made = [];
  globalThis.MediaRecorder = class extends Recorder {
    constructor() {
      super();
      made.push(this);
    }
  };
  const { film } = player();
  const saved = film({}, "#fff");
  frameAt(0);
  made[0].listeners.error({ error: new Error("no memory") });
  frameAt(20000);
  await assert.rejects(saved, /no memory/);
  await settle();
  globalThis.MediaRecorder = Recorder;
});
