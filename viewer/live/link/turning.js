// What a pointer on a joint's disc means: angles about an axis, without the browser. Vectors are [3].

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const along = (a, b, s) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

export const unit = (v) => {
  const length = Math.hypot(...v);
  return length > 0 ? v.map((part) => part / length) : [0, 0, 0];
};

/// Some unit vector across `axis`, as near to `wish` as can be.
export function across(axis, wish) {
  const a = unit(axis);
  const rest = along(wish, a, -dot(wish, a));
  if (Math.hypot(...rest) > 1e-6 * (1 + Math.hypot(...wish))) return unit(rest);
  return unit(cross(a, Math.abs(a[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]));
}

const STEEP = 0.12; // cosine below which a disc is seen from its edge

/// Where the ray hits the plane of a joint, from its point; null where it runs along the plane.
function onPlane({ axis, point }, { from, way }) {
  const steepness = dot(axis, way);
  if (Math.abs(steepness) < STEEP) return null;
  const s = dot(minus(point, from), axis) / steepness;
  return minus(along(from, way, s), point);
}

/// Angle from `a` to `b` about `axis` [rad].
const angleBetween = (a, b, axis) => Math.atan2(dot(cross(a, b), axis), dot(a, b));

/// Follows a pointer about a joint { axis, point, slides } in the world: begins at a ray { from, way }
/// and returns a function of the next ray that gives how far the joint went since the beginning [rad or
/// m]. More than half a turn is counted on. Where the disc is seen from its edge, the way across the
/// picture counts, at `radius` [m] to a radian.
export function follow(joint, start, radius) {
  if (joint.slides) return followSlide(joint, start);
  let last = onPlane(joint, start);
  let turned = 0;
  if (!last) return followEdge(joint, start, radius);
  return (ray) => {
    const now = onPlane(joint, ray);
    if (!now) return turned;
    turned += angleBetween(last, now, joint.axis);
    last = now;
    return turned;
  };
}

/// The nearest point to the ray on the axis, as a length along it.
function alongAxis({ axis, point }, { from, way }) {
  const between = minus(from, point);
  const c = dot(axis, way);
  const rest = 1 - c * c;
  if (rest < 1e-6) return null;
  return (dot(between, axis) - c * dot(between, way)) / rest;
}

function followSlide(joint, start) {
  const begin = alongAxis(joint, start) ?? 0;
  let last = begin;
  return (ray) => {
    last = alongAxis(joint, ray) ?? last;
    return last - begin;
  };
}

function followEdge({ axis, point }, start, radius) {
  const side = unit(cross(axis, start.way));
  const place = ({ from, way }) => {
    const s = dot(minus(point, from), start.way) / (dot(way, start.way) || 1);
    return dot(minus(along(from, way, s), point), side);
  };
  const begin = place(start);
  // The near side of the disc goes against `side` when the joint turns by the right hand.
  return (ray) => -(place(ray) - begin) / radius;
}
