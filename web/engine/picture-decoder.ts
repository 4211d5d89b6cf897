/**
 * PNG, JPEG, WebP and AVIF to straight-alpha RGBA, by the same WebAssembly in the browser and in Node, so that the same file
 * gives the same bytes everywhere (spec section 7). Never by a canvas, which premultiplies and differs between machines.
 * Colour profiles and gamma chunks are ignored, as glTF asks of base colour textures.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { Picture } from "./engine-api.ts";
import { orientPixels } from "./exif-orientation.ts";
import { badPicture, type PictureFormat, readPictureHeader } from "./picture-header.ts";
import { decodePng } from "./png-codec.ts";

export { type PictureHeader, readPictureHeader } from "./picture-header.ts";

export interface DecodeOptions {
  /** Turns a photo upright as its EXIF tag says; default false, as glTF viewers show textures. */
  readonly orient?: boolean;
}

/**
 * Decodes a picture; the format is told by its content. Channels of more than 8 bits are rounded to 8. Throws "bad-picture"
 * naming the file, before anything of the picture's size is allocated when the header shows the fault.
 */
export async function decodePicture(bytes: Uint8Array, name: string, options: DecodeOptions = {}): Promise<Picture> {
  const header = await readPictureHeader(bytes, name);
  const { width, height } = header;
  let rgba: Uint8Array<ArrayBuffer>;
  try {
    rgba = pixelsOf(await decode(bytes, name, header.format));
  } catch (cause) {
    if (cause instanceof TexelcastError) throw cause;
    throw badPicture(
      name,
      "damaged",
      `its ${header.format.toUpperCase()} data is damaged`,
      "Save or download it again.",
      cause,
    );
  }
  if (rgba.length !== width * height * 4) throw badPicture(name, "damaged", "its data does not fit its size");
  return options.orient ? orientPixels(rgba, width, height, header.orientation) : { width, height, rgba };
}

/** A model's own texture is a PNG as a rule: its codec's glue comes with the engine, the others' by their first picture. */
const decode = async (bytes: Uint8Array, name: string, format: PictureFormat): Promise<Pixels> =>
  format === "png" ? decodePng(bytes) : (await import("./lossy-codecs.ts")).decodeLossy(bytes, name, format);

type Pixels = Pick<ImageData, "data">;

const pixelsOf = ({ data }: Pixels): Uint8Array<ArrayBuffer> =>
  new Uint8Array(data.buffer, data.byteOffset, data.byteLength) as Uint8Array<ArrayBuffer>;
