// The app: state of the page, requests to the server, and distribution of its messages.

import { Vector3 } from "three";
import { onThemeChange, themeColor } from "../report/theme.js";
import * as exports from "./exports.js";
import { saveWorld, takeFiles } from "./files.js";
import { decodeFrame } from "./link/frame.js";
import { latestWins } from "./link/latest.js";
import { rpcClient } from "./link/rpc_client.js";
import * as links from "./link/store.js";
import { ask as askReader } from "./panels/dialogs.js";
import { makeLegend } from "./panels/legend.js";
import { makeNotices } from "./panels/notices.js";
import { jointWords } from "./panels/pose_panel.js";
import { coveredBoxes } from "./view/covered.js";
import { makePicture } from "./view/picture.js";

/// Colours of labels on the picture; cached, because reading them forces a layout.
function themeColors() {
  let kept = null;
  const theme = () =>
    (kept ??= {
      ink: themeColor("--ink"),
      page: themeColor("--page"),
      muted: themeColor("--muted"),
    });
  theme.forget = () => (kept = null);
  return theme;
}

// Methods whose warnings no panel shows.
const TELLING = /^(world\.|motion\.open|motion\.record|hand\.|fit\.open)/;

/// Returns the address of the server's WebSocket, with the token of the page's address.
function socketAddress() {
  const { protocol, host, search } = location;
  return `${protocol === "https:" ? "wss:" : "ws:"}//${host}/ws${search}`;
}

/// Sends requests, and shows their errors to the user.
function addRequests(app) {
  app.call = (method, params) => app.link.call(method, params);
  app.ask = async (method, params = {}) => {
    try {
      const result = await app.call(method, params);
      if (TELLING.test(method) && result?.warnings?.length)
        app.notices.tell(result.warnings.join("\n"));
      return result;
    } catch (error) {
      // The banner reports a lost connection.
      if (error.code !== "lost") app.notices.error(`${method}: ${error.message}`);
      return null;
    }
  };
  app.mayLeave = async () =>
    !app.store.state?.world?.unsaved ||
    askReader("The world has changes that are not saved.", "Go on without them");
  app.newWorld = async () => (await app.mayLeave()) && app.ask("world.new");
  app.save = () => saveWorld(app);
}

/// Names of gestures: of all moves until the pointer, or else the key, is let go. Tools that set a slider without
/// either tell of a change at its end.
function addGestures(app) {
  const page = Math.random().toString(36).slice(2); // tells pages of one session apart
  let count = 0;
  const held = { pointers: new Set(), keys: new Set() };
  const end = () => (count += 1);
  app.gesture = () => `${page} ${count}`;
  addEventListener("pointerdown", ({ pointerId }) => held.pointers.add(pointerId), true);
  addEventListener("keydown", ({ code }) => held.keys.add(code), true);
  for (const kind of ["pointerup", "pointercancel"])
    addEventListener(kind, ({ pointerId }) => {
      held.pointers.delete(pointerId);
      end();
    });
  addEventListener("keyup", ({ code }) => {
    held.keys.delete(code);
    if (held.pointers.size === 0) end();
  });
  addEventListener("blur", () => {
    held.pointers.clear();
    held.keys.clear();
    end();
  });
  addEventListener("change", () => held.pointers.size + held.keys.size === 0 && end());
}

/// Adds the functions that move joints and things.
function addMoves(app) {
  const { store } = app;
  const sendJoints = latestWins(({ method, params }) => app.ask(method, params), links.mergeJoints);
  app.canMove = () => links.jointRequest(store.scene?.mode, {}, 0) !== null;
  app.moveJoint = (joint, value) => {
    const request = links.jointRequest(store.scene.mode, joint, value, app.gesture());
    if (!request) return null;
    app.wanted = { joint, value };
    app.notices.say(jointWords(store.scene, joint, value));
    return sendJoints(request).finally(() => {
      if (app.wanted?.joint === joint && app.wanted.value === value) app.wanted = null;
    });
  };
  const sendPlace = latestWins((params) => app.ask("world.place", params), links.newerPlace);
  app.moveSelected = ({ position, rotation }) =>
    store.selected &&
    sendPlace({ name: store.selected.owner, position, rotation, gesture: app.gesture() });
  app.poseOf = (owner) => {
    const at = store.scene?.bodies.findIndex((body) => body.owner === owner) ?? -1;
    return at < 0 || !store.frame ? null : [...store.frame.bodies.subarray(7 * at, 7 * at + 3)];
  };
}

/// The pose that world.place would have to name to leave a thing where it is.
async function placeOf(app, name) {
  const world = await app.ask("world.get");
  return (
    [...(world?.hands ?? []), ...(world?.bodies ?? [])].find((one) => one.name === name) ?? null
  );
}

/// Selection: a thing of the world, or a joint of a hand.
function addSelection(app) {
  const { store } = app;
  app.select = async (wanted, { quiet = false } = {}) => {
    const { scene, frame } = store;
    const known = wanted && scene?.bodies.some(({ owner }) => owner === wanted.owner);
    const joint = scene?.joints.find(
      (one) => one.hand === wanted?.owner && one.name === wanted.joint,
    );
    const next = known || joint ? { owner: wanted.owner, joint: joint?.name } : null;
    if (JSON.stringify(next) === JSON.stringify(store.selected)) return;
    app.picture.bodies.select(next?.owner ?? null);
    const value = joint && frame ? frame.joints[scene.joints.indexOf(joint)] : 0;
    app.picture.joint.show(joint ?? null, joint && app.picture.bodies.groups[joint.body], value);
    app.picture.place.hide();
    store.set({ selected: next });
    if (!next) return app.notices.say("nothing is selected");
    if (!quiet) app.notices.say(`${next.joint ?? next.owner} selected`);
    if (joint || scene.mode !== "world") return;
    const bodies = links.ownersOf(scene).find(({ name }) => name === next.owner);
    if (!bodies.movable) return;
    const pose = await placeOf(app, next.owner);
    if (pose && store.selected === next)
      app.picture.place.show(pose, app.picture.bodies.groups[bodies.bodies[0]]);
  };
  app.clicked = (body) => {
    if (body < 0) return app.select(null);
    const { scene } = store;
    const joint = scene.joints[links.jointAtBody(scene, body)];
    const { owner } = scene.bodies[body];
    // A second click on what is selected takes the whole hand.
    const again = joint && store.selected?.joint === joint.name && store.selected.owner === owner;
    return app.select({ owner, joint: again ? undefined : joint?.name });
  };
  app.hide = (owner, hidden) => {
    app.picture.bodies.hide(owner, hidden);
    store.set({ hidden: {} });
    app.picture.stage.draw();
  };
}

/// Adds the settings of what the picture shows.
function addView(app) {
  const { picture } = app;
  const { stage } = picture;
  const again = () => {
    if (picture.frame()) picture.pose(picture.frame());
    stage.draw();
  };
  app.view = {
    opacity: (layer, value) => {
      picture.bodies.opacity(layer, value);
      stage.draw();
    },
    grid: (on) => {
      stage.shown.grid = on;
      stage.grid.visible = on;
      stage.draw();
    },
    shadows: (on) => {
      stage.shown.shadows = on;
      stage.draw();
    },
    names: (on) => {
      app.names = on;
      stage.draw();
    },
    contacts: (what, on) => {
      picture.contacts.show[what] = on;
      again();
    },
    lines: (on) => {
      picture.lines.visible(on);
      stage.draw();
    },
    vectors: (on) => {
      picture.vectors.visible(on);
      again(); // words go with their arrows
    },
    fit: () => {
      stage.look(picture.bodies.box());
      stage.fit();
    },
  };
  stage.labels = () => labelsOf(app);
  stage.covered = () => coveredBoxes(stage, app.legend.box());
}

/// Labels of arrows, and names of bodies if they are switched on.
function labelsOf(app) {
  const { scene } = app.store;
  if (!scene) return [];
  const arrows = app.picture
    .tips()
    .filter(({ i }) => scene.arrows[i].kind !== "axis")
    .map(({ position, i }) => ({ position, text: scene.arrows[i].name }));
  const bodies = !app.names
    ? []
    : app.picture.bodies.meshes().map((mesh) => ({
        position: new Vector3().setFromMatrixPosition(mesh.parent.matrixWorld),
        text: scene.bodies[mesh.userData.body].name,
      }));
  return [...arrows, ...bodies];
}

/// Messages of the server into the store and the picture. Frames that come faster than pictures are skipped.
function addHearing(app) {
  const { store } = app;
  let latest = null;
  const take = () => {
    const frame = latest;
    latest = null;
    app.picture.stage.draw();
    if (frame && app.picture.pose(frame)) {
      // Drawn in this frame of the screen, before panels follow.
      if (!app.picture.stage.isHeld()) app.picture.stage.paintNow();
      store.set({ frame });
      if (!app.firstFrame && !app.picture.fitting()) markFirst(app);
    }
  };
  app.heardFrame = (buffer) => {
    const waiting = latest !== null;
    latest = decodeFrame(buffer);
    app.frameAt = performance.now();
    app.picture.stage.expecting = true;
    if (!waiting) requestAnimationFrame(take);
  };
  const scene = (params) => {
    const kept = store.selected;
    const ready = app.picture.show(params);
    store.set({ scene: params, frame: null });
    if (kept && !params.bodies.some(({ owner }) => owner === kept.owner)) app.select(null);
    else if (kept) {
      store.selected = null;
      app.select(kept, { quiet: true });
    }
    const nothing = params.bodies.length === 0;
    ready.then(() => (app.picture.frame() || nothing) && !app.firstFrame && markFirst(app));
  };
  const state = (params) => {
    store.set({ state: params });
    app.notices.busy(params.busy ?? null);
  };
  const heard = {
    scene,
    state,
    progress: app.notices.progress,
    ended: ({ reason }) => app.notices.error(`thenar ended: ${reason ?? "no reason was given"}`),
    failed: ({ text }) => app.notices.error(text),
    error: ({ message }) => app.notices.error(message ?? "an error without words"),
  };
  app.heardNotice = (method, params) => heard[method]?.(params);
}

function markFirst(app) {
  app.firstFrame = true;
  requestAnimationFrame(() => {
    const { paints } = app.picture.stage;
    performance.mark("thenar first picture", { detail: { paints } });
  });
}

function addExports(app) {
  const name = () => app.store.state?.world?.name || "thenar";
  let endFilm = null;
  app.savePicture = () => exports.savePng(app.picture, name());
  app.saveGltf = () => exports.saveGltf(app.ask, name());
  app.saveCharts = () => {
    if (!exports.saveCharts())
      app.notices.tell("No chart is shown: plot a sweep, or let time pass.");
  };
  /// Starts or stops a recording. Returns a promise of true while recording.
  app.film = async () => {
    if (endFilm) {
      const end = endFilm;
      endFilm = null;
      await end(name());
      return false;
    }
    endFilm = exports.startFilm(app.picture);
    return true;
  };
  addEventListener("beforeprint", () => {
    document.querySelector(".printed")?.remove();
    const picture = app.picture.stage.picture();
    picture.className = "printed";
    document.body.append(picture);
  });
  addEventListener("afterprint", () => document.querySelector(".printed")?.remove());
}

/// Makes the app in `root`, whose part `view` takes the picture; connects.
export function makeApp(root, view) {
  const app = {
    store: links.makeStore({
      link: false,
      scene: null,
      frame: null,
      state: null,
      selected: null,
      hidden: {},
      tab: "pose",
    }),
    names: false,
    wanted: null,
  };
  // Connects at once: nothing is heard before the page is laid out.
  app.link = rpcClient(socketAddress(), {
    frame: (buffer) => app.heardFrame(buffer),
    notice: (method, params) => app.heardNotice(method, params),
    link: (link) => {
      app.notices.link(link);
      if (!link.connected) app.notices.busy(null);
      if (!link.connected) app.picture.stage.hold(false); // nothing comes
      app.store.set({ link: link.connected });
    },
  });
  app.notices = makeNotices(root, () => app.ask("session.stop"));
  app.legend = makeLegend();
  root.append(app.legend);
  const theme = themeColors();
  app.picture = makePicture(view, theme, {
    moveJoint: (joint, value) => app.moveJoint(joint, value),
    place: (pose) => app.moveSelected(pose),
    select: (body) => app.clicked(body),
    failed: (error) => app.notices.error(error.message),
    changed: (what) => app.legend.show(what),
  });
  const parts = [addRequests, addGestures, addMoves, addSelection, addView, addHearing, addExports];
  for (const add of parts) add(app);
  app.importFiles = takeFiles(app);
  onThemeChange(() => {
    theme.forget();
    app.picture.stage.draw();
    document.querySelectorAll(".chart").forEach((frame) => frame.redraw?.());
  });
  return app;
}
