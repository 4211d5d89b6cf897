/** Colours as designs and the command line write them: "#rrggbb" or "#rrggbbaa", sRGB, straight alpha. */

export type Rgba = readonly [number, number, number, number];

/** Without flags, which a JSON Schema's patterns do not have. */
export const HEX_COLOR = /^#(?:[0-9a-fA-F]{6}|[0-9a-fA-F]{8})$/;

export const isHexColor = (text: string): boolean => HEX_COLOR.test(text);

/** Red, green, blue and alpha, each 0 to 1. The text must satisfy `isHexColor`. */
export function parseHexColor(text: string): Rgba {
  const channel = (index: number): number => Number.parseInt(text.slice(1 + 2 * index, 3 + 2 * index), 16) / 255;
  return [channel(0), channel(1), channel(2), text.length === 9 ? channel(3) : 1];
}
