/** Straight-alpha RGBA to PNG, by the same WebAssembly in the browser and in Node: the same bytes everywhere. */
import { encode } from "@jsquash/png/codec/pkg/squoosh_png.js";
import { TexelcastError } from "../core/texelcast-error.ts";
import type { Picture } from "./engine-api.ts";
import { keepStack, pngCodec } from "./png-codec.ts";

/** Bits of a channel. */
const BIT_DEPTH = 8;

/** Encodes without loss; the colour under zero alpha is kept. Throws "bad-argument" when the bytes do not fit the size. */
export async function encodePng(picture: Picture): Promise<Uint8Array<ArrayBuffer>> {
  const { width, height, rgba } = picture;
  if (width < 1 || height < 1 || rgba.length !== width * height * 4) {
    throw new TexelcastError("bad-argument", `A ${width} × ${height} picture cannot have ${rgba.length} bytes.`, {
      field: "rgba",
      value: String(rgba.length),
    });
  }
  const codec = await pngCodec();
  try {
    return keepStack(codec, () => encode(rgba, width, height, BIT_DEPTH)) as Uint8Array<ArrayBuffer>;
  } catch (cause) {
    throw new TexelcastError("out-of-budget", `A ${width} × ${height} picture could not be encoded as PNG.`, { cause });
  }
}
