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

  /** Begins with a copy of a picture. With `alphaLock` only what has paint in it takes paint. */
  constructor({ width, height, rgba }: Picture, alphaLock: boolean, over: PixelCanvas | null = null) {
    this.width = width;
    this.height = height;
    this.#start = rgba;
    this.rgba = rgba.slice();
    this.#alphaLock = alphaLock;
    this.over = over;
  }

  /** Whether anything is different from the picture that it began with, here or in what lies above. */
  get changed(): boolean {
    return this.over?.changed || this.rgba.some((value, index) => value !== this.#start[index]);
  }

  /** Back to the picture that it began with: a shape that follows the pointer is drawn anew. */
  restart(): void {
    this.rgba.set(this.#start);
    this.over?.restart();
  }

  /** Texels outside the picture are left out. */
  set(x: number, y: number, color: PixelColor): void {
    if (x < 0 || y < 0 || x >= this.width || y >= this.height) return;
    const at = (y * this.width + x) * 4;
    if (this.#alphaLock && this.#start[at + 3] === 0) return;
    const alpha = this.#alphaLock && color[3] > 0 ? (this.#start[at + 3] as number) : color[3];
    this.rgba.set([color[0], color[1], color[2], alpha], at);
    this.over?.set(x, y, CLEAR);
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
