// What panels and the picture compute without a browser.

import assert from "node:assert/strict";
import test from "node:test";
import { Group } from "three";
import { base64Of, droppedFiles, guessKind, saveAs } from "../live/files.js";
import { nameParts } from "../live/panels/motion_inputs.js";
import { groupOf } from "../live/panels/pose_panel.js";
import { accountFacts, doubts, makeEnergyChart, makeHistory } from "../live/panels/energy_chart.js";
import { sparse } from "../live/panels/live_chart.js";
import { matches } from "../live/panels/open_dialog.js";
import { qualityFacts } from "../live/panels/grasp_panel.js";
import { standsAtEnd } from "../live/panels/time_panel.js";
import { restFacts } from "../live/panels/tendon_panel.js";
import { keyed } from "../live/panels/controls.js";
import { QUANTITIES } from "../live/link/quantities.js";
import { floatsOf } from "../live/view/clouds.js";
import { arrowScale, leastForce, makeVectors } from "../live/view/contacts.js";
import { kindOf, scaleEnd } from "../live/view/lines.js";
import { looksOf } from "../live/view/looks.js";

test("a history goes on, forgets what is done again, and stays small", () => {
  const history = makeHistory();
  for (let i = 0; i < 10; ++i) history.add(i, { kinetic: i });
  history.add(5, { kinetic: -5 });
  const [{ x, y }] = history.series();
  assert.deepEqual(x, [0, 1, 2, 3, 4, 5]);
  assert.equal(y.at(-1), -5);
  for (let i = 6; i < 20000; ++i) history.add(i, { kinetic: i });
  const [{ x: times, y: values }] = history.series();
  assert.ok(times.length <= 1500 && times.length > 700, `${times.length} points`);
  assert.equal(times.length, values.length);
  assert.equal(times[0], 0);
  assert.equal(times.at(-1), 19999);
  assert.ok(times.every((t, i) => i === 0 || t > times[i - 1]));
});

test("samples beside a long gap are marked, those of a dense line are not", () => {
  const dense = Array.from({ length: 100 }, (_, i) => i / 100);
  const xs = [...dense, 1.5, 2];
  const all = xs.map(() => 1);
  // The first has no neighbour on its left; 0.99 is far from 1.5.
  assert.deepEqual(sparse(xs, all), [0, 99, 100, 101]);
  assert.deepEqual(sparse([0, 1, 2], [1, null, 2]), [0, 2]);
  assert.deepEqual(sparse([3], [1]), [0]);
  assert.deepEqual(sparse([], []), []);
});

test("energies are asked for at every frame that comes after the answer to the last", async () => {
  const waiting = [];
  const app = { call: () => new Promise((done) => waiting.push(done)) };
  globalThis.document ??= { createElement: () => ({ append() {}, replaceChildren() {}, setAttribute() {} }) };
  const chart = makeEnergyChart(app);
  const first = chart.follow();
  chart.follow();
  assert.equal(waiting.length, 1);
  waiting[0]({ t: 0, energy: {} });
  await first;
  chart.follow();
  assert.equal(waiting.length, 2);
});

test("a motion says how far it is to be believed", () => {
  const wrong = {
    energy_error: -0.05,
    energy_turned_over: 0.1,
    energy_balances: false,
    deepest: 0.002,
    limits_passed: [
      { joint: "knee", beyond_rad: Math.PI / 18 },
      { joint: "drawer", beyond_m: 0.04 },
    ],
    restitution_ignored: 0.8,
    steps: 10,
    unsolved: 0,
  };
  const told = Object.fromEntries(accountFacts(wrong));
  assert.equal(told["Energy error"], "50 mJ created, of 100 mJ turned over");
  assert.equal(told["Deepest overlap"], "2\u202fmm");
  assert.equal(told["Limits passed"], "knee by 10\u202f\u00b0, drawer by 40\u202fmm");
  assert.equal(told["Restitution ignored"], "up to 0.8");
  assert.match(doubts(wrong), /Energy does not balance/);
  const right = { energy_error: 1e-9, energy_turned_over: 0.1, energy_balances: true, deepest: 0 };
  assert.deepEqual(
    accountFacts({ ...right, limits_passed: [], restitution_ignored: 0 }).map(([name]) => name),
    ["Energy error", "Deepest overlap"],
  );
  assert.equal(doubts(right), "");
  // Of a run that recorded none of it nothing is told.
  assert.deepEqual(accountFacts({ energy_error: null, deepest: undefined }), []);
});

test("a history takes names that come later", () => {
  const history = makeHistory();
  history.add(0, { a: 1 });
  history.add(1, { a: 2, b: 3 });
  assert.deepEqual(
    history.series().map(({ name, y }) => [name, y]),
    [
      ["a", [1, 2]],
      ["b", [null, 3]],
    ],
  );
});

test("tensions are slack, unknown or taut, on a round scale", () => {
  assert.deepEqual([NaN, 0, 3].map(kindOf), ["unknown", "slack", "taut"]);
  assert.equal(scaleEnd(new Float32Array([NaN, 3, 17])), 20);
  assert.equal(scaleEnd(new Float32Array([NaN, 0])), 1);
  assert.equal(scaleEnd(new Float32Array([])), 1);
});

test("arrows are of a round scale that stays while it fits", () => {
  const scale = arrowScale(10, 1);
  assert.ok(10 * scale <= 0.3 + 1e-12 && 10 * scale > 0.1);
  assert.equal(arrowScale(9, 1, scale), scale);
  assert.ok(arrowScale(40, 1, scale) < scale);
  assert.ok(arrowScale(0.1, 1, scale) > scale);
  assert.equal(arrowScale(0, 1, scale), scale);
  assert.equal(arrowScale(0, 1), null);
});

test("what rounding leaves of a force is neither an arrow nor a number", () => {
  assert.equal(arrowScale(3.6e-12, 1, null, leastForce([10])), null);
  assert.equal(arrowScale(5e-6, 1, null, leastForce([10])), null);
  assert.ok(arrowScale(2e-5, 1, null, leastForce([NaN, 10, 3])) > 0);
  assert.equal(leastForce([]), 1e-6);
  const told = (state) => Object.fromEntries(restFacts({ rotation: [1, 0, 0, 0], ...state }));
  const muscles = [{ tension: 10 }];
  const none = told({ tip_force: [3.6e-12, 0, -1e-12], torques: { pip: -1.212e-13 }, muscles });
  assert.equal(none["Tip force"], "0.00\u202fN");
  assert.equal(none["along x, y, z"], "0.00, 0.00, 0.00 N");
  assert.equal(none["Torque pip"], "0 N mm");
  const some = told({ tip_force: [2e-8, 0, 0], torques: { pip: 2e-10 }, muscles });
  assert.notEqual(some["Tip force"], "0.00\u202fN");
  assert.equal(some["Torque pip"], "2e\u22127 N mm");
});

test("a digit's arrow of rounding is not drawn, nor its label", () => {
  const vectors = makeVectors(new Group());
  vectors.show({ arrows: [{ kind: "force", name: "tip force" }] });
  const tips = (force) =>
    vectors.pose({ arrows: new Float32Array([0, 0, 0, force, 0, 0]), tensions: [10] }, 1);
  assert.equal(tips(3.6e-12).length, 0);
  assert.ok(tips(5)[0].long > 0.1);
  assert.equal(tips(3.6e-12).length, 0);
});

test("force and moment of a disturbance are in proportion, over the object's radius", () => {
  const vectors = makeVectors(new Group());
  const arrows = ["force", "moment"].map((part) => ({
    kind: "disturbance",
    name: `worst disturbance: ${part}`,
  }));
  vectors.show({ arrows });
  // A force of 0.6 and a moment of 0.8 over 50 mm.
  const frame = { arrows: new Float32Array([0, 0, 0, 0.6, 0, 0, 0, 0, 0, 0, 0.04, 0]), tensions: [] };
  assert.equal(vectors.momentRadius(), null);
  vectors.radius(0.05);
  const [force, moment] = vectors.pose(frame, 0.3);
  assert.ok(Math.abs(moment.long / force.long - 0.8 / 0.6) < 1e-6);
  assert.ok(moment.long <= 0.09 + 1e-9 && moment.long > 0.03);
  assert.equal(vectors.momentRadius(), 0.05);
  frame.arrows.fill(0);
  assert.equal(vectors.pose(frame, 0.3).length, 0);
  assert.equal(vectors.momentRadius(), null);
  // Another scene has another object.
  vectors.show({ arrows });
  assert.equal(vectors.momentRadius(), null);
});

test("clouds are floats, six a segment", () => {
  const numbers = new Float32Array([1, 2, 3, 4, 5, 6]);
  const text = base64Of(new Uint8Array(numbers.buffer));
  assert.deepEqual([...floatsOf(text)], [1, 2, 3, 4, 5, 6]);
  assert.throws(() => floatsOf(btoa("abcd")), /24 bytes/);
});

test("large files are base64 as Node has it", () => {
  const bytes = Uint8Array.from({ length: 100003 }, (_, i) => (i * 7919) % 256);
  assert.equal(base64Of(bytes), Buffer.from(bytes).toString("base64"));
});

test("files of robots are hands, others objects", () => {
  assert.equal(guessKind(["a.stl", "b.URDF"]), "hand");
  assert.equal(guessKind(["a.obj", "a.mtl"]), "object");
});

test("a search finds entries that have all its words", () => {
  const entry = { name: "barrett_bobbin", kind: "world", about: "Barrett hand and a bobbin" };
  assert.ok(matches(entry, "BOBBIN hand"));
  assert.ok(matches(entry, ""));
  assert.ok(!matches(entry, "bobbin mug"));
});

test("keys on sliders: steps, tenths, pages, limits", () => {
  const limits = { lower: 0, upper: 1 };
  const { angle } = QUANTITIES;
  const key = (name, more = {}) => keyed({ key: name, ...more }, 0.5, limits, angle);
  assert.ok(Math.abs(key("ArrowRight") - 0.5 - Math.PI / 180) < 1e-12);
  assert.ok(Math.abs(key("ArrowLeft", { shiftKey: true }) - 0.5 + Math.PI / 1800) < 1e-12);
  assert.ok(Math.abs(key("PageUp") - 0.5 - Math.PI / 18) < 1e-12);
  assert.equal(key("Home"), 0);
  assert.equal(key("End"), 1);
  assert.equal(key("Tab"), null);
  assert.equal(key("ArrowRight", { ctrlKey: true }), null);
});

const factsOf = (quality) => Object.fromEntries(qualityFacts(quality));

test("a grasp that holds, and one that does not, are told apart in words", () => {
  const holds = factsOf({
    closed: true,
    force_closure: true,
    epsilon: { lower: 0.1, upper: 0.102 },
    volume: { lower: 0.25, upper: null },
  });
  assert.equal(holds["Volume [(N per N)\u2076]"], "at least 0.25 (certified)");
  assert.match(holds["Force closure"], /yes/);
  assert.equal(holds["Epsilon [N per N]"], "between 0.1 and 0.102 (certified)");
  const loose = factsOf({
    closed: true,
    force_closure: false,
    epsilon: { lower: 0, upper: 0 },
    missing_direction: [1, 0, 0, 0, 0, 0],
  });
  assert.match(loose["Force closure"], /unstable/);
  assert.equal(loose["Cannot resist"], "force along +x (the object's axes)");
  assert.deepEqual(qualityFacts({ closed: false, reason: "nothing touches" }), [
    ["Grasp", "nothing touches"],
  ]);
});

test("bodies look like what they are", () => {
  const body = (more) => ({ owner: "h", digit: "", role: "link", material: "steel", ...more });
  const scene = {
    lines: [],
    bodies: [
      body({ digit: "index" }),
      body({ digit: "middle" }),
      body({ digit: "index", material: "skin" }),
      body({ owner: "cup", role: "object" }),
    ],
  };
  const looks = looksOf(scene);
  assert.notEqual(looks[0].color, looks[1].color);
  assert.equal(looks[2].color, "#dfab8f");
  assert.deepEqual(
    looks.map(({ layer }) => layer),
    [null, null, null, "objects"],
  );
  // Skin that has bones inside can be seen through.
  scene.bodies.push(body({ role: "bone" }));
  assert.equal(looksOf(scene)[2].layer, "hands");
});

test("a file of others is replaced only where the reader says so", async () => {
  const there = "'x.toml' is there already and is not of this world: 'overwrite' replaces it";
  const saved = async (yes) => {
    const asked = [];
    const sent = [];
    const save = (_, params) => {
      sent.push(params);
      if (!params.overwrite) throw new Error(there);
      return { file: params.file };
    };
    const app = { call: save, ask: save, notices: { error: (text) => asked.push(text) } };
    const result = await saveAs(app, "x.toml", (question) => (asked.push(question), yes));
    return { result, asked, sent };
  };
  const question = "'x.toml' is there already and is not of this world.";
  const no = await saved(false);
  assert.deepEqual(no, { result: null, asked: [question], sent: [{ file: "x.toml" }] });
  const yes = await saved(true);
  assert.deepEqual(yes.sent.at(-1), { file: "x.toml", overwrite: true });
  assert.deepEqual(yes.result, { file: "x.toml" });
});

test("a scene stands at its end where it paused there, not while it plays or beside it", () => {
  const paused = { duration: 2, playing: false, recorded: false };
  assert.equal(standsAtEnd(paused, 2), true);
  // The last of 8000 steps of 0.25 ms, as they are summed up.
  assert.equal(standsAtEnd(paused, 8000 * 0.00025), true);
  for (const time of [0, 1.999, 2.001, NaN]) assert.equal(standsAtEnd(paused, time), false);
  assert.equal(standsAtEnd({ ...paused, playing: true }, 2), false);
  // The slider of a recorded run ends with it; worlds have no end.
  assert.equal(standsAtEnd({ ...paused, recorded: true }, 2), false);
  assert.equal(standsAtEnd({ ...paused, duration: null }, 0), false);
  assert.equal(standsAtEnd(null, 2), false);
});

/// What a browser gives for a file or a folder of a drop; a folder is read two entries at a time.
const fileEntry = (fullPath) => ({
  ...{ isFile: true, fullPath },
  file: (done) => done({ name: fullPath.split("/").at(-1) }),
});
const folderEntry = (fullPath, entries) => ({
  ...{ isFile: false, fullPath },
  createReader: () => {
    let at = 0;
    return { readEntries: (done) => done(entries.slice(at, (at += 2))) };
  },
});

test("a folder that is dropped brings the files below it, with their paths", async () => {
  const meshes = ["a", "b", "c"].map((name) => fileEntry(`/hand/meshes/${name}.stl`));
  const folder = folderEntry("/hand", [
    fileEntry("/hand/hand.urdf"),
    folderEntry("/hand/meshes", meshes),
  ]);
  const items = [{ webkitGetAsEntry: () => folder }];
  const found = await droppedFiles({ items, files: [] });
  assert.deepEqual(
    found.map(({ path }) => path),
    ["hand/hand.urdf", "hand/meshes/a.stl", "hand/meshes/b.stl", "hand/meshes/c.stl"],
  );
  assert.equal(found[3].file.name, "c.stl");
});

test("files without entries keep their names", async () => {
  const found = await droppedFiles({ items: [], files: [{ name: "wedge.obj" }] });
  assert.deepEqual(found, [{ path: "wedge.obj", file: { name: "wedge.obj" } }]);
});

test("joints stand under their finger: by their name, else by the digit that they move", () => {
  const bodies = [{ digit: "index" }, { digit: "" }];
  assert.equal(groupOf({ name: "barrett/finger 1/L2", body: 0 }, bodies), "barrett finger 1");
  assert.equal(groupOf({ name: "MCP2_FE", body: 0 }, bodies), "index");
  assert.equal(groupOf({ name: "slide", body: 1 }, bodies), "");
});

test("inputs of a motion are told apart by their last word, under what is before it", () => {
  assert.deepEqual(nameParts("human:skewed/index/FDP2"), { group: "human:skewed index", short: "FDP2" });
  assert.deepEqual(nameParts("pivot"), { group: "", short: "pivot" });
});
