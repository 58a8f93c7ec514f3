// Camera of the stage, fitted to the part of the window between the panels.

import { Vector3 } from "three";
import { fitCamera, setAspect } from "../../picture/camera_fit.js";

const SAME = 1e-6; // of what is seen: closer than this nobody moved the camera

/// Shifts the picture into the area between the panels.
function aim(stage) {
  const { camera, width, height, insets } = stage;
  const free = {
    width: Math.max(80, width - insets.left - insets.right),
    height: Math.max(80, height - insets.top - insets.bottom),
  };
  // The camera is fitted to the free part, then its picture is extended to the whole window.
  setAspect(camera, free.width / free.height);
  const [x, y] = [width / free.width, height / free.height];
  camera.left *= x;
  camera.right *= x;
  camera.top *= y;
  camera.bottom *= y;
  const shift = { x: (insets.right - insets.left) / 2, y: (insets.bottom - insets.top) / 2 };
  camera.setViewOffset(width, height, shift.x, shift.y, width, height);
}

/// Gives a stage the functions fit(direction, box), isFitted(), setInsets(insets), ray(event) and pixel(point), and
/// aim().
export function addCamera(stage) {
  const { camera, canvas, controls } = stage;
  stage.aim = () => aim(stage);
  let fitted = null; // where the camera was put
  stage.fit = (direction = stage.from, box = stage.box) => {
    stage.from = direction.clone().normalize();
    controls.target.copy(fitCamera(camera, box, 1, stage.from));
    // The camera stands far off, so that nothing that is dragged out of the first box is cut.
    const reach = box.getSize(new Vector3()).length();
    camera.position.copy(controls.target).addScaledVector(stage.from, 20 * reach);
    camera.near = reach;
    camera.far = 60 * reach;
    aim(stage);
    controls.update();
    fitted = { position: camera.position.clone(), target: controls.target.clone() };
    stage.draw();
  };
  /// Returns true if the user has not moved the camera since.
  stage.isFitted = () =>
    fitted !== null &&
    camera.zoom === 1 &&
    camera.position.distanceTo(fitted.position) < SAME * camera.near &&
    controls.target.distanceTo(fitted.target) < SAME * camera.near;
  stage.setInsets = (insets) => {
    stage.insets = { ...stage.insets, ...insets };
    aim(stage);
    stage.draw();
  };
  stage.ray = ({ clientX, clientY }) => {
    const room = canvas.getBoundingClientRect();
    const x = (2 * (clientX - room.left)) / room.width - 1;
    const y = 1 - (2 * (clientY - room.top)) / room.height;
    return { x, y };
  };
  /// Projects a point of the scene to CSS pixels of the window.
  stage.pixel = (point) => {
    const seen = point.clone().project(camera);
    const room = canvas.getBoundingClientRect();
    return {
      x: room.left + ((seen.x + 1) / 2) * room.width,
      y: room.top + ((1 - seen.y) / 2) * room.height,
    };
  };
}
