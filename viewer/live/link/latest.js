// Requests that follow a hand: never more than one in flight, and only the newest of those that wait.

/// `send(value)` returns a promise. The function that is returned takes the next value; values that
/// come while one is in flight are joined by `merge(waiting, next)`, by default the newest stays;
/// null: they do not belong together, and the next one waits behind. It promises when the value, or
/// a newer one in its place, has been answered.
export function latestWins(send, merge = (_, next) => next) {
  let flying = null;
  const waiting = [];

  async function work() {
    while (waiting.length > 0) {
      const { value, settled } = waiting.shift();
      await send(value).then(settled.resolve, settled.reject);
    }
    flying = null;
  }

  return (value) => {
    const last = waiting.at(-1);
    const merged = last ? merge(last.value, value) : null;
    if (merged !== null) last.value = merged;
    else {
      const settled = {};
      settled.promise = new Promise((resolve, reject) =>
        Object.assign(settled, { resolve, reject }),
      );
      waiting.push({ value, settled });
    }
    const { promise } = waiting.at(-1).settled;
    flying ??= work();
    return promise;
  };
}

/// Calls `work` once nothing has called for so long [ms].
export function whenQuiet(work, ms, later = setTimeout, never = clearTimeout) {
  let timer = null;
  return () => {
    if (timer !== null) never(timer);
    timer = later(() => {
      timer = null;
      work();
    }, ms);
  };
}
