/**
 * SVG to straight-alpha RGBA by resvg in WebAssembly: the same bytes in the browser and in Node. It runs no scripts, fetches
 * nothing, and sees no fonts but those that it is given. Loaded by the first drawing.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import { compileCodec } from "./codec-wasm.ts";
import type { Picture } from "./engine-api.ts";
import { runRenewable } from "./renewable-wasm.ts";

type ResvgPackage = typeof import("@resvg/resvg-wasm");

export interface SvgFonts {
  readonly buffers: readonly Uint8Array[];
  /** The family that stands for families that are not among them. */
  readonly family: string;
}

let resvg: ResvgPackage | undefined;
let renew = (): void => {};
let starting: Promise<void> | undefined;

/** Makes `renderSvg` ready. Rejects with "missing-file"; a later call tries again. */
export function startSvgRenderer(): Promise<void> {
  starting ??= start().catch((error: unknown) => {
    starting = undefined;
    throw error;
  });
  return starting;
}

async function start(): Promise<void> {
  const [loaded, module] = await Promise.all([import("@resvg/resvg-wasm"), compileCodec("svg")]);
  renew = await runRenewable(module, () => loaded.initWasm(module));
  resvg = loaded;
}

/** Whether a drawing can be drawn at once, without the renderer being loaded first. */
export const svgRendererReady = (): boolean => resvg !== undefined;

export interface SvgDocument {
  /** As the document gives them, CSS pixels. */
  readonly width: number;
  readonly height: number;
  /** With nothing reused, no styles, numbers for all, and its words as paths. */
  readonly simplified: string;
}

/** Throws what resvg says of a document that it cannot read. */
export function readSvg(svg: string, fonts: SvgFonts | null = null): SvgDocument {
  return withDocument(svg, {}, fonts, (document) => {
    const simplified = document.toString();
    // Its own width and height are whole pixels: of an icon one pixel wide they would say nothing.
    const [, width, height] = /^<svg width="(.+?)" height="(.+?)"/.exec(simplified) ?? [];
    return { width: Number(width), height: Number(height), simplified };
  });
}

/**
 * Draws a document `width` pixels wide, its height in its own proportions. `startSvgRenderer` must have come first. Throws
 * what resvg says of a document that it cannot read.
 */
export function renderSvg(svg: string, width: number, fonts: SvgFonts | null = null): Picture {
  const fitTo = { mode: "width", value: width } as const;
  return withDocument(svg, { fitTo }, fonts, (document) => {
    const image = document.render();
    const picture = { width: image.width, height: image.height, rgba: unpremultiplied(image.pixels) };
    image.free();
    return picture;
  });
}

type Options = NonNullable<ConstructorParameters<ResvgPackage["Resvg"]>[1]>;

function withDocument<Result>(
  svg: string,
  options: Options,
  fonts: SvgFonts | null,
  use: (document: InstanceType<ResvgPackage["Resvg"]>) => Result,
): Result {
  if (resvg === undefined) throw new TexelcastError("internal", "A drawing came before its renderer was loaded.");
  const font = {
    fontBuffers: [...(fonts?.buffers ?? [])],
    ...(fonts && { defaultFontFamily: fonts.family, sansSerifFamily: fonts.family }),
  };
  try {
    const document = new resvg.Resvg(svg, { ...options, font });
    // Not in a "finally": after a panic of Rust's, freeing fails too, and would hide what went wrong.
    const result = use(document);
    document.free();
    return result;
  } catch (thrown) {
    if (isTrap(thrown)) renew();
    throw thrown;
  }
}

/** Whether the renderer stopped amid its work: at what it does not expect, or in parts too deep in one another for its stack. */
export const isTrap = (thrown: unknown): boolean =>
  thrown instanceof WebAssembly.RuntimeError || thrown instanceof RangeError;

function unpremultiplied(pixels: Uint8Array): Uint8Array<ArrayBuffer> {
  const rgba = new Uint8Array(pixels);
  for (let index = 0; index < rgba.length; index += 4) {
    const alpha = rgba[index + 3] ?? 0;
    if (alpha === 0 || alpha === 255) continue;
    for (let channel = index; channel < index + 3; channel++) {
      rgba[channel] = Math.min(255, Math.round(((rgba[channel] ?? 0) * 255) / alpha));
    }
  }
  return rgba;
}
