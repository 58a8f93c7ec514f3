// What the page knows of the server, and what is selected. Without the browser.

/// A store of named values: set(changes) tells every function that was given to on(names, work) with
/// one of the names that changed.
export function makeStore(values) {
  const listeners = [];
  const store = { ...values };
  store.set = (changes) => {
    const changed = Object.keys(changes).filter((name) => store[name] !== changes[name]);
    Object.assign(store, changes);
    for (const { names, work } of listeners)
      if (names.some((name) => changed.includes(name))) work(store);
  };
  store.on = (names, work) => listeners.push({ names, work });
  return store;
}

/// Whether a frame belongs to a scene: same revision, and as many of everything as the scene names.
export const fits = (scene, frame) =>
  frame.revision === scene.revision &&
  frame.bodies.length === 7 * scene.bodies.length &&
  frame.joints.length === scene.joints.length &&
  frame.tensions.length === scene.lines.length &&
  frame.arrows.length === 6 * scene.arrows.length &&
  frame.points.length === 3 * scene.lines.reduce((sum, { points }) => sum + points, 0);

/// What stands in the scene, each once, in order of appearance: { name, kind: "hand" | "object" |
/// "obstacle", movable, bodies: indices }.
export function ownersOf(scene) {
  const owners = new Map();
  scene.bodies.forEach(({ owner, role, movable }, index) => {
    const kind = role === "object" || role === "obstacle" ? role : "hand";
    if (!owners.has(owner)) owners.set(owner, { name: owner, kind, movable, bodies: [] });
    owners.get(owner).bodies.push(index);
  });
  return [...owners.values()];
}

/// Joints of one hand, or of all: { index, ...joint }.
export const jointsOf = (scene, hand) =>
  scene.joints
    .map((joint, index) => ({ index, ...joint }))
    .filter((joint) => hand === undefined || joint.hand === hand);

/// The joint that leads another, or the joint itself: what has to be set to move it.
export function leaderOf(scene, joint) {
  if (!joint.led_by) return joint;
  return scene.joints.find((one) => one.hand === joint.hand && one.name === joint.led_by) ?? joint;
}

/// The joint that a click on a body means: the last one of those that it carries, else of the bodies
/// before it of the same digit; -1 where there is none.
export function jointAtBody(scene, body) {
  const { owner, digit } = scene.bodies[body];
  for (let at = body; at >= 0; --at) {
    const other = scene.bodies[at];
    if (other.owner !== owner || other.digit !== digit) break;
    const found = scene.joints.findLastIndex((joint) => joint.body === at && !joint.led_by);
    if (found >= 0) return found;
  }
  return -1;
}

/// What a change of one joint is called, by what is open: { method, params } for the server, and null
/// where joints cannot be moved. Of a world it is a part of a gesture.
export function jointRequest(mode, joint, value, gesture) {
  const joints = { [joint.name]: value };
  if (mode === "world")
    return { method: "hand.set_joints", params: { hand: joint.hand, joints, gesture } };
  if (mode === "tendons") return { method: "tendons.set", params: { posture: joints } };
  if (mode === "motion") return { method: "motion.set", params: { targets: joints } };
  return null;
}

/// Whether both are of the same thing and gesture.
const belong = (a, b) => a.hand === b.hand && a.name === b.name && a.gesture === b.gesture;

/// The newer of two places of a thing in one gesture; null of others.
export const newerPlace = (waiting, next) => (belong(waiting, next) ? next : null);

/// Two requests of the same method, hand and gesture as one with the joints of both; null of others.
export function mergeJoints(waiting, next) {
  if (waiting.method !== next.method || !belong(waiting.params, next.params)) return null;
  const joined = { ...next.params };
  for (const name of ["joints", "posture", "targets", "tensions", "excitations"])
    if (waiting.params[name] || next.params[name])
      joined[name] = { ...waiting.params[name], ...next.params[name] };
  return { method: next.method, params: joined };
}
