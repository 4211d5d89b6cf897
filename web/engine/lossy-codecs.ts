/** JPEG, WebP and AVIF to pixels, and the headers of the first two. Loaded by the first picture of any of them. */
import { compileCodec } from "./codec-wasm.ts";
import { readJpegHeader } from "./jpeg-header.ts";
import { checkJpegScans } from "./jpeg-scans.ts";
import { readWebpHeader } from "./webp-header.ts";

interface CodecGlue {
  readonly init: (module: WebAssembly.Module, options: object) => Promise<unknown>;
  readonly default: (bytes: ArrayBuffer) => Promise<ImageData | null>;
}

type Lossy = "jpeg" | "webp" | "avif";

/** One of @jsquash's Emscripten codecs. Its glue, like its module, is loaded by the first picture of its kind. */
class EmscriptenCodec {
  readonly #name: Lossy;
  readonly #load: () => Promise<CodecGlue>;
  readonly #lasts: boolean;
  #module: WebAssembly.Module | null = null;
  #started = false;
  #complaint = "";

  /** @param lasts Whether one instance decodes all pictures, else each has its own. */
  constructor(name: Lossy, load: () => Promise<CodecGlue>, lasts: boolean) {
    this.#name = name;
    this.#load = load;
    this.#lasts = lasts;
  }

  async decode(bytes: Uint8Array): Promise<ImageData> {
    const glue = await this.#load();
    this.#module ??= await compileCodec(this.#name);
    this.#complaint = "";
    try {
      if (!this.#started) {
        // libjpeg writes its complaints to standard error, where they would look like faults of the page.
        const printErr = (line: string): void => {
          this.#complaint = line;
        };
        const starting = glue.init(this.#module, { print: printErr, printErr });
        if (this.#lasts) await starting;
        this.#started = this.#lasts;
      }
      // The instance that was begun last: of one that does not last nobody else may begin another in between.
      const decoded = await glue.default(bytes as unknown as ArrayBuffer);
      if (decoded === null) throw new Error("It holds no picture.");
      return decoded;
    } catch (cause) {
      // libjpeg ends by exit(), after which its instance holds the half-read picture: the next one gets a fresh one.
      this.#started = false;
      throw new Error(this.#complaint || String(cause), { cause });
    }
  }
}

const jpegCodec = new EmscriptenCodec("jpeg", () => import("@jsquash/jpeg/decode.js"), true);
const webpCodec = new EmscriptenCodec("webp", () => import("@jsquash/webp/decode.js"), true);
// Where it cannot make RGB of a picture it gives what its memory held: in a fresh one no other picture, which could be somebody else's.
const avifCodec = new EmscriptenCodec("avif", () => import("@jsquash/avif/decode.js"), false);

/** By format. Each throws a PictureFault where the picture cannot be used, a RangeError where the file ends too early. */
export const LOSSY_HEADERS = { jpeg: readJpegHeader, webp: readWebpHeader } as const;

/** Rejects with "bad-picture" naming a JPEG of too many scans, and with what the codec says of data that it cannot read. */
export async function decodeLossy(bytes: Uint8Array, name: string, format: Lossy): Promise<Pick<ImageData, "data">> {
  if (format === "webp") return webpCodec.decode(bytes);
  if (format === "avif") {
    const { decodeAvif } = await import("./avif-header.ts");
    return decodeAvif(bytes, (clean) => avifCodec.decode(clean));
  }
  checkJpegScans(bytes, name);
  return jpegCodec.decode(bytes);
}
