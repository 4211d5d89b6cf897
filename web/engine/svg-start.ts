/** Whether a file is an SVG document, told by its first bytes: what draws one is loaded only then. */

/** Whether the bytes begin like an SVG document. */
export function isSvg(bytes: Uint8Array): boolean {
  // Some begin with a licence.
  const start = new TextDecoder(encodingOf(bytes)).decode(bytes.subarray(0, 65536));
  // A comment ends at the first of its ends: else there were 2ⁿ ways to read n of them.
  return /^\s*(?:<(?:\?[^>]*|!--(?:(?!-->)[\s\S])*--)>\s*)*(?:<!DOCTYPE\s+svg\b|<(?:[\w-]+:)?svg[\s>/])/i.test(start);
}

/** As the byte order mark says; UTF-8 without one. */
export function encodingOf(bytes: Uint8Array): "utf-8" | "utf-16le" | "utf-16be" {
  if (bytes[0] === 0xff && bytes[1] === 0xfe) return "utf-16le";
  return bytes[0] === 0xfe && bytes[1] === 0xff ? "utf-16be" : "utf-8";
}
