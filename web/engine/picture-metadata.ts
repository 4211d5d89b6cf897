/**
 * Pictures without what cameras and programs write beside the pixels: places, names, serial numbers, small copies of what was
 * cut away, what was appended behind the end. Nothing is decoded or encoded, so the pixels stay to the bit, the same file
 * always gives the same bytes, and a clean file gives itself. What shows is kept: how the camera was held, and of a colour profile
 * the numbers that make colours.
 */
import { asciiAt, asciiCodes } from "./ascii-codes.ts";
import { orientationBlock } from "./exif-block.ts";
import { joinBytes } from "./join-bytes.ts";
import type { PictureFormat } from "./picture-header.ts";

/** What shows of it. */
export interface KeptMetadata {
  /** As the header says it, 1 to 8. */
  readonly orientation: number;
  /** The chunk or the segments of a colour profile (`keptColors`); null where the colours are sRGB's. */
  readonly colors: Uint8Array | null;
}

/**
 * @param bytes A file whose header has been read (`readPictureHeader`), which proves its chunks or segments whole. An AVIF keeps
 *   what it says of its colours in numbers.
 */
export async function withoutMetadata(
  format: PictureFormat,
  bytes: Uint8Array,
  kept: KeptMetadata,
): Promise<Uint8Array<ArrayBuffer>> {
  if (format === "avif") return (await import("./avif-header.ts")).cleanAvif(bytes, kept.colors);
  if (format === "png") return (await import("./clean-png.ts")).cleanPng(bytes, kept);
  return format === "jpeg" ? cleanJpeg(bytes, kept) : cleanWebp(bytes, kept);
}

const JPEG = { end: 0xd9, scan: 0xda, app0: 0xe0, app14: 0xee, app15: 0xef, comment: 0xfe } as const;

function cleanJpeg(bytes: Uint8Array, { orientation, colors }: KeptMetadata): Uint8Array<ArrayBuffer> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const parts: Uint8Array[] = [bytes.subarray(0, 2)];
  if (orientation !== 1) {
    const data = joinBytes([asciiCodes("Exif\0\0"), orientationBlock(orientation)]);
    parts.push(Uint8Array.of(0xff, 0xe1, 0, 2 + data.length), data);
  }
  if (colors !== null) parts.push(colors);
  for (let at = 2; at + 1 < bytes.length; ) {
    const marker = view.getUint8(at + 1);
    if (view.getUint8(at) !== 0xff || marker === 0xff) {
      at += 1;
      continue;
    }
    if (marker === JPEG.end) break;
    // A file that ends inside a segment has shown its end marker to the header's reader somewhere before: nothing is lost.
    const after = at + 4 > bytes.length ? at + 4 : at + 2 + view.getUint16(at + 2);
    if (after > bytes.length) break;
    const segment = bytes.subarray(at, after);
    if (isJpegNeeded(marker, segment)) parts.push(marker === JPEG.app0 ? withoutThumbnail(segment) : segment);
    const end = marker === JPEG.scan ? scanEnd(bytes, after) : after;
    parts.push(bytes.subarray(after, end));
    at = end;
  }
  parts.push(Uint8Array.of(0xff, JPEG.end));
  return joinBytes(parts);
}

/** JFIF's and Adobe's own say how colours are coded. */
function isJpegNeeded(marker: number, segment: Uint8Array): boolean {
  if (marker === JPEG.app0) return asciiAt(segment, 4, 5) === "JFIF\0";
  if (marker === JPEG.app14) return asciiAt(segment, 4, 5) === "Adobe";
  return marker !== JPEG.comment && !(marker >= JPEG.app0 && marker <= JPEG.app15);
}

function withoutThumbnail(jfif: Uint8Array): Uint8Array {
  if (jfif.length < 18) return jfif;
  const short = jfif.slice(0, 18);
  short.set([0, 16], 2);
  short.set([0, 0], 16);
  return short;
}

/** Where the next marker stands that is neither a stuffed 0xff nor a restart. */
function scanEnd(bytes: Uint8Array, from: number): number {
  for (let at = bytes.indexOf(0xff, from); at >= 0; at = bytes.indexOf(0xff, at + 1)) {
    const next = bytes[at + 1];
    if (next !== undefined && next !== 0 && next !== 0xff && !(next >= 0xd0 && next <= 0xd7)) return at;
  }
  return bytes.length;
}

const WEBP_CHUNKS: ReadonlySet<string> = new Set(["VP8X", "VP8 ", "VP8L", "ALPH"]);
/** Flags of VP8X: a colour profile, EXIF, XMP. */
const WEBP_EXTRAS = 0x20 | 0x08 | 0x04;
const WEBP_PROFILE = 0x20;
const WEBP_EXIF = 0x08;

function cleanWebp(bytes: Uint8Array, { orientation, colors }: KeptMetadata): Uint8Array<ArrayBuffer> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const end = 8 + view.getUint32(4, true);
  const parts: Uint8Array[] = [bytes.slice(0, 12)];
  for (let at = 12; at + 8 <= end; ) {
    const length = view.getUint32(at + 4, true);
    const type = asciiAt(bytes, at, 4);
    if (WEBP_CHUNKS.has(type)) {
      const chunk = bytes.slice(at, at + 8 + length + (length & 1));
      if (type === "VP8X") {
        const kept = (orientation === 1 ? 0 : WEBP_EXIF) | (colors === null ? 0 : WEBP_PROFILE);
        chunk[8] = ((chunk[8] ?? 0) & ~WEBP_EXTRAS) | kept;
      }
      parts.push(chunk);
      if (type === "VP8X" && colors !== null) parts.push(colors);
    }
    at += 8 + length + (length & 1);
  }
  if (orientation !== 1) {
    const block = orientationBlock(orientation);
    parts.push(asciiCodes("EXIF"), Uint8Array.of(block.length, 0, 0, 0), block);
  }
  const whole = joinBytes(parts);
  new DataView(whole.buffer).setUint32(4, whole.length - 8, true);
  return whole;
}
