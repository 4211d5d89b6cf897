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
  #module: WebAssembly.Module | null = null;
  #started = false;
  #complaint = "";

  constructor(name: Lossy, load: () => Promise<CodecGlue>) {
    this.#name = name;
    this.#load = load;
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
        await glue.init(this.#module, { print: printErr, printErr });
        this.#started = true;
      }
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

const jpegCodec = new EmscriptenCodec("jpeg", () => import("@jsquash/jpeg/decode.js"));
const webpCodec = new EmscriptenCodec("webp", () => import("@jsquash/webp/decode.js"));
const avifCodec = new EmscriptenCodec("avif", () => import("@jsquash/avif/decode.js"));

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
