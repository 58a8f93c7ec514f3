// Grasp panel: opening and closing a hand, contacts, quality.

import { el } from "../../report/dom.js";
import { formatNumber } from "../../numbers/format.js";
import { rotatedWrench, rotationOf, wrenchWords } from "../link/directions.js";
import { ownersOf } from "../link/store.js";
import { whenQuiet } from "../link/latest.js";
import { choice, facts, part, slowButton, tick, warnings } from "./controls.js";
import { makePadPart } from "./pad_part.js";
import { makeWrenchView } from "./wrench_view.js";

const QUIET = 350; // after the last move the quality is asked for [ms]

/// A wrench of the object's frame in words: in the picture's frame, where the object's rotation is known.
const directionWords = (wrench, rotation) =>
  rotation
    ? wrenchWords(rotatedWrench(wrench, rotation))
    : `${wrenchWords(wrench)} (the object's axes)`;

/// The bounds between which a number is certified to lie; there may be none above.
const certified = ({ lower, upper }) =>
  Number.isFinite(upper)
    ? `between ${formatNumber(lower)} and ${formatNumber(upper)} (certified)`
    : `at least ${formatNumber(lower)} (certified)`;

/// The lines that tell a quality as the server gives it; `rotation` of the object in the picture.
export function qualityFacts(quality, rotation = null) {
  const { closed, epsilon, volume } = quality;
  if (!closed || !epsilon)
    return [["Grasp", quality.reason ?? quality.verdict ?? "nothing is held"]];
  const told = [
    ["Force closure", quality.force_closure ? "\u2713 yes" : "\u2717 no: the grasp is unstable"],
    ["Epsilon [N per N]", certified(epsilon)],
  ];
  if (quality.missing_direction)
    told.push(["Cannot resist", directionWords(quality.missing_direction, rotation)]);
  if (quality.worst_wrench)
    told.push(["Worst disturbance", directionWords(quality.worst_wrench, rotation)]);
  if (volume) told.push(["Volume [(N per N)\u2076]", certified(volume)]);
  if (quality.contacts !== undefined) told.push(["Contacts", String(quality.contacts)]);
  return told;
}

/// Describes the result of a closing in a sentence.
export function outcomeWords({ outcome, explanation, stopped = [] }) {
  const by = stopped.map(({ joint, by: what }) => `${joint}: ${what}`);
  return [explanation || outcome, by.length ? `Joints stopped by: ${by.join(", ")}` : ""]
    .filter(Boolean)
    .join("\n");
}

const DEEDS = {
  Open: "hand.open",
  Approach: "hand.approach",
  Close: "hand.close",
  "Auto-grasp": "hand.grasp",
};

/// Buttons that move the hand; `doing(method)` gives what each does.
const deedButtons = (doing) =>
  Object.entries(DEEDS).map(([words, method]) =>
    slowButton(words, doing(method), {
      id: method.replace("hand.", "do-"),
      class: method === "hand.grasp" ? "main" : null,
    }),
  );

/// The hand and the object that a grasp is of: { hand, object, named(), fill(owners) }, where choices of one
/// are hidden.
function makeChoices(changed) {
  const hand = choice("Hand", changed);
  const object = choice("Object", changed);
  const named = () => ({
    ...(hand.value() ? { hand: hand.value() } : {}),
    ...(object.value() ? { object: object.value() } : {}),
  });
  const fill = (owners) => {
    for (const [kind, row] of Object.entries({ hand, object })) {
      const names = owners.filter((one) => one.kind === kind).map(({ name }) => name);
      row.set(names);
      row.hidden = names.length < 2;
    }
  };
  return { hand, object, named, fill };
}

/// Quality of the grasp: { element, ask(), soon() }, requested again when all motion has stopped;
/// `of` has named() and possible().
function makeQuality(app, of) {
  const { store } = app;
  const answer = el("div", { class: "quality", role: "status", id: "quality" });
  const volume = tick("volume too (slower)", false, () => ask());
  const always = tick("follow every move", true, () => ask());
  const page = () => element.closest(".page");
  let about = "";

  const objectBody = (name) => store.scene.bodies.findIndex(({ owner }) => owner === name);
  /// Poses of all things without the arrows, which the quality itself changes.
  const poses = () => (store.frame ? `${store.frame.revision} ${store.frame.bodies.join()}` : "");
  async function ask() {
    if (!of.possible()) return answer.replaceChildren();
    about = poses();
    if (!store.frame?.contacts.length && !volume.box.checked) {
      page().quality = null;
      return answer.replaceChildren(el("p", { class: "hint" }, "Nothing touches the object."));
    }
    const asked = about;
    const quality = await app.ask("grasp.quality", { ...of.named(), volume: volume.box.checked });
    if (!quality || asked !== about) return;
    page().quality = quality;
    // The arrows were drawn when the frame came, without the length that moments are divided by.
    app.picture.vectors.radius(quality.torque_scale);
    if (store.frame) app.picture.pose(store.frame);
    answer.classList.toggle("holds", Boolean(quality.force_closure));
    const turn = rotationOf(store.frame, objectBody(quality.object));
    answer.replaceChildren(facts(qualityFacts(quality, turn)), ...warnings(quality.warnings));
  }
  const soon = whenQuiet(() => {
    if (!page().hidden && always.box.checked && poses() !== about) ask();
  }, QUIET);
  const element = part(
    "Quality",
    answer,
    el("div", { class: "ticks" }, always, volume),
    el("div", { class: "buttons" }, slowButton("Find the quality", ask, { id: "ask-quality" })),
  );
  return { element, ask, soon };
}

export function makeGraspPanel(app) {
  const { store } = app;
  const choices = makeChoices(() => quality.ask());
  const { hand, object, named } = choices;
  const outcome = el("p", { class: "outcome", role: "status" });
  const inWorld = () => store.scene?.mode === "world";
  const quality = makeQuality(app, {
    named,
    possible: () => inWorld() && hand.value() && object.value() && app.link.connected(),
  });
  const buttons = deedButtons((method) => async () => {
    const did = await app.ask(method, named());
    if (!did) return;
    outcome.textContent = outcomeWords(did);
    if (outcome.textContent) app.notices.say(outcome.textContent);
    await quality.ask();
  });
  const panel = el(
    "div",
    { class: "page grasp" },
    hand,
    object,
    el("div", { class: "buttons" }, ...buttons),
    outcome,
    quality.element,
    makeWrenchView(app, named),
    makePadPart(app, named),
  );
  const fill = () => {
    choices.fill(store.scene ? ownersOf(store.scene) : []);
    const off = !hand.value() || !object.value() || !inWorld();
    buttons.forEach((one, i) => (one.disabled = i === 0 ? !hand.value() : off));
    quality.soon();
  };
  store.on(["scene"], fill);
  store.on(["frame", "tab"], quality.soon);
  fill();
  return panel;
}
