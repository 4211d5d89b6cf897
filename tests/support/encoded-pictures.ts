/** Pictures as JPEG and WebP, by the encoders of @jsquash, whose decoders the engine has. */
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { default as encodeJpeg, init as startJpegEncoder } from "@jsquash/jpeg/encode.js";
import webpEncoderFactory from "@jsquash/webp/codec/enc/webp_enc.js";
import { defaultOptions as webpDefaults } from "@jsquash/webp/meta.js";
import { initEmscriptenModule } from "@jsquash/webp/utils.js";
import type { Picture } from "../../web/engine/engine-api.ts";

const require = createRequire(import.meta.url);
const compile = (specifier: string): Promise<WebAssembly.Module> =>
  WebAssembly.compile(readFileSync(require.resolve(specifier)));

/** @param quality up to 100; the encoder's own where there is none */
export async function jpegOf({ width, height, rgba }: Picture, quality?: number): Promise<Uint8Array> {
  await startJpegEncoder(await compile("@jsquash/jpeg/codec/enc/mozjpeg_enc.wasm"));
  const pixels = { width, height, data: new Uint8ClampedArray(rgba), colorSpace: "srgb" } as ImageData;
  return new Uint8Array(await encodeJpeg(pixels, quality === undefined ? {} : { quality }));
}

/** @param quality up to 100; without losses where there is none, the colour under zero alpha too */
export async function webpOf({ width, height, rgba }: Picture, quality?: number): Promise<Uint8Array> {
  const encoder = await initEmscriptenModule(
    webpEncoderFactory,
    await compile("@jsquash/webp/codec/enc/webp_enc.wasm"),
  );
  const options = quality === undefined ? { lossless: 1, exact: 1 } : { quality };
  return new Uint8Array(encoder.encode(rgba, width, height, { ...webpDefaults, ...options }) ?? []);
}
