// Requests that follow a hand: never more than one in flight, and only the newest of those that wait.

/// `send(value)` returns a promise. The function that is returned takes the next value; values that
/// come while one is in flight are joined by `merge(waiting, next)`, by default the newest stays.
/// It promises when the value, or a newer one in its place, has been answered.
export function latestWins(send, merge = (_, next) => next) {
  let flying = null;
  let waiting = null;

  async function work() {
    while (waiting) {
      const { value, settled } = waiting;
      waiting = null;
      await send(value).then(settled.resolve, settled.reject);
    }
    flying = null;
  }

  return (value) => {
    if (waiting) waiting.value = merge(waiting.value, value);
    else {
      const settled = {};
      settled.promise = new Promise((resolve, reject) =>
        Object.assign(settled, { resolve, reject }),
      );
      waiting = { value, settled };
    }
    const { promise } = waiting.settled;
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
