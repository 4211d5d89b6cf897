/** What a picture's file says of its colours: the profile that lies in it, or the numbers that stand for one. */

import { asciiAt } from "./ascii-codes.ts";
import { viewOf } from "./byte-view.ts";
import { JPEG_MARK } from "./color-mention.ts";
import { cleanProfile, codedProfile, convertToSrgb, readColorProfile } from "./color-profile.ts";
import { BoxReader } from "./isobmff.ts";
import { joinBytes } from "./join-bytes.ts";
import { PictureFault } from "./picture-fault.ts";
import { badPicture, type PictureFormat } from "./picture-header.ts";
import { avifProfile, jpegProfile, pngColorNumbers, pngProfile, webpProfile } from "./profile-pieces.ts";

/** The bytes of a profile (ICC), or its primaries' and its curve's numbers of ITU-T H.273. */
export type ColorSource = Uint8Array | readonly [primaries: number, curve: number];

/**
 * Turns a picture's pixels into sRGB, in place. Rejects with "bad-picture" naming the file for a profile that cannot be followed.
 *
 * @param bytes A file whose header has been read (`readPictureHeader`).
 */
export async function toSrgb(rgba: Uint8Array, format: PictureFormat, bytes: Uint8Array, name: string): Promise<void> {
  const source = await colorSource(format, bytes);
  if (source === null) return;
  const profile = source instanceof Uint8Array ? named(name, () => readColorProfile(source)) : codedProfile(...source);
  if (profile !== null) convertToSrgb(rgba, profile);
}

/**
 * The chunk, the segments or the box by which a file keeps its colours, without what else profiles tell. Null where the colours are
 * sRGB's, and of an AVIF's numbers, which it keeps by itself; rejects as `toSrgb`.
 */
export async function keptColors(format: PictureFormat, bytes: Uint8Array, name: string): Promise<Uint8Array | null> {
  const source = await colorSource(format, bytes);
  if (source === null) return null;
  if (!(source instanceof Uint8Array)) {
    return format === "png" && codedProfile(...source) !== null ? pngColorNumbers(...source) : null;
  }
  const profile = named(name, () => cleanProfile(source));
  return profile && PIECES[format](profile);
}

const PIECES: Readonly<Record<PictureFormat, (profile: Uint8Array) => Uint8Array>> = {
  png: pngProfile,
  jpeg: jpegProfile,
  webp: webpProfile,
  avif: avifProfile,
};

function named<Result>(name: string, read: () => Result): Result {
  try {
    return read();
  } catch (fault) {
    if (fault instanceof PictureFault) throw badPicture(name, fault.reason, fault.message, fault.hint);
    throw fault;
  }
}

/** As it stands in the file. */
async function colorSource(format: PictureFormat, bytes: Uint8Array): Promise<ColorSource | null> {
  if (format === "png") return await ofPng(bytes);
  if (format === "jpeg") return ofJpeg(bytes);
  return format === "webp" ? ofWebp(bytes) : await ofAvif(bytes);
}

/** PNG 3rd edition, 4.3: cICP goes before iCCP, and that before sRGB. */
async function ofPng(bytes: Uint8Array): Promise<ColorSource | null> {
  let packed: Uint8Array | null = null;
  const view = viewOf(bytes);
  for (let at = 8; at + 12 <= bytes.length; ) {
    const length = view.getUint32(at);
    const type = asciiAt(bytes, at + 4, 4);
    const data = bytes.subarray(at + 8, at + 8 + length);
    if (type === "IDAT" || type === "IEND") break;
    if (type === "cICP") return [data[0] ?? 0, data[1] ?? 0];
    // A name of at most 79 characters, and 0 for the one kind of compression that there is.
    if (type === "iCCP") packed = data.subarray(data.indexOf(0) + 2);
    at += 12 + length;
  }
  return packed === null ? null : await inflate(packed);
}

/** Screens' profiles with tables for everything come to 2 MiB. */
const MOST_BYTES = 2 ** 22;

/** Null for what is no such stream, or grows beyond all profiles. */
async function inflate(packed: Uint8Array): Promise<Uint8Array | null> {
  const stream = new Blob([packed as Uint8Array<ArrayBuffer>]).stream().pipeThrough(new DecompressionStream("deflate"));
  const reader = stream.getReader();
  const whole = new Uint8Array(MOST_BYTES);
  let length = 0;
  try {
    for (;;) {
      const { value } = await reader.read();
      if (value === undefined) return whole.slice(0, length);
      if (length + value.length > MOST_BYTES) break;
      whole.set(value, length);
      length += value.length;
    }
    await reader.cancel();
  } catch {
    // As without a profile, which is what browsers do.
  }
  return null;
}

const APP2 = 0xe2;
const START_OF_SCAN = 0xda;

/** ICC.1:2022, B.4: pieces of at most 64 KiB, each with its number, from 1, and how many there are. */
function ofJpeg(bytes: Uint8Array): Uint8Array | null {
  const pieces = new Map<number, Uint8Array>();
  let count = 0;
  const view = viewOf(bytes);
  for (let at = 2; at + 4 <= bytes.length; ) {
    const marker = view.getUint8(at + 1);
    if (marker === START_OF_SCAN) break;
    if (marker === 0xff) {
      at++; // A fill byte before a marker.
      continue;
    }
    const segment = bytes.subarray(at + 4, at + 2 + view.getUint16(at + 2));
    const [number = 0, all = 0] = segment.subarray(JPEG_MARK.length);
    if (marker === APP2 && asciiAt(segment, 0, JPEG_MARK.length) === JPEG_MARK) {
      pieces.set(number, segment.subarray(JPEG_MARK.length + 2));
      count = all;
    }
    at += 2 + view.getUint16(at + 2);
  }
  const whole = Array.from({ length: count }, (_, i) => pieces.get(i + 1));
  return count > 0 && whole.every((piece) => piece !== undefined) ? joinBytes(whole) : null;
}

function ofWebp(bytes: Uint8Array): Uint8Array | null {
  const view = viewOf(bytes);
  for (let at = 12; at + 8 <= bytes.length; ) {
    const length = view.getUint32(at + 4, true);
    if (asciiAt(bytes, at, 4) === "ICCP") return bytes.subarray(at + 8, at + 8 + length);
    at += 8 + length + (length & 1);
  }
  return null;
}

/** HEIF, 6.5.5: a picture may have both, of which the profile goes first. */
async function ofAvif(bytes: Uint8Array): Promise<ColorSource | null> {
  const { readAvifFile } = await import("./avif-file.ts");
  let coded: ColorSource | null = null;
  for (const { type, content } of readAvifFile(bytes).items[0]?.properties ?? []) {
    const kind = asciiAt(content, 0, 4);
    if (type !== "colr") continue;
    if (kind === "prof" || kind === "rICC") return content.subarray(4);
    const reader = new BoxReader(content.subarray(4));
    if (kind === "nclx") coded = [reader.uint(2), reader.uint(2)];
  }
  return coded;
}
