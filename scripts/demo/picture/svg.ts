/** SVG to pixels by resvg in WebAssembly: no fonts, no system libraries, the same bytes on every machine. */

import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { initWasm, Resvg } from "@resvg/resvg-wasm";

/** Straight-alpha RGBA, row 0 at the top. */
export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
}

let started: Promise<void> | undefined;

/** Loads the renderer; once is enough, and more does no harm. */
function startRenderer(): Promise<void> {
  started ??= (async () => {
    const require = createRequire(import.meta.url);
    await initWasm(await readFile(require.resolve("@resvg/resvg-wasm/index_bg.wasm")));
  })();
  return started;
}

/** Draws an SVG document `width` pixels wide; its height follows the document's own proportions. */
export async function renderSvg(svg: string, width: number): Promise<Picture> {
  await startRenderer();
  const document = new Resvg(svg, { fitTo: { mode: "width", value: width }, font: { loadSystemFonts: false } });
  const image = document.render();
  const rgba = new Uint8ClampedArray(image.pixels);
  const picture = { width: image.width, height: image.height, rgba };
  image.free();
  document.free();
  unpremultiply(rgba);
  return picture;
}

function unpremultiply(rgba: Uint8ClampedArray): void {
  for (let index = 0; index < rgba.length; index += 4) {
    const alpha = rgba[index + 3] as number;
    if (alpha === 0 || alpha === 255) continue;
    for (let channel = 0; channel < 3; channel++) {
      rgba[index + channel] = Math.round(((rgba[index + channel] as number) * 255) / alpha);
    }
  }
}
