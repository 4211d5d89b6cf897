/** A colour profile as each format holds it, in bytes that hang on the profile alone. */
import { asciiCodes } from "./ascii-codes.ts";
import { JPEG_MARK } from "./color-mention.ts";
import { joinBytes } from "./join-bytes.ts";
import { pngChunk } from "./png-chunk.ts";
import { storedZlib } from "./stored-zlib.ts";

/** Under a name, which has to be there. */
export const pngProfile = (profile: Uint8Array): Uint8Array =>
  pngChunk("iCCP", joinBytes([asciiCodes("ICC\0\0"), storedZlib(profile)]));

/** By numbers of ITU-T H.273, with the one for RGB that is RGB, and the whole range. */
export const pngColorNumbers = (primaries: number, curve: number): Uint8Array =>
  pngChunk("cICP", Uint8Array.of(primaries, curve, 0, 1));

/** A segment's length has 16 bits and counts itself. */
const MOST_OF_PIECE = 0xffff - 2 - JPEG_MARK.length - 2;

export function jpegProfile(profile: Uint8Array): Uint8Array {
  const count = Math.ceil(profile.length / MOST_OF_PIECE);
  const segments = Array.from({ length: count }, (_, i) => {
    const piece = profile.subarray(i * MOST_OF_PIECE, (i + 1) * MOST_OF_PIECE);
    const length = 2 + JPEG_MARK.length + 2 + piece.length;
    const head = Uint8Array.of(0xff, 0xe2, length >> 8, length & 0xff);
    return joinBytes([head, asciiCodes(JPEG_MARK), Uint8Array.of(i + 1, count), piece]);
  });
  return joinBytes(segments);
}

export function webpProfile(profile: Uint8Array): Uint8Array {
  const chunk = new Uint8Array(8 + profile.length + (profile.length & 1));
  chunk.set(asciiCodes("ICCP"));
  new DataView(chunk.buffer).setUint32(4, profile.length, true);
  chunk.set(profile, 8);
  return chunk;
}

export function avifProfile(profile: Uint8Array): Uint8Array {
  const whole = joinBytes([new Uint8Array(4), asciiCodes("colrprof"), profile]);
  new DataView(whole.buffer).setUint32(0, whole.length);
  return whole;
}
