/** Pictures to PNG by the same WebAssembly encoder that the project itself uses. */

import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import encode, { init } from "@jsquash/png/encode.js";
import type { Picture } from "./svg.ts";

let started: Promise<unknown> | undefined;

export async function encodePng(picture: Picture): Promise<Uint8Array<ArrayBuffer>> {
  started ??= (async () => {
    const require = createRequire(import.meta.url);
    await init(
      await WebAssembly.compile(await readFile(require.resolve("@jsquash/png/codec/pkg/squoosh_png_bg.wasm"))),
    );
  })();
  await started;
  // The encoder reads width, height and data alone; Node has no ImageData to give.
  const image = { data: picture.rgba, width: picture.width, height: picture.height, colorSpace: "srgb" } as ImageData;
  return new Uint8Array(await encode(image));
}
