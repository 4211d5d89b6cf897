/** PNG that few have: of 16 bits a channel, and of damaged texts, profiles or animations. */
import { decode, decode_rgba16 } from "@jsquash/png/codec/pkg/squoosh_png.js";
import { cleanPng } from "./clean-png.ts";
import { keepStack, type PngExports } from "./png-codec.ts";

type Pixels = Pick<ImageData, "data">;

/** Throws what the codec says of bytes that it cannot read. */
export function decodeSpecialPng(codec: PngExports, bytes: Uint8Array, isDeep: boolean): Pixels {
  const read = (png: Uint8Array): Pixels => keepStack(codec, () => (isDeep ? { data: decodeDeep(png) } : decode(png)));
  try {
    if (isDeep) return read(bytes);
  } catch {
    // As of others.
  }
  return read(cleanPng(bytes));
}

/** 16 bits a channel, each to the nearest of 8. By itself the codec would cut the lower ones off, which darkens by half a step. */
function decodeDeep(bytes: Uint8Array): Uint8ClampedArray<ArrayBuffer> {
  const picture = decode_rgba16(bytes);
  const deep = picture.data;
  picture.free();
  const data = new Uint8ClampedArray(deep.length);
  // 65535 is 255 × 257. Such an array takes the nearest whole number.
  for (let i = 0; i < data.length; i++) data[i] = (deep[i] as number) / 257;
  return data;
}
