/** Fonts ready to be shaped with, by the key under which layers name them. Loaded when the first text needs them. */
import type { Font } from "harfbuzzjs";
import { inNode } from "../core/read-bytes.ts";
import { isShippedFontAddress } from "./font-address.ts";
import { badFont, readFontHeader } from "./font-file.ts";
import { type PackageFile, readPackageFile } from "./package-file.ts";
import {
  readShippedFont,
  SHIPPED_FONTS,
  type ShippedFontId,
  shippedFontAddress,
  shippedFontOf,
} from "./shipped-fonts.ts";

export type HarfBuzz = typeof import("harfbuzzjs");

/** A font; lengths in its own units, of which its em has `unitsPerEm`. */
export interface TextFont {
  readonly font: Font;
  readonly unitsPerEm: number;
  /** Above the baseline. */
  readonly ascender: number;
  /** Below the baseline, as a negative number. */
  readonly descender: number;
  readonly lineGap: number;
  /** Of the fonts that stand in for it. */
  readonly weight: 400 | 700;
  readonly covers: (codePoint: number) => boolean;
}

/** What is known of a user's font once it was taken in. */
export interface FontInfo {
  /** As the file calls it; "" without one. */
  readonly name: string;
}

const FULL_NAME = 4;

export class FontShelf {
  readonly #fonts = new Map<string, TextFont>();
  readonly #loading = new Map<string, Promise<void>>();

  /** The font of a key or of an address "texelcast:fonts/…"; undefined while it is not there. */
  get(key: string): TextFont | undefined {
    return this.#fonts.get(key);
  }

  /** Takes in a font file; replaces one of the same key. Rejects with "bad-font" naming the file. */
  async add(key: string, bytes: Uint8Array, name: string): Promise<FontInfo> {
    readFontHeader(bytes, name);
    const font = makeFont(await loadHarfBuzz(), bytes, 400);
    const { face } = font.font;
    if (face.collectUnicodes().length === 0)
      throw badFont(name, "no-characters", "it has no characters", "Use another font.");
    this.#fonts.set(key, font);
    return { name: face.getName(FULL_NAME, "en") };
  }

  remove(key: string): void {
    this.#fonts.delete(key);
  }

  /** Loads a font that comes with Texelcast; other keys are left alone. Rejects with "missing-file". */
  async load(key: string): Promise<void> {
    const id = shippedFontOf(key);
    if (id === undefined) {
      if (isShippedFontAddress(key))
        throw badFont(key, "not-shipped", "this version has no such font", "Choose another font.");
      return;
    }
    if (this.#fonts.has(key)) return;
    let loading = this.#loading.get(key);
    if (loading === undefined) {
      // A load that failed may be tried again.
      loading = this.#loadShipped(id).finally(() => this.#loading.delete(key));
      this.#loading.set(key, loading);
    }
    await loading;
  }

  async #loadShipped(id: ShippedFontId): Promise<void> {
    const [harfBuzz, bytes] = await Promise.all([loadHarfBuzz(), readShippedFont(id)]);
    this.#fonts.set(shippedFontAddress(id), makeFont(harfBuzz, bytes, SHIPPED_FONTS[id].weight));
  }
}

/** As the library's own glue finds it, so that a bundler keeps one file for both. */
const WASM: PackageFile = {
  specifier: "harfbuzzjs/dist/harfbuzz.wasm",
  url: () => new URL("harfbuzzjs/dist/harfbuzz.wasm", import.meta.url),
};

let harfBuzz: HarfBuzz | undefined;

/** The shaping library, whose WebAssembly is loaded by the first text. Rejects with "missing-file"; a later call tries again. */
export async function loadHarfBuzz(): Promise<HarfBuzz> {
  if (harfBuzz === undefined) {
    // The library fetches it while its module begins, and a module that has failed to begin once is never begun again: it is only
    // asked for when it can be had, and then comes out of the browser's cache.
    if (!inNode) await readPackageFile(WASM, "What shapes words");
    harfBuzz = await import("harfbuzzjs");
  }
  return harfBuzz;
}

/** The shaping library, which a font that is there has brought along. */
export function loadedHarfBuzz(): HarfBuzz {
  if (harfBuzz === undefined) throw new Error("Text was set before its fonts were loaded.");
  return harfBuzz;
}

function makeFont(hb: HarfBuzz, bytes: Uint8Array, weight: 400 | 700): TextFont {
  const face = new hb.Face(new hb.Blob(bytes));
  const font = new hb.Font(face);
  const { ascender, descender, lineGap } = font.hExtents();
  const known = new Map<number, boolean>();
  const covers = (codePoint: number): boolean => {
    let covered = known.get(codePoint);
    if (covered === undefined) {
      covered = font.nominalGlyph(codePoint) !== undefined;
      known.set(codePoint, covered);
    }
    return covered;
  };
  return { font, unitsPerEm: face.upem, ascender, descender, lineGap, weight, covers };
}
