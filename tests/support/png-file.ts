/** PNG files made byte by byte, so that every colour type and bit depth of the format can be tested. */
import { crc32, deflateSync } from "node:zlib";

export interface PngParts {
  readonly width: number;
  readonly height: number;
  readonly bitDepth: 1 | 2 | 4 | 8 | 16;
  /** PNG's own number: 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA. */
  readonly colorType: 0 | 2 | 3 | 4 | 6;
  /** The rows' bytes, samples packed, without filter bytes; of an interlaced file those of one pass after the other. */
  readonly rows: readonly (readonly number[])[];
  readonly interlaced?: boolean;
  readonly palette?: readonly number[];
  /** The tRNS chunk. */
  readonly transparency?: readonly number[];
  /** Other chunks in front of the pixels. */
  readonly extra?: readonly (readonly [type: string, data: Uint8Array])[];
}

export function makePng(parts: PngParts): Uint8Array {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(parts.width, 0);
  header.writeUInt32BE(parts.height, 4);
  header[8] = parts.bitDepth;
  header[9] = parts.colorType;
  header[12] = parts.interlaced ? 1 : 0;
  const filtered = Buffer.concat(parts.rows.map((row) => Buffer.from([0, ...row])));
  return new Uint8Array(
    Buffer.concat([
      Buffer.from("\x89PNG\r\n\x1a\n", "latin1"),
      pngChunk("IHDR", header),
      ...(parts.palette === undefined ? [] : [pngChunk("PLTE", Uint8Array.from(parts.palette))]),
      ...(parts.transparency === undefined ? [] : [pngChunk("tRNS", Uint8Array.from(parts.transparency))]),
      ...(parts.extra ?? []).map(([type, data]) => pngChunk(type, data)),
      pngChunk("IDAT", deflateSync(filtered)),
      pngChunk("IEND", new Uint8Array()),
    ]),
  );
}

export function pngChunk(type: string, data: Uint8Array): Buffer {
  const body = Buffer.concat([Buffer.from(type, "latin1"), data]);
  const chunk = Buffer.alloc(body.length + 8);
  chunk.writeUInt32BE(data.length, 0);
  body.copy(chunk, 4);
  chunk.writeUInt32BE(crc32(body), body.length + 4);
  return chunk;
}

/** An 8-bit RGBA picture whose pixel at (x, y) is what `colour` says. */
export function paintPng(
  width: number,
  height: number,
  colour: (x: number, y: number) => readonly [number, number, number, number],
): Uint8Array {
  const rows = Array.from({ length: height }, (_, y) => Array.from({ length: width }, (__, x) => colour(x, y)).flat());
  return makePng({ width, height, bitDepth: 8, colorType: 6, rows });
}

/** A picture of one colour. */
export function solidPng(width: number, height: number, colour: readonly [number, number, number, number]): Uint8Array {
  return paintPng(width, height, () => colour);
}
