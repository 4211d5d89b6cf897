/**
 * The WebAssembly files of the packages that decode pictures and geometry. They are found and compiled here, not by the
 * packages' own glue, so that the browser and Node run the very same bytes and a bundler sees every file.
 */
import { inNode, readBytes } from "../core/read-bytes.ts";

/** A file of a package: its name for Node's resolver, and its address for a bundler (which needs it as a literal). */
interface WasmFile {
  readonly specifier: string;
  readonly url: () => URL;
}

const FILES = {
  png: {
    specifier: "@jsquash/png/codec/pkg/squoosh_png_bg.wasm",
    url: () => new URL("@jsquash/png/codec/pkg/squoosh_png_bg.wasm", import.meta.url),
  },
  jpeg: {
    specifier: "@jsquash/jpeg/codec/dec/mozjpeg_dec.wasm",
    url: () => new URL("@jsquash/jpeg/codec/dec/mozjpeg_dec.wasm", import.meta.url),
  },
  webp: {
    specifier: "@jsquash/webp/codec/dec/webp_dec.wasm",
    url: () => new URL("@jsquash/webp/codec/dec/webp_dec.wasm", import.meta.url),
  },
  draco: {
    specifier: "draco3dgltf/draco_decoder_gltf.wasm",
    url: () => new URL("draco3dgltf/draco_decoder_gltf.wasm", import.meta.url),
  },
} satisfies Record<string, WasmFile>;

export type CodecName = keyof typeof FILES;

/** The bytes of a codec's WebAssembly. Rejects with "missing-file". */
export async function readCodec(name: CodecName): Promise<Uint8Array<ArrayBuffer>> {
  const { specifier, url } = FILES[name];
  return await readBytes(inNode ? await resolveInNode(specifier) : url(), `The ${name} decoder`);
}

/** A codec's WebAssembly, compiled. Rejects with "missing-file". */
export async function compileCodec(name: CodecName): Promise<WebAssembly.Module> {
  return await WebAssembly.compile(await readCodec(name));
}

async function resolveInNode(specifier: string): Promise<string> {
  // Not a literal, so that a bundler for the browser does not try to follow it.
  const moduleName = "node:module";
  const { createRequire } = (await import(/* @vite-ignore */ moduleName)) as typeof import("node:module");
  return createRequire(import.meta.url).resolve(specifier);
}
