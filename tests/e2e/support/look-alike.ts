/** Whether two screenshots show the same. */
import { readPng } from "./read-png.ts";

/**
 * Steps of 255 that the browser's own drawing may move between two screenshots of one page: it dithers gradients, and not always the
 * same way. Chromium 156 under load, ten runs of one story: two pictures in turn, up to 3 apart in a sixteenth of their pixels.
 */
const DITHER = 6;

export function lookAlike(one: Buffer, other: Buffer): boolean {
  const [a, b] = [readPng(one), readPng(other)];
  if (a.width !== b.width || a.height !== b.height) return false;
  return a.rgba.every((value, at) => Math.abs(value - (b.rgba[at] ?? 0)) <= DITHER);
}
