/** Sine and cosine by + - * / alone: JavaScript leaves the last digits of Math.sin to each engine (spec.md, 7). */

export interface Turn {
  readonly sin: number;
  readonly cos: number;
}

const QUARTER = Math.PI / 2;

/** Of an angle in radians; exact to about 1e-15 for angles of a few turns. */
export function turnBy(radians: number): Turn {
  const quarters = Math.round(radians / QUARTER);
  const rest = radians - quarters * QUARTER;
  const square = rest * rest;
  // Taylor's series, whose rest at an eighth of a turn is below the last digit after these terms.
  let sin = 0;
  let cos = 0;
  for (let term = 8; term >= 0; term--) {
    sin = 1 - (square / ((2 * term + 2) * (2 * term + 3))) * sin;
    cos = 1 - (square / ((2 * term + 1) * (2 * term + 2))) * cos;
  }
  return TURNED[((quarters % 4) + 4) % 4]?.(sin * rest, cos) ?? { sin: 0, cos: 1 };
}

const TURNED: readonly ((sin: number, cos: number) => Turn)[] = [
  (sin, cos) => ({ sin, cos }),
  (sin, cos) => ({ sin: cos, cos: -sin }),
  (sin, cos) => ({ sin: -sin, cos: -cos }),
  (sin, cos) => ({ sin: -cos, cos: sin }),
];
