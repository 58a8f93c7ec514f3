// Pointer actions on the picture: dragging a joint's disc, selecting by a click.

import { Raycaster, Vector2 } from "three";

const STILL = 5; // a press that moves less is a click [px]

/// `handles` are { joint, place } of the picture; `select(body index or -1)` hears of clicks.
export function usePointer(stage, bodies, { joint, place }, select) {
  const raycaster = new Raycaster();
  const aim = (event) => {
    const { x, y } = stage.ray(event);
    raycaster.setFromCamera(new Vector2(x, y), stage.camera);
    return raycaster;
  };
  let start = null;
  let drag = null;

  // Handle the event before the camera controls.
  const down = (event) => {
    if (event.button !== 0) return;
    start = { x: event.clientX, y: event.clientY };
    drag = place.busy() ? null : joint.grab(aim(event));
    if (!drag) return;
    stage.controls.enabled = false;
    stage.canvas.setPointerCapture(event.pointerId);
    stage.canvas.classList.add("holding");
    event.stopImmediatePropagation();
    stage.canvas.focus({ preventScroll: true });
  };
  const end = () => {
    if (drag) stage.controls.enabled = true;
    drag = null;
    stage.canvas.classList.remove("holding");
  };
  const up = (event) => {
    const clicked =
      start && Math.hypot(event.clientX - start.x, event.clientY - start.y) < STILL && !drag;
    const moved = place.dragging() || place.busy();
    start = null;
    end();
    if (clicked && !moved && event.type === "pointerup") {
      const [hit] = aim(event).intersectObjects(bodies.meshes(), false);
      select(hit ? hit.object.userData.body : -1);
    }
  };
  stage.canvas.addEventListener("pointerdown", down, { capture: true });
  stage.canvas.addEventListener("pointermove", (event) => drag?.(aim(event)));
  stage.canvas.addEventListener("pointerup", up, { capture: true });
  stage.canvas.addEventListener("pointercancel", up);
  stage.canvas.addEventListener("pointerdown", () => stage.canvas.focus({ preventScroll: true }));
  return { dragging: () => drag !== null };
}
