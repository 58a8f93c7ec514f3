// The whole picture of a scene and its frames: bodies, lines, contacts, arrows, clouds, handles.

import { Box3, Vector3 } from "three";
import { fits } from "../link/store.js";
import { makeBodies, meshShelf } from "./bodies.js";
import { makeClouds } from "./clouds.js";
import { makeContacts, makeVectors } from "./contacts.js";
import { makeJointHandle } from "./joint_handle.js";
import { makeLines } from "./lines.js";
import { makePads } from "./pads.js";
import { makePlaceHandle } from "./place_handle.js";
import { usePointer } from "./pointer.js";
import { makeStage } from "./stage.js";

/// Returns true if the scene shows different things, so that the camera must be fitted again.
const another = (before, next) =>
  !before ||
  before.mode !== next.mode ||
  before.bodies.length === 0 ||
  !next.bodies.some(({ owner }) => before.bodies.some((body) => body.owner === owner));

const FARTHEST = 4; // sizes of what is seen at first: what flies farther away is let go

/// A box and what lies around it. @param share  of its size
const roomAround = (box, share) =>
  box.clone().expandByScalar(share * box.getSize(new Vector3()).length());

/// Returns the initial viewing direction of a scene.
const directionOf = ({ eye, target }) => new Vector3(...eye).sub(new Vector3(...target));

/// Fetches a mesh by its id, with the token of the page's address.
async function fetchMesh(id) {
  const answer = await fetch(`/mesh/${id}${location.search}`);
  if (!answer.ok) throw new Error(`mesh ${id}: ${answer.status} ${answer.statusText}`);
  return answer.arrayBuffer();
}

/// `asked` has functions moveJoint(joint, value), place(pose), select(body), failed(error),
/// changed({ tensionEnd, forceScale, momentRadius }).
/// Returns the picture: stage, show(scene), pose(frame), and its parts.
export function makePicture(container, theme, asked) {
  const stage = makeStage(container, theme);
  const shelf = meshShelf(fetchMesh);
  const bodies = makeBodies(stage.scene, shelf, stage.draw);
  const lines = makeLines(stage.scene);
  const contacts = makeContacts(stage.scene);
  const vectors = makeVectors(stage.scene);
  const clouds = makeClouds(stage.scene);
  const pads = makePads(stage.scene, stage.draw);
  const joint = makeJointHandle(stage, asked.moveJoint);
  const place = makePlaceHandle(stage, asked.place);
  const pointer = usePointer(stage, bodies, { joint, place }, asked.select);
  stage.preparing.push((fine) => bodies.prepare(fine, stage.camera));
  stage.preparing.push(() => lines.sharpen(stage.canvas.width / stage.width));
  stage.warm(bodies.samples);
  stage.warm(stage.grid);
  let scene = null;
  let frame = null;
  let fitting = false; // until meshes and a frame are there
  let complete = false; // whether all meshes are
  let tips = [];
  let room = new Box3(); // of a motion, that is seen

  const size = () => stage.box.getSize(new Vector3()).length() || 1;

  function settle() {
    if (!frame || !complete) return;
    stage.hold(false);
    stage.look(bodies.box());
    if (fitting) stage.fit(directionOf(scene));
    if (fitting) room = roomAround(stage.box, 0.03);
    fitting = false;
    draw(frame);
  }

  /// Steps back from a motion that leaves the picture, as long as nobody has moved the camera.
  function stepBack() {
    if (scene.mode !== "motion" || !complete || !stage.isFitted()) return;
    const box = bodies.box();
    if (room.containsBox(box) || !roomAround(stage.box, FARTHEST).containsBox(box)) return;
    room.union(roomAround(box, 0.15));
    stage.fit(stage.from, room);
  }

  function draw(next) {
    // Pads are of the posture in which they were pressed.
    if (frame && next.bodies.some((value, i) => value !== frame.bodies[i])) pads.clear();
    frame = next;
    bodies.pose(frame);
    place.goAlong();
    stepBack();
    const tensionEnd = lines.pose(frame);
    const { forceScale } = contacts.pose(frame, size());
    tips = vectors.pose(frame, size());
    const { held } = joint;
    if (held()) joint.tell(frame.joints[scene.joints.indexOf(held().joint)]);
    asked.changed({ tensionEnd, forceScale, momentRadius: vectors.momentRadius() });
    stage.draw();
  }

  const show = (next) => {
    fitting ||= another(scene, next);
    if (fitting) contacts.forget();
    const held = joint.held()?.joint;
    scene = next;
    frame = null;
    tips = []; // arrows of the scene before, which the new one does not name
    complete = false;
    // The camera is led to all of it at once.
    stage.hold(fitting && scene.bodies.length > 0);
    const ready = bodies.show(scene).then(() => {
      complete = scene === next;
    });
    lines.show(scene);
    if (stage.isHeld() && lines.plain()) stage.warm(lines.plain());
    vectors.show(scene);
    clouds.show(scene, bodies.groups);
    // A joint that is still there stays selected.
    const same =
      held && scene.joints.find(({ name, hand }) => name === held.name && hand === held.hand);
    joint.show(same ?? null, same && bodies.groups[same.body], joint.held()?.value ?? 0);
    return ready.then(settle, (error) => {
      stage.hold(false); // what there is
      asked.failed(error);
    });
  };
  const pose = (next) => {
    if (!scene || !fits(scene, next)) return false;
    const first = frame === null;
    draw(next);
    if (first && fitting) settle();
    return true;
  };
  return {
    ...{ stage, bodies, lines, contacts, vectors, pads, joint, place, pointer, show, pose },
    tips: () => tips,
    frame: () => frame,
    fitting: () => fitting,
    complete: () => complete && frame !== null,
    meshCount: shelf.size,
  };
}
