// The connection, requests that follow a hand, and the store, without a browser.

import assert from "node:assert/strict";
import test from "node:test";
import { latestWins, whenQuiet } from "../live/link/latest.js";
import { rpcClient } from "../live/link/rpc_client.js";
import * as store from "../live/link/store.js";

/// A client on sockets that the test plays itself.
function played() {
  const sockets = [];
  const timers = [];
  const heard = { frames: [], notices: [], links: [] };
  const client = rpcClient(
    "ws://test",
    {
      frame: (data) => heard.frames.push(data),
      notice: (method, params) => heard.notices.push([method, params]),
      link: (state) => heard.links.push(state),
    },
    {
      openSocket: () => {
        const socket = { sent: [], send: (text) => socket.sent.push(JSON.parse(text)) };
        socket.close = () => socket.onclose();
        sockets.push(socket);
        return socket;
      },
      later: (work, ms) => timers.push({ work, ms }),
    },
  );
  const say = (message) => sockets.at(-1).onmessage({ data: JSON.stringify(message) });
  return { client, sockets, timers, heard, say };
}

test("answers find their requests in any order, errors reject", async () => {
  const { client, sockets, say } = played();
  sockets[0].onopen();
  const first = client.call("a", { x: 1 });
  const second = client.call("b");
  const third = client.call("c");
  const [a, b, c] = sockets[0].sent;
  assert.deepEqual([a.method, a.params, b.params], ["a", { x: 1 }, {}]);
  say({ jsonrpc: "2.0", id: b.id, result: 2 });
  say({ jsonrpc: "2.0", id: c.id, error: { code: -32000, message: "no" } });
  say({ jsonrpc: "2.0", id: a.id, result: 1 });
  assert.equal(await first, 1);
  assert.equal(await second, 2);
  await assert.rejects(third, (error) => error.code === -32000 && error.message === "no");
  assert.deepEqual(client.waiting(), []);
});

test("a lost connection fails what is in flight, waits longer each time, and comes back", async () => {
  const { client, sockets, timers, heard } = played();
  sockets[0].onopen();
  const call = client.call("slow");
  sockets[0].onclose();
  await assert.rejects(call, (error) => error.code === "lost" && /slow/.test(error.message));
  assert.deepEqual(heard.links.at(-1), { connected: false, wait: 250, lost: ["slow"] });
  await assert.rejects(client.call("x"), /not connected/);
  timers.shift().work();
  sockets[1].onclose();
  timers.shift().work();
  sockets[2].onclose();
  assert.deepEqual(
    heard.links.filter(({ connected }) => !connected).map(({ wait }) => wait),
    [250, 500, 1000],
  );
  timers.shift().work();
  sockets[3].onopen();
  assert.ok(client.connected());
  sockets[3].onclose();
  assert.equal(heard.links.at(-1).wait, 250);
});

test("a connection that the page closed stays closed", () => {
  const { client, sockets, timers } = played();
  sockets[0].onopen();
  client.close();
  assert.equal(timers.length, 0);
});

test("notifications and frames reach whoever listens", () => {
  const { heard, sockets, say } = played();
  sockets[0].onopen();
  say({ jsonrpc: "2.0", method: "state", params: { mode: "world" } });
  sockets[0].onmessage({ data: new ArrayBuffer(4) });
  assert.deepEqual(heard.notices, [["state", { mode: "world" }]]);
  assert.equal(heard.frames.length, 1);
});

test("one request is in flight, and the latest waits", async () => {
  const sent = [];
  const push = latestWins(
    (value) => new Promise((resolve, reject) => sent.push({ value, resolve, reject })),
  );
  const first = push(1);
  const second = push(2);
  const third = push(3);
  assert.deepEqual(
    sent.map(({ value }) => value),
    [1],
  );
  sent[0].resolve("one");
  assert.equal(await first, "one");
  await new Promise(setImmediate);
  assert.deepEqual(
    sent.map(({ value }) => value),
    [1, 3],
  );
  sent[1].reject(new Error("no"));
  await assert.rejects(second, /no/);
  await assert.rejects(third, /no/);
  const after = push(4);
  await new Promise(setImmediate);
  sent[2].resolve("four");
  assert.equal(await after, "four");
});

test("what does not belong to the value that waits goes behind it", async () => {
  const sent = [];
  const push = latestWins(
    async (value) => void sent.push(value),
    (waiting, next) => (waiting[0] === next[0] ? next : null),
  );
  await Promise.all(["a1", "a2", "a3", "b1", "b2", "a4"].map(push));
  assert.deepEqual(sent, ["a1", "a3", "b2", "a4"]);
});

test("work waits until all is quiet", () => {
  const timers = new Map();
  let next = 0;
  let done = 0;
  const poke = whenQuiet(
    () => ++done,
    100,
    (work) => (timers.set(++next, work), next),
    (id) => timers.delete(id),
  );
  poke();
  poke();
  assert.equal(timers.size, 1);
  [...timers.values()][0]();
  assert.equal(done, 1);
});

const SCENE = {
  revision: 3,
  bodies: [
    { name: "h/palm", owner: "h", digit: "", role: "link", movable: true },
    { name: "h/i1", owner: "h", digit: "index", role: "link", movable: true },
    { name: "h/i2", owner: "h", digit: "index", role: "link", movable: true },
    { name: "h/i2 nail", owner: "h", digit: "index", role: "nail", movable: true },
    { name: "cup", owner: "cup", digit: "", role: "object", movable: true },
    { name: "table", owner: "table", digit: "", role: "obstacle", movable: false },
  ],
  joints: [
    { name: "i1", hand: "h", body: 1, led_by: "" },
    { name: "i2", hand: "h", body: 2, led_by: "i1" },
  ],
  lines: [{ points: 2 }, { points: 3 }],
  arrows: [{ name: "f", kind: "force" }],
};

test("owners and joints of a scene", () => {
  assert.deepEqual(
    store.ownersOf(SCENE).map(({ name, kind, bodies }) => [name, kind, bodies.length]),
    [
      ["h", "hand", 4],
      ["cup", "object", 1],
      ["table", "obstacle", 1],
    ],
  );
  // The last segment's own joint is led by another: the one before it can be moved.
  assert.equal(store.jointAtBody(SCENE, 3), 0);
  assert.equal(store.jointAtBody(SCENE, 4), -1);
  assert.equal(store.leaderOf(SCENE, SCENE.joints[1]).name, "i1");
});

test("a frame of another revision or shape does not fit", () => {
  const frame = {
    revision: 3,
    bodies: new Float32Array(42),
    joints: new Float32Array(2),
    tensions: new Float32Array(2),
    arrows: new Float32Array(6),
    points: new Float32Array(15),
  };
  assert.ok(store.fits(SCENE, frame));
  assert.ok(!store.fits(SCENE, { ...frame, revision: 2 }));
  assert.ok(!store.fits(SCENE, { ...frame, points: new Float32Array(12) }));
});

test("joints that wait are joined, but not those of two hands", () => {
  const one = store.jointRequest("world", { name: "a", hand: "h" }, 1, "first");
  const two = store.jointRequest("world", { name: "b", hand: "h" }, 2, "first");
  const other = store.jointRequest("world", { name: "b", hand: "g" }, 2, "first");
  const later = store.jointRequest("world", { name: "b", hand: "h" }, 2, "second");
  const joints = { a: 1, b: 2 };
  assert.deepEqual(store.mergeJoints(one, two).params, { hand: "h", joints, gesture: "first" });
  assert.equal(store.mergeJoints(one, other), null);
  assert.equal(store.mergeJoints(one, later), null);
  assert.equal(store.jointRequest("fit", { name: "a" }, 1), null);
  assert.deepEqual(store.jointRequest("tendons", { name: "a" }, 1).params, { posture: { a: 1 } });
});

test("a store tells of what changed, and of nothing else", () => {
  const s = store.makeStore({ a: 1, b: 2 });
  let told = 0;
  s.on(["a"], () => ++told);
  s.set({ b: 3 });
  s.set({ a: 1 });
  assert.equal(told, 0);
  s.set({ a: 2, b: 4 });
  assert.equal(told, 1);
});
