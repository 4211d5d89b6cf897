/**
 * PNG row by row, for pictures larger than memory has room for: 8-bit RGBA, with sRGB and pHYs chunks. The same bytes
 * everywhere, and the same however many rows come at once: filters and compression are JavaScript's own whole numbers.
 */
import { Zlib } from "fflate";
import { joinBytes } from "./join-bytes.ts";
import { pngChunk } from "./png-chunk.ts";

const SIGNATURE = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);
const BYTES_PER_PIXEL = 4;
const COMPRESSION_LEVEL = 6;
/** PNG's rendering intent 0: "perceptual". */
const PERCEPTUAL = 0;
/** An IDAT chunk is written when it has so many. */
const CHUNK_BYTES = 2 ** 20;
const FILTERS = [0, 1, 2, 3, 4] as const;
/** Bytes of zeros that fflate begins behind: as far as deflate can refer back. */
const BYTES_BEFORE = 32768;
const NO_BYTE = 256;
const METRES_PER_INCH = 0.0254;

export class PngStream {
  readonly #rowBytes: number;
  readonly #parts: Uint8Array[] = [SIGNATURE];
  readonly #deflate: Zlib;
  #compressed: Uint8Array[] = [];
  #compressedBytes = 0;
  /** The row before, and one filtered row for each filter, its number before it. */
  #before: Uint8Array;
  readonly #tries: readonly Uint8Array[];

  /** @param dpi Pixels an inch across and down; null: the picture has no size. */
  constructor(width: number, height: number, dpi: readonly [number, number] | null) {
    this.#rowBytes = width * BYTES_PER_PIXEL;
    this.#before = new Uint8Array(this.#rowBytes);
    this.#tries = FILTERS.map((filter) => new Uint8Array(this.#rowBytes + 1).fill(filter, 0, 1));
    const header = new Uint8Array(13);
    const view = new DataView(header.buffer);
    view.setUint32(0, width);
    view.setUint32(4, height);
    // Eight bits, RGBA, deflate, adaptive filters, not interlaced.
    header.set([8, 6, 0, 0, 0], 8);
    this.#parts.push(pngChunk("IHDR", header), pngChunk("sRGB", Uint8Array.of(PERCEPTUAL)));
    if (dpi !== null) this.#parts.push(pngChunk("pHYs", pixelSize(dpi)));
    this.#deflate = new Zlib({ level: COMPRESSION_LEVEL });
    hideBytesBefore(this.#deflate);
    this.#deflate.ondata = (data) => {
      this.#compressed.push(data);
      this.#compressedBytes += data.length;
      if (this.#compressedBytes >= CHUNK_BYTES) this.#endChunk();
    };
  }

  /** The next rows, top down, packed: straight alpha. */
  addRows(rgba: Uint8Array): void {
    for (let at = 0; at < rgba.length; at += this.#rowBytes) {
      const row = rgba.subarray(at, at + this.#rowBytes);
      this.#deflate.push(this.#filter(row).slice(), false);
      this.#before.set(row);
    }
  }

  /** The whole file, once all rows have come. */
  finish(): Uint8Array<ArrayBuffer> {
    this.#deflate.push(new Uint8Array(0), true);
    this.#endChunk();
    this.#parts.push(pngChunk("IEND", new Uint8Array(0)));
    return joinBytes(this.#parts);
  }

  #endChunk(): void {
    if (this.#compressedBytes > 0) this.#parts.push(pngChunk("IDAT", joinBytes(this.#compressed)));
    this.#compressed = [];
    this.#compressedBytes = 0;
  }

  /** By the filter whose bytes are the smallest, as PNG's own specification advises. */
  #filter(row: Uint8Array): Uint8Array {
    const [none, sub, up, average, paeth] = this.#tries as readonly [
      Uint8Array,
      Uint8Array,
      Uint8Array,
      Uint8Array,
      Uint8Array,
    ];
    const before = this.#before;
    const sums = [0, 0, 0, 0, 0];
    const size = (byte: number): number => (byte < 128 ? byte : 256 - byte);
    const length = row.length;
    for (let i = 0; i < length; i++) {
      const x = row[i] as number;
      const a = i < BYTES_PER_PIXEL ? 0 : (row[i - BYTES_PER_PIXEL] as number);
      const b = before[i] as number;
      const c = i < BYTES_PER_PIXEL ? 0 : (before[i - BYTES_PER_PIXEL] as number);
      const toA = Math.abs(b - c);
      const toB = Math.abs(a - c);
      const toC = Math.abs(a + b - 2 * c);
      const nearest = toA <= toB && toA <= toC ? a : toB <= toC ? b : c;
      const bySub = (x - a) & 255;
      const byUp = (x - b) & 255;
      const byAverage = (x - ((a + b) >> 1)) & 255;
      const byPaeth = (x - nearest) & 255;
      none[i + 1] = x;
      sub[i + 1] = bySub;
      up[i + 1] = byUp;
      average[i + 1] = byAverage;
      paeth[i + 1] = byPaeth;
      sums[0] = (sums[0] as number) + size(x);
      sums[1] = (sums[1] as number) + size(bySub);
      sums[2] = (sums[2] as number) + size(byUp);
      sums[3] = (sums[3] as number) + size(byAverage);
      sums[4] = (sums[4] as number) + size(byPaeth);
    }
    return this.#tries[sums.indexOf(Math.min(...sums))] as Uint8Array;
  }
}

/**
 * fflate (0.8.3) takes those zeros for a part of the stream, and may write that what follows repeats them. No reader has them, so
 * such a file cannot be opened: of speckled pictures one in ten. What equals no byte is never repeated, and streams that
 * were right stay as they were. (To let it begin at 0 would change the bytes of every picture above 64 KiB, and so the hashes
 * that customers have approved.)
 */
function hideBytesBefore(deflate: Zlib): void {
  const inside = deflate as unknown as { b: Uint8Array | Uint16Array };
  inside.b = Uint16Array.from(inside.b).fill(NO_BYTE, 0, BYTES_BEFORE);
}

/** Whole pixels a metre, which is all that PNG can say. */
function pixelSize(dpi: readonly [number, number]): Uint8Array {
  const data = new Uint8Array(9);
  const view = new DataView(data.buffer);
  dpi.forEach((dots, axis) => {
    view.setUint32(axis * 4, Math.min(0x7fffffff, Math.max(1, Math.round(dots / METRES_PER_INCH))));
  });
  data[8] = 1; // the unit is the metre
  return data;
}
