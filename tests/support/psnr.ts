/** How near one picture is to another: the measure of the reference pictures. */
import type { Picture } from "../../web/engine/engine-api.ts";

export interface Closeness {
  /** Peak signal-to-noise ratio over red, green and blue of the compared texels; Infinity where they are equal. */
  readonly decibel: number;
  readonly comparedTexels: number;
  /** The largest difference of one channel, 0 to 255. */
  readonly worst: number;
}

/**
 * Compares what either picture paints on white, where the answer is sure.
 *
 * @param sure White where the expected picture's answer does not hang on rounding.
 */
export function closenessOnWhite(expected: Picture, actual: Picture, sure: Picture): Closeness {
  for (const picture of [actual, sure]) {
    if (picture.width !== expected.width || picture.height !== expected.height) {
      throw new Error(
        `pictures differ in size: ${picture.width} x ${picture.height}, not ${expected.width} x ${expected.height}`,
      );
    }
  }
  const isPainted = ({ rgba }: Picture, at: number): boolean => [0, 1, 2].some((channel) => rgba[at + channel] !== 255);
  let comparedTexels = 0;
  let squares = 0;
  let worst = 0;
  for (let at = 0; at < expected.rgba.length; at += 4) {
    if (sure.rgba[at] !== 255) continue;
    if (!isPainted(expected, at) && !isPainted(actual, at)) continue;
    comparedTexels += 1;
    for (let channel = 0; channel < 3; channel += 1) {
      const difference = Math.abs((expected.rgba[at + channel] ?? 0) - (actual.rgba[at + channel] ?? 0));
      squares += difference * difference;
      worst = Math.max(worst, difference);
    }
  }
  const meanSquare = squares / Math.max(1, 3 * comparedTexels);
  const decibel = meanSquare === 0 ? Number.POSITIVE_INFINITY : 10 * Math.log10((255 * 255) / meanSquare);
  return { decibel, comparedTexels, worst };
}
