/** A logarithmic axis: where a value lies, and which values get a tick. */

export interface LogScale {
  /** Pixels. */
  at(value: number): number;
  readonly ticks: readonly number[];
}

/** Round numbers of each decade that get a tick, from few to many: the first that gives three ticks is taken. */
const STEPS = [[1], [1, 3], [1, 2, 5]];

/** @param values to be held, all above 0 @param from pixels of the lower end @param to pixels of the upper end */
export function logScale(values: readonly number[], from: number, to: number): LogScale {
  // A tenth of a decade of air at both ends, which also gives a single value a width.
  const low = Math.log10(Math.min(...values)) - 0.1;
  const high = Math.log10(Math.max(...values)) + 0.1;
  return {
    at: (value) => from + ((Math.log10(value) - low) / (high - low)) * (to - from),
    ticks: STEPS.map((steps) => roundNumbers(low, high, steps)).find(({ length }) => length >= 3) ?? [
      ...new Set([...roundNumbers(low, high, STEPS[2]), ...roundNumbers(low, high, [1, 2, 3, 5, 7])]),
    ],
  };
}

function roundNumbers(low: number, high: number, steps: readonly number[]): number[] {
  const numbers: number[] = [];
  for (let decade = Math.floor(low); decade <= high; decade++) {
    for (const step of steps) {
      const exponent = decade + Math.log10(step);
      if (exponent >= low && exponent <= high) numbers.push(step * 10 ** decade);
    }
  }
  return numbers;
}
