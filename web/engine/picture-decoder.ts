/**
 * PNG, JPEG, WebP and AVIF to straight-alpha RGBA, by the same WebAssembly in the browser and in Node, so that the same file
 * gives the same bytes everywhere (spec section 7). Never by a canvas, which premultiplies and differs between machines.
 * Colour profiles are ignored in models' textures, as glTF asks, and followed in what people bring; gamma chunks are ignored in both.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { Picture } from "./engine-api.ts";
import { badPicture, type PictureFormat, readPictureHeader } from "./picture-header.ts";
import { decodePng } from "./png-codec.ts";

export { type PictureHeader, readPictureHeader } from "./picture-header.ts";

export interface DecodeOptions {
  /** Upright as EXIF says, and its colours made sRGB from what its profile says; default false, as glTF viewers show textures. */
  readonly asSeen?: boolean;
}

/**
 * Decodes a picture; the format is told by its content. Channels of more than 8 bits are rounded to 8. Throws "bad-picture"
 * naming the file, before anything of the picture's size is allocated when the header shows the fault.
 */
export async function decodePicture(bytes: Uint8Array, name: string, options: DecodeOptions = {}): Promise<Picture> {
  const header = await readPictureHeader(bytes, name);
  const { width, height } = header;
  // Fetched while the picture is decoded. Where it cannot be, that is told below.
  if (options.asSeen) void import("./picture-as-seen.ts").catch(() => {});
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
  if (!options.asSeen) return { width, height, rgba };
  return await (await import("./picture-as-seen.ts")).asSeen(rgba, header, bytes, name);
}

/** A model's own texture is a PNG as a rule: its codec's glue comes with the engine, the others' by their first picture. */
const decode = async (bytes: Uint8Array, name: string, format: PictureFormat): Promise<Pixels> =>
  format === "png" ? decodePng(bytes) : (await import("./lossy-codecs.ts")).decodeLossy(bytes, name, format);

type Pixels = Pick<ImageData, "data">;

const pixelsOf = ({ data }: Pixels): Uint8Array<ArrayBuffer> =>
  new Uint8Array(data.buffer, data.byteOffset, data.byteLength) as Uint8Array<ArrayBuffer>;
