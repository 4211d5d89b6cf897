/**
 * Pictures that are drawn for the place where they lie: SVG files and words. A target's layers come in with such pictures
 * and go out with keys of images in the core, drawn at the size that fits the target. What no target shows any more is
 * thrown away.
 */

import type { ImageHandle, Session } from "../core/session.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import { checkText } from "./check-text.ts";
import type { EngineLayer, EnginePicture, EngineText, Picture, Projector, TextMeasure } from "./engine-api.ts";
import { isShippedFontAddress } from "./font-address.ts";
import { allPicturesOf, withPictures } from "./layer-picture.ts";
import { badPicture } from "./picture-header.ts";
import { footprintTexels, LEAST_RASTER_PIXELS, type RasterTarget, rasterSize } from "./raster-size.ts";
import { RETRY_MS } from "./retry-pause.ts";
import { readShippedFont, type ShippedFontId } from "./shipped-fonts.ts";
import { canDraw } from "./svg-cost.ts";
import { describeFault, readSvgFile, type SvgFile, svgFonts } from "./svg-file.ts";
import { renderSvg, startSvgRenderer, svgRendererReady } from "./svg-renderer.ts";
import { drawText, measureText } from "./text-drawing.ts";
import { FontShelf } from "./text-fonts.ts";
import { fontsFor, missingCharacters } from "./text-runs.ts";

const REMEMBERED_TEXTS = 1000;

interface Drawn {
  readonly key: string;
  readonly image: ImageHandle;
  /** Turns true whenever a target shows it. */
  used: boolean;
}

export class DrawnPictures {
  readonly #svgs = new Map<string, SvgFile & { readonly number: number }>();
  readonly #svgFonts = new Map<ShippedFontId, Uint8Array>();
  readonly #shelf = new FontShelf();
  /** By what was drawn: file or words, and size. */
  readonly #drawn = new Map<string, Drawn>();
  readonly #imageByKey = new Map<string, ImageHandle>();
  /** What could not be drawn, so that it is said once and not once a frame. */
  readonly #failed = new Set<string>();
  /** Words whose fonts could not be loaded, and when they may be tried again by themselves, so that it is not said once a frame. */
  readonly #unloaded = new Map<string, number>();
  /** Words whose fonts are known to be there: asked in every frame of a drag. */
  readonly #loaded = new Set<string>();
  #count = 0;

  /** Takes in an SVG file; replaces one of the same key. Rejects with "bad-picture". */
  async addSvg(key: string, bytes: Uint8Array, name: string): Promise<{ width: number; height: number }> {
    const file = await readSvgFile(bytes, name, (id) => this.#readSvgFont(id));
    for (const id of file.fonts) await this.#readSvgFont(id);
    this.#unloaded.clear();
    this.#count += 1;
    this.#svgs.set(key, { ...file, number: this.#count });
    return { width: file.width, height: file.height };
  }

  /** Whether a picture has no pixels of its own: words, and drawings. */
  isDrawn(picture: EnginePicture): boolean {
    return typeof picture !== "string" || this.#svgs.has(picture);
  }

  removeSvg(key: string): void {
    this.#svgs.delete(key);
  }

  async addFont(key: string, bytes: Uint8Array, name: string): Promise<{ readonly name: string }> {
    const info = await this.#shelf.add(key, bytes, name);
    this.#failed.clear();
    this.#unloaded.clear();
    this.#loaded.clear();
    return info;
  }

  removeFont(key: string): void {
    this.#loaded.clear();
    this.#shelf.remove(key);
  }

  async measure(text: EngineText): Promise<TextMeasure> {
    checkText(text, "text");
    await this.#loadFonts(text);
    // The connection is back, or was never gone: what is shown next is tried whole.
    this.#unloaded.clear();
    if (this.#shelf.get(text.font) === undefined) {
      throw new TexelcastError("bad-argument", `There is no font “${text.font}” to measure a text in.`, {
        field: "font",
        value: text.font,
        reason: "no-font",
      });
    }
    return measureText(text, this.#shelf);
  }

  /** The characters of words that none of their fonts has; the fonts must be loaded. */
  missing(text: EngineText): readonly string[] {
    return missingCharacters(text.text, text.font, this.#shelf);
  }

  /** Whether `load` has nothing to do for these layers, or has just failed to. */
  isReady(layers: readonly EngineLayer[]): boolean {
    const now = performance.now();
    const waits = (text: EngineText): boolean => now < (this.#unloaded.get(fontsOfText(text)) ?? 0);
    return this.#wordsOf(layers).every((text) => this.#canDraw(text) || waits(text));
  }

  /**
   * Loads what the layers' words need, also what failed before. Rejects with "missing-file" and "bad-font"; what could be
   * loaded, is.
   */
  async load(layers: readonly EngineLayer[]): Promise<void> {
    const texts = this.#wordsOf(layers).filter((text) => !this.#canDraw(text));
    const loading = texts.map(async (text) => {
      const what = fontsOfText(text);
      try {
        await Promise.all([startSvgRenderer(), this.#loadFonts(text)]);
        this.#unloaded.delete(what);
      } catch (error) {
        // A font that is no font stays none; what could not be fetched may be there once the connection is back.
        const isFault = error instanceof TexelcastError && error.reason !== "not-loaded";
        this.#unloaded.set(what, isFault ? Number.POSITIVE_INFINITY : performance.now() + RETRY_MS);
        throw error;
      }
    });
    const failed = (await Promise.allSettled(loading)).find((result) => result.status === "rejected");
    if (failed) throw failed.reason;
  }

  /** The image of a key that `resolve` gave. */
  imageOf(key: string): ImageHandle | undefined {
    return this.#imageByKey.get(key);
  }

  /** The layers of a target with its own images for drawings and words. Those whose fonts are not there yet stay as they are. */
  resolve(
    layers: readonly EngineLayer[],
    session: Session,
    target: () => RasterTarget,
    report: (error: TexelcastError) => void,
  ): readonly EngineLayer[] {
    if (!allPicturesOf(layers).some((picture) => this.isDrawn(picture))) return layers;
    const change = (picture: EnginePicture, projector: Projector | undefined): EnginePicture => {
      if (!this.isDrawn(picture) || projector === undefined) return picture;
      return this.#keyFor(picture, footprintTexels(projector, target()), session, report) ?? picture;
    };
    return layers.map((layer) => withPictures(layer, change));
  }

  /** Throws away what was not shown since the last call. To be called once every target has been drawn. */
  sweep(session: Session): void {
    for (const [what, drawn] of this.#drawn) {
      if (!drawn.used) {
        this.#drawn.delete(what);
        this.#imageByKey.delete(drawn.key);
        session.destroyImage(drawn.image);
      }
      drawn.used = false;
    }
  }

  #keyFor(
    picture: EnginePicture,
    footprint: readonly [number, number],
    session: Session,
    report: (error: TexelcastError) => void,
  ): string | undefined {
    const plan = typeof picture === "string" ? this.#planSvg(picture, footprint) : this.#planText(picture, footprint);
    if (plan === undefined || this.#failed.has(plan.what)) return undefined;
    let drawn = this.#drawn.get(plan.what);
    if (drawn === undefined) {
      try {
        const { width, height, rgba } = plan.draw();
        this.#count += 1;
        drawn = { key: `drawn:${this.#count}`, image: session.createImage(width, height, rgba), used: true };
      } catch (thrown) {
        if (thrown instanceof TexelcastError && thrown.code === "engine-crashed") throw thrown;
        this.#failed.add(plan.what);
        report(
          TexelcastError.wrap(thrown, "bad-picture", `“${plan.name}” could not be drawn.`, { subject: plan.name }),
        );
        return undefined;
      }
      this.#drawn.set(plan.what, drawn);
      this.#imageByKey.set(drawn.key, drawn.image);
    }
    drawn.used = true;
    return drawn.key;
  }

  #planSvg(key: string, footprint: readonly [number, number]): Plan | undefined {
    const file = this.#svgs.get(key);
    if (file === undefined) return undefined;
    const aspect = file.width / file.height;
    let [width, height] = rasterSize(aspect, footprint);
    // Less sharp rather than not at all; at the least size the file was checked when it came.
    while (!canDraw(file.cost, width, height) && Math.max(width, height) > LEAST_RASTER_PIXELS) {
      [width, height] = [Math.max(1, width >> 1), Math.max(1, height >> 1)];
    }
    // What comes to less than half a pixel's height the renderer takes for nothing, and refuses.
    if (aspect > 1.9 * width) width = Math.ceil(aspect);
    const draw = (): Picture => {
      try {
        const buffers = file.fonts.map((id) => this.#svgFonts.get(id)).filter((bytes) => bytes !== undefined);
        return renderSvg(file.svg, width, svgFonts(buffers));
      } catch (thrown) {
        throw badPicture(file.name, ...describeFault(thrown, file.svg), thrown);
      }
    };
    return { what: `svg ${file.number} ${width} ${height}`, name: file.name, draw };
  }

  async #readSvgFont(id: ShippedFontId): Promise<Uint8Array> {
    const bytes = this.#svgFonts.get(id) ?? (await readShippedFont(id));
    this.#svgFonts.set(id, bytes);
    return bytes;
  }

  #planText(text: EngineText, [wide, high]: readonly [number, number]): Plan | undefined {
    if (!this.#canDraw(text) || this.#shelf.get(text.font) === undefined) return undefined;
    const aspect = wide / high;
    const [width, height] = rasterSize(aspect, [wide, high]);
    const draw = (): Picture => renderSvg(drawText(text, this.#shelf, width, height, aspect), width);
    // Two boxes of nearly one form are two pictures: what is drawn must not hang on what was drawn before.
    return { what: `text ${JSON.stringify([text, width, height, aspect])}`, name: text.text, draw };
  }

  #wordsOf(layers: readonly EngineLayer[]): EngineText[] {
    return allPicturesOf(layers).filter((picture) => typeof picture !== "string");
  }

  /** True also for words in a font that is not there and may be given later. */
  #canDraw(text: EngineText): boolean {
    const what = fontsOfText(text);
    if (this.#loaded.has(what)) return true;
    const lacks = (key: string): boolean => this.#shelf.get(key) === undefined && isShippedFontAddress(key);
    if (!svgRendererReady() || fontsFor(text.text, text.font, this.#shelf).some(lacks)) return false;
    if (this.#loaded.size >= REMEMBERED_TEXTS) this.#loaded.clear();
    this.#loaded.add(what);
    return true;
  }

  async #loadFonts(text: EngineText): Promise<void> {
    // The text's own font tells which others stand in for it.
    await this.#shelf.load(text.font);
    await Promise.all(fontsFor(text.text, text.font, this.#shelf).map((key) => this.#shelf.load(key)));
  }
}

const fontsOfText = ({ text, font }: EngineText): string => JSON.stringify([font, text]);

interface Plan {
  /** All that decides the pixels. */
  readonly what: string;
  /** For errors. */
  readonly name: string;
  readonly draw: () => Picture;
}
