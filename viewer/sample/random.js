// Numbers that look like noise and are the same every time.

let state = 1;

const uniform = () => {
  state = (state * 48271) % 2147483647; // Lehmer's generator, Park and Miller 1988
  return state / 2147483647;
};

/// Normal noise by Box and Muller.
export const noise = (sd) =>
  sd * Math.sqrt(-2 * Math.log(uniform())) * Math.cos(2 * Math.PI * uniform());

export const round = (value, digits = 4) => Number(value.toPrecision(digits));
