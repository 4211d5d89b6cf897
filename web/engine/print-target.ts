/** What prints and measurements ask of the engine: a material's texture, drawn by itself at any size. */
import type { Session } from "../core/session.ts";
import { loadBasePicture } from "./base-picture.ts";
import type { EngineLayer, EnginePicture, TargetOptions } from "./engine-api.ts";
import type { LoadedModel } from "./model-loader.ts";
import { OpenTarget, type TargetPictures, type TextureWindow } from "./open-target.ts";
import type { PrintZones } from "./print-zones.ts";
import type { RasterTarget } from "./raster-size.ts";

/** The engine as it was when the call came. */
export interface PrintContext {
  readonly session: Session;
  readonly model: LoadedModel;
  readonly layers: readonly EngineLayer[];
  readonly zones: PrintZones;
  /** Those that the page shows, by material. */
  readonly targets: ReadonlyMap<number, OpenTarget>;
  readonly pictures: (report: (error: Error) => void) => TargetPictures;
  /** SVG and words: they have no pixels of their own. */
  readonly isDrawn: (picture: EnginePicture) => boolean;
  /** Of words the characters that no font has. */
  readonly missing: (picture: EnginePicture) => readonly string[];
  /** Throws when the work shall end. */
  readonly checkpoint: () => void;
  readonly onProgress?: ((share: number) => void) | undefined;
}

/** Opens a target of its own for the time of `use`. */
export async function withTarget<Result>(
  context: PrintContext,
  options: TargetOptions,
  window: TextureWindow | null,
  use: (target: OpenTarget) => Result | Promise<Result>,
): Promise<Result> {
  const { session, model, checkpoint } = context;
  const target = await OpenTarget.open(options, { session, model, checkpoint, onProgress: undefined }, window);
  try {
    return await use(target);
  } finally {
    if (!session.core.crashed) target.destroy();
  }
}

/** Draws the layers. What the engine refuses of them is thrown: a print must not lack what the page would only report. */
export function drawWhole(context: PrintContext, target: OpenTarget): void {
  const errors: Error[] = [];
  const report = (error: Error): void => void errors.push(error);
  target.draw(context.layers, 0, context.pictures(report), report, Number.POSITIVE_INFINITY);
  if (errors[0] !== undefined) throw errors[0];
}

/** The base of all windows of a texture. */
export const printBase = (context: PrintContext, material: number, base: "model" | "none") =>
  loadBasePicture(context.model, { material, base: base === "none" ? [0, 0, 0, 0] : "model" });

/** How drawings are measured on a texture, from a smaller one of the same form. */
export function scaledRaster(raster: RasterTarget, width: number, height: number): RasterTarget {
  return { ...raster, width, height, texelsPerMetre: (raster.texelsPerMetre * width) / raster.width };
}
