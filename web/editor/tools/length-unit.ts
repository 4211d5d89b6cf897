/** Lengths as people say them: millimetres on a mug, metres on a ship. */

export interface LengthUnit {
  readonly symbol: "mm" | "cm" | "m";
  /** Of them in a metre. */
  readonly perMetre: number;
}

/** The unit in which lengths on a model of this diagonal, metres, are numbers of two or three digits. */
export function unitFor(diagonal: number): LengthUnit {
  if (diagonal < 0.8) return { symbol: "mm", perMetre: 1000 };
  return diagonal < 40 ? { symbol: "cm", perMetre: 100 } : { symbol: "m", perMetre: 1 };
}

/** A step that changes a number by about a hundredth: 0.1 for 12.4, 10 for 1240. */
export const stepFor = (value: number): number => 10 ** (Math.floor(Math.log10(Math.max(value, 1e-6))) - 1);
