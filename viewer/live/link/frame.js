// What the server sends at every instant: a small binary message, and the meshes, which never change.
// Little-endian throughout, as all browsers' typed arrays are.

const MAGIC = "THF1";
const HEADER = 52; // bytes before the bodies
const CONTACT = 44; // bytes
const POINT_UNIT = 1e-6; // of the step of line points [m]
const POINT_STEP = 10; // where a frame says nothing of it [POINT_UNIT]
const NONE = 0xffff; // a contact's second body that is not there

/// Tells a message that is cut off or not a frame from one that is.
function wantLength(view, wanted, what) {
  if (view.byteLength !== wanted)
    throw new Error(`wanted ${what} of ${wanted} bytes, got ${view.byteLength}`);
}

function headerOf(view) {
  if (view.byteLength < HEADER) throw new Error(`a frame has ${HEADER} bytes at least`);
  const magic = String.fromCharCode(...[0, 1, 2, 3].map((at) => view.getUint8(at)));
  if (magic !== MAGIC) throw new Error(`wanted a frame ${MAGIC}, got ${JSON.stringify(magic)}`);
  const count = (at) => view.getUint16(at, true);
  return {
    revision: view.getUint32(4, true),
    sequence: view.getUint32(8, true),
    time: view.getFloat64(16, true),
    counts: {
      bodies: count(24),
      joints: count(26),
      lines: count(28),
      contacts: count(30),
      arrows: count(32),
      points: count(34),
    },
    step: POINT_UNIT * (count(36) || POINT_STEP),
    origin: [40, 44, 48].map((at) => view.getFloat32(at, true)),
  };
}

function contactAt(view, at) {
  const vector = (from) => [0, 4, 8].map((step) => view.getFloat32(at + from + step, true));
  const body = (index) => (index === NONE ? -1 : index);
  return {
    a: body(view.getUint16(at, true)),
    b: body(view.getUint16(at + 2, true)),
    point: vector(4),
    normal: vector(16),
    force: vector(28),
    friction: view.getFloat32(at + 40, true),
  };
}

/// The frame in an ArrayBuffer: { revision, sequence, time [s], bodies: Float32Array of position [m]
/// and quaternion w x y z, joints [rad or m], tensions [N], contacts, arrows: Float32Array of from and
/// vector, points: Float32Array [m] of all lines }. Throws where the message is not a frame.
export function decodeFrame(buffer) {
  const view = new DataView(buffer);
  const { counts, step, origin, ...head } = headerOf(view);
  const sizes = {
    bodies: 28 * counts.bodies,
    joints: 4 * counts.joints,
    tensions: 4 * counts.lines,
    contacts: CONTACT * counts.contacts,
    arrows: 24 * counts.arrows,
    points: 6 * counts.points,
  };
  wantLength(view, HEADER + Object.values(sizes).reduce((a, b) => a + b), "a frame");
  let at = HEADER;
  const starts = {};
  for (const [name, size] of Object.entries(sizes)) {
    starts[name] = at;
    at += size;
  }
  const floats = (name) => new Float32Array(buffer, starts[name], sizes[name] / 4);
  const steps = new Int16Array(buffer, starts.points, 3 * counts.points);
  return {
    ...head,
    bodies: floats("bodies"),
    joints: floats("joints"),
    tensions: floats("tensions"),
    contacts: Array.from({ length: counts.contacts }, (_, i) =>
      contactAt(view, starts.contacts + CONTACT * i),
    ),
    arrows: floats("arrows"),
    points: Float32Array.from(steps, (count, i) => origin[i % 3] + step * count),
  };
}

const FEW = 65536; // vertices that two bytes count

/// A mesh: { positions: Float32Array [m], triangles: Uint16Array or Uint32Array }, checked so that no triangle names
/// a corner that is not there.
export function decodeMesh(buffer) {
  const view = new DataView(buffer);
  if (view.byteLength < 8) throw new Error("a mesh has 8 bytes at least");
  const [vertices, triangles] = [view.getUint32(0, true), view.getUint32(4, true)];
  const Corners = vertices <= FEW ? Uint16Array : Uint32Array;
  wantLength(view, 8 + 12 * vertices + 3 * Corners.BYTES_PER_ELEMENT * triangles, "a mesh");
  const corners = new Corners(buffer, 8 + 12 * vertices, 3 * triangles);
  for (let i = 0; i < corners.length; ++i)
    if (corners[i] >= vertices)
      throw new Error(`a triangle names a corner beyond the ${vertices} of its mesh`);
  return { positions: new Float32Array(buffer, 8, 3 * vertices), triangles: corners };
}
