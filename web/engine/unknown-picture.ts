/** What a file is that cannot be read as a picture, by its first bytes. */
import type { TexelcastError } from "../core/texelcast-error.ts";
import { badPicture, isKtx2 } from "./picture-header.ts";
import { isSvg } from "./svg-start.ts";

/** "bad-picture" that says what it is instead. */
export const unknownPicture = (bytes: Uint8Array, name: string): TexelcastError =>
  badPicture(name, ...describeUnknown(bytes));

const AS_PICTURE = "Save it as PNG, JPEG, WebP or AVIF.";
/** Logos come so from those who draw them. */
const AS_DRAWING = "Export it as SVG, which stays sharp at every size, or as PNG.";

function describeUnknown(bytes: Uint8Array): readonly [reason: string, problem: string, hint: string] {
  const start = String.fromCharCode(...bytes.subarray(0, 32));
  if (bytes.length === 0) return ["empty", "it is empty", AS_PICTURE];
  if (start.startsWith("GIF8")) return ["gif", "it is a GIF", AS_PICTURE];
  if (start.startsWith("BM")) return ["bmp", "it is a BMP", AS_PICTURE];
  if (start.startsWith("II*\0") || start.startsWith("MM\0*")) return ["tiff", "it is a TIFF", AS_PICTURE];
  if (start.startsWith("8BPS")) return ["psd", "it is a Photoshop document", AS_PICTURE];
  if (start.startsWith("%PDF")) return ["pdf", "it is a PDF, as Illustrator's documents are", AS_DRAWING];
  // In some a small picture goes before the text, behind this mark.
  if (/^(%!PS|\xc5\xd0\xd3\xc6)/.test(start)) return ["eps", "it is an EPS drawing", AS_DRAWING];
  if (start.startsWith("\xff\n") || start.slice(4, 8) === "JXL ") return ["jxl", "it is a JPEG XL picture", AS_PICTURE];
  if (isKtx2(bytes)) return ["ktx2", "it is a KTX2 texture", AS_PICTURE];
  if (start.startsWith("\x1f\x8b")) {
    return ["svgz", "it is packed, as a compressed SVG (.svgz) is", "Unpack it, or save it as plain SVG."];
  }
  if (isSvg(bytes)) return ["svg", "it is an SVG drawing", AS_PICTURE];
  const hint = "Save it as PNG, JPEG, WebP or AVIF, or a drawing for a decal as SVG.";
  return ["unknown", "it is neither PNG, JPEG, WebP, AVIF nor SVG", hint];
}
