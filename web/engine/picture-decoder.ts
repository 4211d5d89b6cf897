/**
 * PNG, JPEG and WebP to straight-alpha RGBA, by the same WebAssembly in the browser and in Node, so that the same file
 * gives the same bytes everywhere (spec section 7). Never by a canvas, which premultiplies and differs between machines.
 * Colour profiles and gamma chunks are ignored, as glTF asks of base colour textures.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import { compileCodec } from "./codec-wasm.ts";
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
 * Decodes a picture; the format is told by its content. 16-bit channels keep their high byte. Throws "bad-picture"
 * naming the file, before anything of the picture's size is allocated when the header shows the fault.
 */
export async function decodePicture(bytes: Uint8Array, name: string, options: DecodeOptions = {}): Promise<Picture> {
  const header = readPictureHeader(bytes, name);
  const { width, height } = header;
  let rgba: Uint8Array<ArrayBuffer>;
  try {
    rgba = await DECODERS[header.format](bytes);
  } catch (cause) {
    if (cause instanceof TexelcastError) throw cause;
    throw badPicture(name, `its ${header.format.toUpperCase()} data is damaged`, "Save or download it again.", cause);
  }
  if (rgba.length !== width * height * 4) throw badPicture(name, "its data does not fit its size");
  return options.orient ? orientPixels(rgba, width, height, header.orientation) : { width, height, rgba };
}

interface CodecGlue {
  readonly init: (module: WebAssembly.Module, options: object) => Promise<unknown>;
  readonly default: (bytes: ArrayBuffer) => Promise<ImageData>;
}

/** One of @jsquash's Emscripten codecs. Its glue, like its module, is loaded by the first picture of its kind. */
class EmscriptenCodec {
  readonly #name: "jpeg" | "webp";
  readonly #load: () => Promise<CodecGlue>;
  #module: WebAssembly.Module | null = null;
  #started = false;
  #complaint = "";

  constructor(name: "jpeg" | "webp", load: () => Promise<CodecGlue>) {
    this.#name = name;
    this.#load = load;
  }

  async decode(bytes: Uint8Array): Promise<Uint8Array<ArrayBuffer>> {
    const glue = await this.#load();
    this.#module ??= await compileCodec(this.#name);
    this.#complaint = "";
    try {
      if (!this.#started) {
        // libjpeg writes its complaints to standard error, where they would look like faults of the page.
        const printErr = (line: string): void => {
          this.#complaint = line;
        };
        await glue.init(this.#module, { print: printErr, printErr });
        this.#started = true;
      }
      return pixelsOf(await glue.default(bytes as unknown as ArrayBuffer));
    } catch (cause) {
      // libjpeg ends by exit(), after which its instance holds the half-read picture: the next one gets a fresh one.
      this.#started = false;
      throw new Error(this.#complaint || String(cause), { cause });
    }
  }
}

const jpegCodec = new EmscriptenCodec("jpeg", () => import("@jsquash/jpeg/decode.js"));
const webpCodec = new EmscriptenCodec("webp", () => import("@jsquash/webp/decode.js"));

const DECODERS: Readonly<Record<PictureFormat, (bytes: Uint8Array) => Promise<Uint8Array<ArrayBuffer>>>> = {
  // A model's own texture is a PNG as a rule: its codec's glue comes with the engine, and its module is loaded all the same.
  png: async (bytes) => pixelsOf(await decodePng(bytes)),
  jpeg: (bytes) => jpegCodec.decode(bytes),
  webp: (bytes) => webpCodec.decode(bytes),
};

function pixelsOf(image: ImageData): Uint8Array<ArrayBuffer> {
  return new Uint8Array(image.data.buffer, image.data.byteOffset, image.data.byteLength) as Uint8Array<ArrayBuffer>;
}
