// Many short lines that go with a body, as the joint axes of many draws: darkest where most lie.

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from "three";

const COLORS = ["#0072b2", "#d55e00", "#cc79a7", "#e69f00", "#56b4e9"];

/// Floats [m] from base64, six a segment.
export function floatsOf(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  if (bytes.length % 24)
    throw new Error(`wanted 24 bytes a segment of a cloud, got ${bytes.length}`);
  return new Float32Array(bytes.buffer);
}

/// Clouds of a scene, each under its body of `groups`, or under `world`.
export function makeClouds(world) {
  let shown = [];
  const show = (scene, groups) => {
    for (const lines of shown) {
      lines.geometry.dispose();
      lines.material.dispose();
      lines.removeFromParent();
    }
    shown = scene.clouds.map(({ name, body, segments }, i) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(floatsOf(segments), 3));
      const color = COLORS[i % COLORS.length];
      const look = { color, transparent: true, opacity: 0.22, depthWrite: false };
      const lines = new LineSegments(geometry, new LineBasicMaterial(look));
      lines.name = name;
      lines.renderOrder = 1;
      lines.raycast = () => {};
      (groups[body] ?? world).add(lines);
      return lines;
    });
  };
  return { show };
}
