/**
 * What a picture says of itself before it is decoded: its format by its first bytes (never by its name), its size, how
 * it lies (EXIF), and whether the file is whole. Sizes are checked here, so that a small file that claims a huge picture
 * allocates nothing.
 */
import { MAX_SIZE } from "../core/sizes.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import { readJpegHeader } from "./jpeg-header.ts";
import { PictureFault, type RawHeader } from "./picture-fault.ts";
import { readPngHeader } from "./png-header.ts";
import { readWebpHeader } from "./webp-header.ts";

export type PictureFormat = "png" | "jpeg" | "webp";

export interface PictureHeader extends RawHeader {
  readonly format: PictureFormat;
}

/**
 * @param reason the error's (`TexelcastErrorDetails`)
 * @param problem the end of the sentence “The picture … cannot be used: …”
 */
export function badPicture(
  name: string,
  reason: string,
  problem: string,
  hint?: string,
  cause?: unknown,
): TexelcastError {
  return new TexelcastError("bad-picture", `The picture “${name}” cannot be used: ${problem}.`, {
    subject: name,
    reason,
    ...(hint !== undefined && { hint }),
    ...(cause !== undefined && { cause }),
  });
}

const HEADER_READERS: Readonly<Record<PictureFormat, (bytes: Uint8Array) => RawHeader>> = {
  png: readPngHeader,
  jpeg: readJpegHeader,
  webp: readWebpHeader,
};

/** The format that the first bytes show, or null. */
export function sniffPicture(bytes: Uint8Array): PictureFormat | null {
  const start = String.fromCharCode(...bytes.subarray(0, 12));
  if (start.startsWith("\x89PNG\r\n\x1a\n")) return "png";
  if (start.startsWith("\xff\xd8\xff")) return "jpeg";
  if (start.startsWith("RIFF") && start.endsWith("WEBP")) return "webp";
  return null;
}

/** The media type that the first bytes show, for any picture that glTF may hold; undefined for an unknown one. */
export function mediaTypeOf(bytes: Uint8Array): string | undefined {
  const format = sniffPicture(bytes);
  if (format !== null) return `image/${format}`;
  return isKtx2(bytes) ? "image/ktx2" : undefined;
}

/** By the eight bytes that a KTX 2.0 file begins with. */
export function isKtx2(bytes: Uint8Array): boolean {
  return String.fromCharCode(...bytes.subarray(0, 8)) === "\xabKTX 20\xbb";
}

/**
 * Reads a picture's header. Throws "bad-picture" naming the file: not a PNG, JPEG or WebP, damaged, cut short, CMYK,
 * animated, or larger than 8192 along a side (which also bounds it to 64 Mi pixels).
 */
export function readPictureHeader(bytes: Uint8Array, name: string): PictureHeader {
  const format = sniffPicture(bytes);
  if (format === null) {
    throw badPicture(name, ...describeUnknown(bytes), "Save it as PNG, JPEG or WebP.");
  }
  let header: RawHeader;
  try {
    header = HEADER_READERS[format](bytes);
  } catch (fault) {
    if (fault instanceof PictureFault) throw badPicture(name, fault.reason, fault.message, fault.hint);
    // DataView refuses offsets beyond the end: the readers rely on that for files cut short.
    throw badPicture(name, "cut-short", "it ends too early, so it was cut short", "Copy or download it again.", fault);
  }
  const { width, height } = header;
  if (width === 0 || height === 0) throw badPicture(name, "no-pixels", `it says it is ${width} × ${height} pixels`);
  if (width > MAX_SIZE || height > MAX_SIZE) {
    const problem = `it has ${width} × ${height} pixels, and ${MAX_SIZE} along a side is the most`;
    throw badPicture(name, "too-many-pixels", problem, "Make it smaller.");
  }
  return { format, ...header };
}

function describeUnknown(bytes: Uint8Array): readonly [reason: string, problem: string] {
  const start = String.fromCharCode(...bytes.subarray(0, 32));
  if (bytes.length === 0) return ["empty", "it is empty"];
  if (start.startsWith("GIF8")) return ["gif", "it is a GIF"];
  if (start.startsWith("BM")) return ["bmp", "it is a BMP"];
  if (start.startsWith("II*\0") || start.startsWith("MM\0*")) return ["tiff", "it is a TIFF"];
  if (start.slice(4, 8) === "ftyp") return ["avif", "it is an AVIF or HEIC picture, or a film"];
  if (isKtx2(bytes)) return ["ktx2", "it is a KTX2 texture"];
  if (/^\s*(<svg|<\?xml)/.test(start)) return ["svg", "it is an SVG drawing"];
  return ["unknown", "it is neither PNG, JPEG nor WebP"];
}
