/** Powers by + - * / alone: JavaScript leaves the last digits of Math.pow to each engine (spec.md, 7). */

/** `base` to the power `exponent`: base from 0 to 1, exponent above 0. Exact to about 1e-15 of the result for exponents up to 10. */
export function power(base: number, exponent: number): number {
  return base > 0 ? exponential(exponent * logarithm(base)) : 0;
}

/** Of a number above 0 and up to 1, natural. */
function logarithm(value: number): number {
  let mantissa = value;
  let doublings = 0;
  for (; mantissa < Math.SQRT1_2; mantissa *= 2) doublings++;
  // ln m = 2 artanh((m - 1) / (m + 1)), whose series for m from √½ to 1 is beneath the last digit after these terms.
  const part = (mantissa - 1) / (mantissa + 1);
  const square = part * part;
  let sum = 0;
  for (let term = 23; term >= 1; term -= 2) sum = sum * square + 1 / term;
  return 2 * part * sum - doublings * Math.LN2;
}

/** Of a number up to 0. */
function exponential(value: number): number {
  if (value < -700) return 0;
  const halvings = Math.round(-value / Math.LN2);
  const rest = value + halvings * Math.LN2;
  let sum = 1;
  for (let term = 16; term >= 1; term--) sum = 1 + (rest / term) * sum;
  for (let i = 0; i < halvings; i++) sum /= 2;
  return sum;
}
