// Layers of a scene that show one thing at several instants. Without the browser.

const LEAST = 3; // instants that make a motion
const NAME = /^(\d+(?:\.\d+)?(?:e[-+]?\d+)?) s$/; // of a layer that is named after its time

/// The time of a layer [s]; null for those that are there all the time.
function timeOf({ name, time }) {
  if (Number.isFinite(time)) return time;
  const found = NAME.exec(name);
  return found ? Number(found[1]) : null;
}

/// The layers with their `time`, which is null for all in a scene of too few instants to play.
export function timedLayers(layers) {
  const times = layers.map(timeOf);
  const count = new Set(times.filter((time) => time !== null)).size;
  return layers.map((layer, i) => ({ ...layer, time: count < LEAST ? null : times[i] }));
}

/// All instants in order, each once.
export const instantsOf = (layers) =>
  [...new Set(layers.map(({ time }) => time).filter((time) => time !== null))].sort(
    (a, b) => a - b,
  );

/// The last instant at or before `time`; the first before all.
export const instantAt = (instants, time) => instants.findLast((one) => one <= time) ?? instants[0];

const SPEEDS = [1, 0.5, 0.25, 0.1, 0.05];

/// The speeds to choose from, and the fastest of them at which a motion takes at least `seconds`.
export function speedsFor(instants, seconds = 3) {
  const duration = instants.at(-1) - instants[0];
  const chosen = SPEEDS.find((speed) => duration / speed >= seconds) ?? SPEEDS.at(-1);
  return { speeds: SPEEDS, chosen };
}
