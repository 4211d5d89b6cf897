/** What draws words and SVG files, loaded when the first of them comes: most products are shown without. */
import type { ImageHandle, Session } from "../core/session.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import type { DrawnPictures } from "./drawn-pictures.ts";
import type { EngineLayer, EnginePicture, EngineText, TextMeasure } from "./engine-api.ts";
import { allPicturesOf } from "./layer-picture.ts";
import type { RasterTarget } from "./raster-size.ts";
import { RETRY_MS } from "./retry-pause.ts";

/** As `DrawnPictures`, which see. */
export class DrawnOnDemand {
  #pictures: DrawnPictures | null = null;
  #loading: Promise<DrawnPictures> | null = null;
  /** It could not be loaded: until then it is tried again by `load` alone, so that it is not said once a frame. */
  #missingUntil = 0;

  async addSvg(key: string, bytes: Uint8Array, name: string): Promise<{ width: number; height: number }> {
    return await (await this.#load()).addSvg(key, bytes, name);
  }

  async addFont(key: string, bytes: Uint8Array, name: string): Promise<{ readonly name: string }> {
    return await (await this.#load()).addFont(key, bytes, name);
  }

  async measure(text: EngineText): Promise<TextMeasure> {
    return await (await this.#load()).measure(text);
  }

  missing(picture: EnginePicture): readonly string[] {
    return typeof picture === "string" ? [] : (this.#pictures?.missing(picture) ?? []);
  }

  isDrawn(picture: EnginePicture): boolean {
    return typeof picture !== "string" || this.#pictures?.isDrawn(picture) === true;
  }

  removeSvg(key: string): void {
    this.#pictures?.removeSvg(key);
  }

  removeFont(key: string): void {
    this.#pictures?.removeFont(key);
  }

  isReady(layers: readonly EngineLayer[]): boolean {
    return this.#pictures?.isReady(layers) ?? (performance.now() < this.#missingUntil || !hasWords(layers));
  }

  async load(layers: readonly EngineLayer[]): Promise<void> {
    if (this.#pictures !== null || hasWords(layers)) await (await this.#load()).load(layers);
  }

  imageOf(key: string): ImageHandle | undefined {
    return this.#pictures?.imageOf(key);
  }

  resolve(
    layers: readonly EngineLayer[],
    session: Session,
    target: () => RasterTarget,
    report: (error: TexelcastError) => void,
  ): readonly EngineLayer[] {
    return this.#pictures?.resolve(layers, session, target, report) ?? layers;
  }

  sweep(session: Session): void {
    this.#pictures?.sweep(session);
  }

  async #load(): Promise<DrawnPictures> {
    this.#loading ??= import("./drawn-pictures.ts").then(({ DrawnPictures }) => new DrawnPictures());
    try {
      this.#pictures = await this.#loading;
      return this.#pictures;
    } catch (cause) {
      this.#loading = null;
      this.#missingUntil = performance.now() + RETRY_MS;
      throw new TexelcastError("missing-file", "What draws words and drawings could not be loaded.", {
        reason: "not-loaded",
        cause,
      });
    }
  }
}

const hasWords = (layers: readonly EngineLayer[]): boolean =>
  allPicturesOf(layers).some((picture) => typeof picture !== "string");
