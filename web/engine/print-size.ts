/** How large a print file is: the texture's texels and the density that they have on the printed surface. */
import type { ZoneSurface } from "../core/abi.ts";
import { MAX_TEXTURE_SIZE } from "../core/sizes.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import { targetSize } from "./base-picture.ts";
import { perInch } from "./core-zones.ts";
import type { PrintFileOptions } from "./print-report.ts";
import { type PrintContext, scaledRaster, withTarget } from "./print-target.ts";
import type { PrintZone } from "./print-zones.ts";
import type { RasterTarget } from "./raster-size.ts";

/** Side of the texture on which zones are measured, texels: larger ones tell the same to some thousandths. */
const SURVEY_SIDE = 1024;
const LEAST_SIDE = 64;
/** Flat art is made for this many pixels an inch where nothing else is said. */
export const DEFAULT_DPI = 300;

export type Size = readonly [number, number];

/** What is to be printed, measured. */
export interface PrintSurvey {
  readonly size: Size;
  /** Of the texture on which it was measured. */
  readonly surveyed: Size;
  /** Of the zone, or of all the material's surface. Metric and `up` are in texels of `size`, the rectangle in those of `surveyed`. */
  readonly surface: ZoneSurface;
  /** Texels an inch of print across and down, on the average. */
  readonly dpi: readonly [number, number];
  readonly raster: RasterTarget;
}

/** @throws TexelcastError "bad-size" where the texture would have to be larger than there are; "bad-argument". */
export async function surveyPrint(
  context: PrintContext,
  material: number,
  zone: PrintZone | null,
  options: PrintFileOptions,
): Promise<PrintSurvey> {
  const asked = askedSize(options);
  const dpi = options.dpi ?? (options.flattened ? DEFAULT_DPI : undefined);
  const own = await targetSize(context.model, { material });
  if (asked !== null || dpi === undefined) return surveyAt(context, material, zone, asked ?? own);
  const rough = await surveyAt(context, material, zone, within(own, SURVEY_SIDE));
  return surveyAt(context, material, zone, sizeFor(dpi, rough, own, context));
}

function askedSize({ size }: PrintFileOptions): Size | null {
  return typeof size === "number" ? [size, size] : (size ?? null);
}

/** The same form, its longer side at most so long. */
function within([width, height]: Size, side: number): Size {
  const share = Math.min(1, side / Math.max(width, height));
  return [Math.max(1, Math.round(width * share)), Math.max(1, Math.round(height * share))];
}

/** The least longer side, a power of two, at which both axes have as many texels an inch. */
function sizeFor(dpi: number, rough: PrintSurvey, own: Size, context: PrintContext): Size {
  const longer = Math.max(...rough.size);
  const density = Math.min(...rough.dpi);
  for (let side = LEAST_SIDE; side <= MAX_TEXTURE_SIZE; side *= 2) {
    // A little less will do: a texture that was made for its product should not come out at twice the size.
    if ((density * side) / longer >= dpi * 0.999) {
      const share = side / Math.max(...own);
      return [Math.max(1, Math.round(own[0] * share)), Math.max(1, Math.round(own[1] * share))];
    }
  }
  const most = Math.floor((density * MAX_TEXTURE_SIZE) / longer);
  throw new TexelcastError(
    "bad-size",
    `${dpi} DPI would need a texture larger than ${MAX_TEXTURE_SIZE} × ${MAX_TEXTURE_SIZE} texels.`,
    {
      field: "dpi",
      value: String(dpi),
      hint:
        most < 1
          ? `Look whether the zones file has the right print scale: ${context.zones.printScale} makes of the whole texture less than a texel an inch.`
          : `Ask for ${most} DPI or less, or unwrap the model so that its printed parts take more of the texture.`,
    },
  );
}

async function surveyAt(
  context: PrintContext,
  material: number,
  zone: PrintZone | null,
  size: Size,
): Promise<PrintSurvey> {
  const [width, height] = within(size, SURVEY_SIDE);
  const index = zone === null ? null : context.zones.zones.indexOf(zone);
  const base = [0, 0, 0, 0] as const;
  const options = { material, width, height, base };
  const { surface, raster } = await withTarget(context, options, null, (target) => ({
    surface: target.core.zoneSurface(index),
    raster: target.raster,
  }));
  if (surface.texels === 0 || surface.area <= 0) {
    if (zone === null) {
      const what = `Material ${material} of “${context.model.name}”`;
      throw new TexelcastError("bad-zones", `${what} has no surface to print at ${width} × ${height} texels.`, {
        subject: context.model.name,
        field: "material",
        value: String(material),
        reason: "no-surface",
        hint: "Ask for a larger texture, or unwrap the model so that its parts take more of it.",
      });
    }
    throw new TexelcastError("bad-zones", `The zone “${zone.name}” has no surface to print.`, {
      field: "zone",
      value: zone.id,
      reason: "no-surface",
      hint: "A zone's polygon must lie on the material's charts in the texture, a box around its surface.",
    });
  }
  const [across, skew, down] = surface.metric as [number, number, number];
  const [scaleX, scaleY] = [width / size[0], height / size[1]];
  const metric = [across * scaleX * scaleX, skew * scaleX * scaleY, down * scaleY * scaleY];
  const inch = (squared: number): number => (squared > 0 ? perInch(1 / Math.sqrt(squared), context.zones) : 0);
  return {
    size,
    surveyed: [width, height],
    surface: { ...surface, metric, up: [(surface.up[0] ?? 0) / scaleX, (surface.up[1] ?? 0) / scaleY] },
    dpi: [inch(metric[0] as number), inch(metric[2] as number)],
    raster: scaledRaster(raster, size[0], size[1]),
  };
}
