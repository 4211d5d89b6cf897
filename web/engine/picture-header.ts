/**
 * What a picture says of itself before it is decoded: its format by its first bytes (never by its name), its size, how
 * it lies (EXIF), and whether the file is whole. Sizes are checked here, so that a small file that claims a huge picture
 * allocates nothing.
 */
import { MAX_SIZE } from "../core/sizes.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import { PictureFault, type RawHeader } from "./picture-fault.ts";
import { readPngHeader } from "./png-header.ts";

export type PictureFormat = "png" | "jpeg" | "webp" | "avif";

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

/** The format that the first bytes show, or null. HEIC pictures and films begin as AVIF does: its header's reader refuses them. */
export function sniffPicture(bytes: Uint8Array): PictureFormat | null {
  const start = String.fromCharCode(...bytes.subarray(0, 12));
  if (start.startsWith("\x89PNG\r\n\x1a\n")) return "png";
  if (start.startsWith("\xff\xd8\xff")) return "jpeg";
  if (start.startsWith("RIFF") && start.endsWith("WEBP")) return "webp";
  if (start.slice(4, 8) === "ftyp") return "avif";
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
 * Reads a picture's header. Rejects with "bad-picture" naming the file: not a PNG, JPEG, WebP or AVIF, damaged, cut short, CMYK,
 * animated, or larger than 8192 along a side (which also bounds it to 64 Mi pixels).
 */
export async function readPictureHeader(bytes: Uint8Array, name: string): Promise<PictureHeader> {
  const format = sniffPicture(bytes);
  if (format === null) throw (await import("./unknown-picture.ts")).unknownPicture(bytes, name);
  return checkedHeader(format, await headerReader(format), bytes, name);
}

/** A model's own texture is a PNG as a rule: how its header is read comes with the engine, the others' with their decoders. */
async function headerReader(format: PictureFormat): Promise<HeaderReader> {
  if (format === "png") return readPngHeader;
  if (format === "avif") return (await import("./avif-header.ts")).readAvifHeader;
  return (await import("./lossy-codecs.ts")).LOSSY_HEADERS[format];
}

type HeaderReader = (bytes: Uint8Array) => RawHeader;

/** Reads a header by what its format asks for. Throws as `readPictureHeader` rejects. */
export function checkedHeader(
  format: PictureFormat,
  read: HeaderReader,
  bytes: Uint8Array,
  name: string,
): PictureHeader {
  try {
    const header = read(bytes);
    checkPixels(header);
    return { format, ...header };
  } catch (fault) {
    if (fault instanceof PictureFault) throw badPicture(name, fault.reason, fault.message, fault.hint);
    // DataView refuses offsets beyond the end: the readers rely on that for files cut short.
    throw badPicture(name, "cut-short", "it ends too early, so it was cut short", "Copy or download it again.", fault);
  }
}

/** Throws a PictureFault for a size of no pixels, or of more along a side than there may be. */
export function checkPixels({ width, height }: { readonly width: number; readonly height: number }): void {
  if (width === 0 || height === 0) throw new PictureFault("no-pixels", `it says it is ${width} × ${height} pixels`);
  if (width > MAX_SIZE || height > MAX_SIZE) {
    const problem = `it has ${width} × ${height} pixels, and ${MAX_SIZE} along a side is the most`;
    throw new PictureFault("too-many-pixels", problem, "Make it smaller.");
  }
}
