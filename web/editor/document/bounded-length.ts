import { DESIGN_LIMITS } from "./design-limits.ts";

/** The nearest length to it, metres, that a design may have: one with a smaller or a larger one cannot be read again. */
export const boundedLength = (length: number): number =>
  Math.min(Math.max(length, DESIGN_LIMITS.lengthMin), DESIGN_LIMITS.lengthMax);
