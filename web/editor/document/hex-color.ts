/** Colours as designs and the command line write them: "#rrggbb" or "#rrggbbaa", sRGB, straight alpha. */

export type Rgba = readonly [number, number, number, number];

export const isHexColor = (text: string): boolean => /^#(?:[0-9a-f]{6}|[0-9a-f]{8})$/i.test(text);

/** Red, green, blue and alpha, each 0 to 1. The text must satisfy `isHexColor`. */
export function parseHexColor(text: string): Rgba {
  const channel = (index: number): number => Number.parseInt(text.slice(1 + 2 * index, 3 + 2 * index), 16) / 255;
  return [channel(0), channel(1), channel(2), text.length === 9 ? channel(3) : 1];
}
