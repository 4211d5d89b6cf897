/** JPEG and WebP to pixels. Loaded by the first picture of either kind. */
import { compileCodec } from "./codec-wasm.ts";
import { checkJpegScans } from "./jpeg-scans.ts";

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
      return await glue.default(bytes as unknown as ArrayBuffer);
    } catch (cause) {
      // libjpeg ends by exit(), after which its instance holds the half-read picture: the next one gets a fresh one.
      this.#started = false;
      throw new Error(this.#complaint || String(cause), { cause });
    }
  }
}

const jpegCodec = new EmscriptenCodec("jpeg", () => import("@jsquash/jpeg/decode.js"));
const webpCodec = new EmscriptenCodec("webp", () => import("@jsquash/webp/decode.js"));

/** Rejects with "bad-picture" naming a JPEG of too many scans, and with what the codec says of data that it cannot read. */
export function decodeLossy(bytes: Uint8Array, name: string, format: "jpeg" | "webp"): Promise<ImageData> {
  if (format === "webp") return webpCodec.decode(bytes);
  checkJpegScans(bytes, name);
  return jpegCodec.decode(bytes);
}
