/** The same 32 × 16 pixels in each format whose EXIF browsers follow: as they are stored a camera held on its side made them. */
import { orientationBlock } from "../../web/engine/exif-block.ts";
import { joinBytes } from "../../web/engine/join-bytes.ts";
import { pngChunk } from "../../web/engine/png-chunk.ts";
import { encodePng } from "../../web/engine/png-encoder.ts";
import { jpegOf, webpOf } from "./encoded-pictures.ts";

/** As EXIF counts: a quarter turn. */
export const QUARTER_TURN = 6;

export const STORED = { width: 32, height: 16 } as const;

export interface TurnedPicture {
  readonly mimeType: string;
  readonly bytes: Uint8Array;
}

const text = (letters: string): Uint8Array => new TextEncoder().encode(letters);

export async function turnedPictures(orientation: number = QUARTER_TURN): Promise<readonly TurnedPicture[]> {
  const { width, height } = STORED;
  // Redder to the right, greener below.
  const rgba = Uint8Array.from({ length: width * height * 4 }, (_, i) => {
    const pixel = i >> 2;
    return [(pixel % width) * 8, Math.floor(pixel / width) * 16, 90, 255][i % 4] as number;
  });
  const block = orientationBlock(orientation);

  const png = await encodePng({ width, height, rgba });
  const header = 8 + 25;
  const turnedPng = joinBytes([png.subarray(0, header), pngChunk("eXIf", block), png.subarray(header)]);

  const jpeg = await jpegOf({ width, height, rgba }, 95);
  const exif = joinBytes([text("Exif\0\0"), block]);
  const turnedJpeg = joinBytes([
    jpeg.subarray(0, 2),
    Uint8Array.of(0xff, 0xe1, 0, 2 + exif.length),
    exif,
    jpeg.subarray(2),
  ]);

  const plain = await webpOf({ width, height, rgba });
  // The extended header (RFC 9649, 2.7): its flag says that there is EXIF.
  const extended = Uint8Array.of(0x08, 0, 0, 0, width - 1, 0, 0, height - 1, 0, 0);
  const turnedWebp = joinBytes([
    plain.subarray(0, 12),
    text("VP8X"),
    Uint8Array.of(extended.length, 0, 0, 0),
    extended,
    plain.subarray(12),
    text("EXIF"),
    Uint8Array.of(block.length, 0, 0, 0),
    block,
  ]);
  new DataView(turnedWebp.buffer).setUint32(4, turnedWebp.length - 8, true);

  return [
    { mimeType: "image/png", bytes: turnedPng },
    { mimeType: "image/jpeg", bytes: turnedJpeg },
    { mimeType: "image/webp", bytes: turnedWebp },
  ];
}
