/** What a file is that cannot be read as a picture, by its first bytes. */
import type { TexelcastError } from "../core/texelcast-error.ts";
import { badPicture, isKtx2 } from "./picture-header.ts";

/** "bad-picture" that says what it is instead. */
export const unknownPicture = (bytes: Uint8Array, name: string): TexelcastError =>
  badPicture(name, ...describeUnknown(bytes), "Save it as PNG, JPEG, WebP or AVIF.");

function describeUnknown(bytes: Uint8Array): readonly [reason: string, problem: string] {
  const start = String.fromCharCode(...bytes.subarray(0, 32));
  if (bytes.length === 0) return ["empty", "it is empty"];
  if (start.startsWith("GIF8")) return ["gif", "it is a GIF"];
  if (start.startsWith("BM")) return ["bmp", "it is a BMP"];
  if (start.startsWith("II*\0") || start.startsWith("MM\0*")) return ["tiff", "it is a TIFF"];
  if (isKtx2(bytes)) return ["ktx2", "it is a KTX2 texture"];
  if (/^\s*(<svg|<\?xml)/.test(start)) return ["svg", "it is an SVG drawing"];
  return ["unknown", "it is neither PNG, JPEG, WebP nor AVIF"];
}
