/**
 * The texels that the texture view did not take: while it shows a texture at half its size or smaller, nobody sees the finest
 * mip level, which is three quarters of what an update brings. They are asked for once they are seen.
 *
 * All that is kept is a rectangle around them, for their bytes are the engine's and can be had from it at any time.
 */
import type { DirtyRect } from "../engine/engine-api.ts";

/** Texels of the finest level. */
export interface TexelRegion {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export class FinestLevel {
  #missing: TexelRegion | null = null;
  #asked = false;

  /** Whether some texels are older than the levels above them. */
  get isStale(): boolean {
    return this.#missing !== null;
  }

  /** The finest level's rectangles of an update were left out. */
  leftOut(rects: readonly DirtyRect[]): void {
    for (const rect of rects) {
      if (rect.level === 0) this.#missing = this.#missing === null ? rect : around(this.#missing, rect);
    }
  }

  /** What is to be asked for now that it is seen; null where nothing is missing or the answer is on its way. */
  toAskFor(): TexelRegion | null {
    if (this.#asked || this.#missing === null) return null;
    this.#asked = true;
    const { x, y, width, height } = this.#missing;
    return { x, y, width, height };
  }

  /** The answer has come, or will not come (null). What it does not hold is missing still. */
  answered(region: TexelRegion | null): void {
    this.#asked = false;
    if (region !== null && this.#missing !== null && holds(region, this.#missing)) this.#missing = null;
  }
}

function around(a: TexelRegion, b: TexelRegion): TexelRegion {
  const [x, y] = [Math.min(a.x, b.x), Math.min(a.y, b.y)];
  const [right, bottom] = [Math.max(a.x + a.width, b.x + b.width), Math.max(a.y + a.height, b.y + b.height)];
  return { x, y, width: right - x, height: bottom - y };
}

function holds(outer: TexelRegion, inner: TexelRegion): boolean {
  return (
    outer.x <= inner.x &&
    outer.y <= inner.y &&
    outer.x + outer.width >= inner.x + inner.width &&
    outer.y + outer.height >= inner.y + inner.height
  );
}
