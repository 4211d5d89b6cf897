/** The texels of a pixel layer while they are changed. */
import type { Picture } from "../../engine/engine-api.ts";
import type { Texel } from "./pixel-shapes.ts";

/** Red, green, blue, alpha, each 0 to 255. */
export type PixelColor = readonly [number, number, number, number];

export const CLEAR: PixelColor = [0, 0, 0, 0];

export class PixelCanvas {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8Array;
  readonly #start: Uint8Array;
  readonly #alphaLock: boolean;
  /** Of as many texels: it lies above and gives way where something is set. */
  readonly over: PixelCanvas | null;
  /** How many of its own texels are different from those that it began with. */
  #different = 0;
  #revision = 0;

  /** Begins with a copy of a picture. With `alphaLock` only what has paint in it takes paint. */
  constructor({ width, height, rgba }: Picture, alphaLock: boolean, over: PixelCanvas | null = null) {
    this.width = width;
    this.height = height;
    this.#start = rgba;
    this.rgba = rgba.slice();
    this.#alphaLock = alphaLock;
    this.over = over;
  }

  /**
   * Whether anything is different from the picture that it began with, here or in what lies above. Counted as texels are set: to
   * compare them in each frame took more of a stroke over 1024 × 1024 texels than to write its pictures.
   */
  get changed(): boolean {
    return this.#different > 0 || this.over?.changed === true;
  }

  /** Another one whenever one of its own texels has changed. */
  get revision(): number {
    return this.#revision;
  }

  /** Back to the picture that it began with: a shape that follows the pointer is drawn anew. */
  restart(): void {
    this.over?.restart();
    if (this.#different === 0) return;
    this.rgba.set(this.#start);
    this.#different = 0;
    this.#revision += 1;
  }

  /** Texels outside the picture are left out. */
  set(x: number, y: number, color: PixelColor): void {
    if (x < 0 || y < 0 || x >= this.width || y >= this.height) return;
    const at = (y * this.width + x) * 4;
    if (this.#alphaLock && this.#start[at + 3] === 0) return;
    const alpha = this.#alphaLock && color[3] > 0 ? (this.#start[at + 3] as number) : color[3];
    this.over?.set(x, y, CLEAR);
    const { rgba } = this;
    const isSame = rgba[at] === color[0] && rgba[at + 1] === color[1] && rgba[at + 2] === color[2];
    if (isSame && rgba[at + 3] === alpha) return;
    if (!this.#differs(at)) this.#different += 1;
    rgba[at] = color[0];
    rgba[at + 1] = color[1];
    rgba[at + 2] = color[2];
    rgba[at + 3] = alpha;
    if (!this.#differs(at)) this.#different -= 1;
    this.#revision += 1;
  }

  /** A texel, from what it began as; `at` is its first byte. */
  #differs(at: number): boolean {
    const { rgba } = this;
    const start = this.#start;
    for (let byte = at; byte < at + 4; byte++) if (rgba[byte] !== start[byte]) return true;
    return false;
  }

  /** A square tip whose left top texel is given. */
  stamp([left, top]: Texel, size: number, color: PixelColor): void {
    for (let y = top; y < top + size; y++) {
      for (let x = left; x < left + size; x++) this.set(x, y, color);
    }
  }
}

export function pixelColorOf(hex: string): PixelColor {
  const channel = (at: number): number => Number.parseInt(hex.slice(at, at + 2), 16);
  return [channel(1), channel(3), channel(5), 255];
}
