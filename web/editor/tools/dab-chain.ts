/** The dabs of a stroke that grows: placed along each piece of its path, begun anew where the path breaks. */

import { DESIGN_LIMITS } from "../document/design-limits.ts";
import { type Dab, type PathTail, placeDabs, type Vec3 } from "../document/index.ts";
import type { PathStep } from "./pointer-path.ts";

export interface DabChainOptions {
  /** Metres. */
  readonly size: number;
  /** Width by height of the picture that is the tip; default 1. */
  readonly aspect?: number;
  /** Share of the size. */
  readonly spacing: number;
  /** What the pen's pressure changes. */
  readonly pressure: "none" | "flow" | "size";
  /** How far above the surface a hidden one lies, metres; `reach` where there is none. Without it nothing is hidden. */
  readonly freeAbove?: (position: Vec3, normal: Vec3, reach: number) => number;
}

/** A dab keeps this share of the way to what is hidden above it. */
const KEPT_CLEARANCE = 0.9;

export class DabChain {
  readonly #options: DabChainOptions;
  #dabs: readonly Dab[] = [];
  #tail: PathTail | null = null;

  constructor(options: DabChainOptions) {
    this.#options = options;
  }

  /** In order. A longer list begins with the very objects of the shorter one before. */
  get dabs(): readonly Dab[] {
    return this.#dabs;
  }

  /** It has as many dabs as a design's stroke may hold, and takes no more. */
  get full(): boolean {
    return this.#dabs.length >= DESIGN_LIMITS.dabs;
  }

  /** Returns the dabs that the steps have added. */
  extend(steps: readonly PathStep[]): readonly Dab[] {
    const { size, aspect = 1, spacing, pressure } = this.#options;
    const added: Dab[] = [];
    const room = DESIGN_LIMITS.dabs - this.#dabs.length;
    for (const step of steps) {
      if (added.length >= room) break;
      if (step === null) {
        this.#tail = null;
        continue;
      }
      const { position, normal } = step.hit;
      const point = { position, normal, pressure: pressure === "none" ? 1 : step.pressure };
      const options = { size, aspect, spacing, pressure: pressure === "size" ? pressure : "flow" } as const;
      const piece = placeDabs([point], options, this.#tail);
      this.#tail = piece.tail;
      for (const dab of piece.dabs) added.push(roundedDab(this.#below(dab)));
    }
    added.splice(room);
    if (added.length > 0) this.#dabs = [...this.#dabs, ...added];
    return added;
  }

  /** Cut off on its outer side below what is hidden there: that would be painted, and not what is seen. */
  #below(dab: Dab): Dab {
    const { freeAbove } = this.#options;
    if (dab.kind !== "planar" || freeAbove === undefined) return dab;
    const [width, height, depth] = dab.size;
    const [x, y, z, w] = dab.rotation;
    const outward: Vec3 = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
    const free = freeAbove(dab.position, outward, depth / 2);
    if (free >= depth / 2) return dab;
    const kept = KEPT_CLEARANCE * free;
    const shift = (kept - depth / 2) / 2;
    const position = dab.position.map((part, axis) => part + outward[axis as 0 | 1 | 2] * shift) as unknown as Vec3;
    return { ...dab, position, size: [width, height, depth / 2 + kept] };
  }
}

/** To what 32-bit arithmetic sees: a design of a thousand strokes is saved in half the bytes. */
export function roundedDab(dab: Dab): Dab {
  if (dab.kind !== "planar") return dab;
  const digits = <Numbers extends readonly number[]>(values: Numbers, keep: (value: number) => number): Numbers =>
    values.map(keep) as unknown as Numbers;
  const seven = (value: number): number => Number(value.toPrecision(7));
  return {
    ...dab,
    position: digits(dab.position, seven),
    rotation: digits(dab.rotation, (part) => Math.round(part * 1e6) / 1e6),
    size: digits(dab.size, seven),
    flow: Math.round(dab.flow * 1e4) / 1e4,
  };
}
