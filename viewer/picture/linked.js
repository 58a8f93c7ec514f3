// Scenes that are compared side by side turn together.

const groups = new Map();
let following = false;

/// Gives `other` the direction and the zoom of `leader`; each keeps the point it looks at.
function follow(other, leader) {
  const offset = leader.view.camera.position.clone().sub(leader.controls.target);
  const distance = other.view.camera.position.distanceTo(other.controls.target);
  other.view.camera.position
    .copy(other.controls.target)
    .addScaledVector(offset.normalize(), distance);
  other.view.camera.zoom = leader.view.camera.zoom;
  other.view.camera.updateProjectionMatrix();
  other.controls.update();
  other.view.draw();
}

/// Adds a view to the group of that name.
export function link(name, view, controls) {
  const group = groups.get(name) ?? [];
  const member = { view, controls };
  groups.set(name, [...group, member]);
  controls.addEventListener("change", () => {
    if (following) return;
    following = true;
    groups
      .get(name)
      .filter((other) => other !== member)
      .forEach((other) => follow(other, member));
    following = false;
  });
}
