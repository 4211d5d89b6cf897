/** The colours of a picture as a palette. */
import type { Picture } from "../../engine/engine-api.ts";
import { hexOf } from "./pixel-probe.ts";

/** Of each channel, tried from all to few, until the colours are few enough: a skin keeps its own, a photograph is thinned. */
const BITS = [8, 5, 4, 3, 2] as const;
const LEAST_ALPHA = 128;

/** The commonest colours of what is not clear, at most so many, from dark to light; each "#rrggbb". */
export function colorsOf({ rgba }: Pick<Picture, "rgba">, most: number): readonly string[] {
  for (const bits of BITS) {
    const found = meansBy(rgba, bits);
    if (found.length <= most || bits === BITS[BITS.length - 1]) {
      const commonest = found.toSorted((a, b) => b.count - a.count).slice(0, most);
      return commonest.toSorted((a, b) => lightness(a.mean) - lightness(b.mean)).map(({ mean }) => hexOf(...mean));
    }
  }
  return [];
}

interface Heap {
  readonly count: number;
  readonly mean: readonly [number, number, number];
}

/** Colours that are alike in their leading bits are one, the mean of them. */
function meansBy(rgba: Uint8Array, bits: number): Heap[] {
  const sums = new Map<number, [count: number, red: number, green: number, blue: number]>();
  const shift = 8 - bits;
  for (let at = 0; at + 3 < rgba.length; at += 4) {
    if ((rgba[at + 3] as number) < LEAST_ALPHA) continue;
    const [red, green, blue] = rgba.subarray(at, at + 3) as unknown as [number, number, number];
    const key = ((red >> shift) << 16) | ((green >> shift) << 8) | (blue >> shift);
    const sum = sums.get(key);
    if (sum === undefined) sums.set(key, [1, red, green, blue]);
    else {
      sum[0] += 1;
      sum[1] += red;
      sum[2] += green;
      sum[3] += blue;
    }
  }
  return [...sums.values()].map(([count, red, green, blue]) => ({
    count,
    mean: [Math.round(red / count), Math.round(green / count), Math.round(blue / count)],
  }));
}

const lightness = ([red, green, blue]: Heap["mean"]): number => 0.299 * red + 0.587 * green + 0.114 * blue;
