/** The WebAssembly files of the packages that decode pictures and geometry, and of the one that draws SVG. */
import { type PackageFile, readPackageFile } from "./package-file.ts";

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
  avif: {
    specifier: "@jsquash/avif/codec/dec/avif_dec.wasm",
    url: () => new URL("@jsquash/avif/codec/dec/avif_dec.wasm", import.meta.url),
  },
  draco: {
    specifier: "draco3dgltf/draco_decoder_gltf.wasm",
    url: () => new URL("draco3dgltf/draco_decoder_gltf.wasm", import.meta.url),
  },
  basis: {
    specifier: "three/examples/jsm/libs/basis/basis_transcoder.wasm",
    url: () => new URL("three/examples/jsm/libs/basis/basis_transcoder.wasm", import.meta.url),
  },
  svg: {
    specifier: "@resvg/resvg-wasm/index_bg.wasm",
    url: () => new URL("@resvg/resvg-wasm/index_bg.wasm", import.meta.url),
  },
} satisfies Record<string, PackageFile>;

export type CodecName = keyof typeof FILES;

/** The bytes of a codec's WebAssembly. Rejects with "missing-file". */
export async function readCodec(name: CodecName): Promise<Uint8Array<ArrayBuffer>> {
  return await readPackageFile(FILES[name], `The ${name} decoder`);
}

/** A codec's WebAssembly, compiled. Rejects with "missing-file". */
export async function compileCodec(name: CodecName): Promise<WebAssembly.Module> {
  return await WebAssembly.compile(await readCodec(name));
}
