/** What a print's numbers mean to those who made the design: violations, warnings, and what to do about them. */

import { materialsOf } from "./layer-materials.ts";
import type { EnginePaintingLayer } from "./layer-tree.ts";
import type { LayerPrint, PrintFinding, PrintFindingCode } from "./print-report.ts";
import type { PrintZones } from "./print-zones.ts";
import { clipsMaterial } from "./zone-clip.ts";

/** Shares below it are rounding along charts' borders. */
const SHARE_LIMIT = 0.01;
/** Percent of mean stretch. */
const STRETCH_LIMIT = 25;

export interface Findings {
  readonly violations: readonly PrintFinding[];
  readonly warnings: readonly PrintFinding[];
}

/**
 * @param materials The names of the model's, by their indices.
 * @param unpaintable Those that cannot be painted, and why.
 * @param missing Characters that no font has, by the ids of the layers whose words have them.
 */
export function findingsOf(
  zones: PrintZones,
  materials: readonly string[],
  layers: readonly LayerPrint[],
  unpaintable: ReadonlyMap<number, string>,
  sources: readonly EnginePaintingLayer[],
  missing: ReadonlyMap<string, readonly string[]>,
): Findings {
  const violations: PrintFinding[] = [];
  const warnings: PrintFinding[] = [];
  violations.push(...lostZones(zones, materials));
  for (const source of sources) {
    for (const material of materialsOf(source)) {
      const why = unpaintable.get(material);
      if (why === undefined) continue;
      const message = `Material ${material} cannot be printed: ${why}.`;
      violations.push(finding("not-printable", source.id, null, message, "Move it to another part.", material, 0));
    }
  }
  for (const [id, characters] of missing) if (characters.length > 0) violations.push(lackOf(id, characters));
  for (const layer of layers) {
    for (const { isViolation, ...rest } of layerFindings(zones, layer))
      (isViolation ? violations : warnings).push(rest);
  }
  return { violations, warnings };
}

function lackOf(id: string, characters: readonly string[]): PrintFinding {
  const message = `No font has ${characters.join(" ")}: placeholders would be printed instead.`;
  const hint = "Use a font that has them, or other words.";
  return { ...finding("missing-characters", id, null, message, hint, characters.length, 0), characters };
}

/** Zones of materials that the model does not have. */
export function lostZones({ zones }: PrintZones, materials: readonly string[]): PrintFinding[] {
  const list = materials.map((name, index) => (name === "" ? String(index) : `${index} (${name})`)).join(", ");
  return zones
    .filter(({ material }) => material >= materials.length)
    .map(({ id, material }) => {
      const message = `The zone “${id}” is on material ${material}, which the model does not have.`;
      const hint = `Give it one of the model's: ${list}.`;
      return finding("zone-without-material", null, id, message, hint, material, materials.length - 1);
    });
}

interface LayerFinding extends PrintFinding {
  readonly isViolation: boolean;
}

function* layerFindings(zones: PrintZones, layer: LayerPrint): Generator<LayerFinding> {
  const { id } = layer;
  const violation = (...rest: FindingRest): LayerFinding => ({ ...of(id, rest), isViolation: true });
  const warning = (...rest: FindingRest): LayerFinding => ({ ...of(id, rest), isViolation: false });
  const main = layer.zones.reduce<{ id: string; share: number } | null>(
    (most, zone) => (most === null || zone.share > most.share ? zone : most),
    null,
  );
  const zone = main?.id ?? null;
  const isClipped = layer.materials.every((material) => clipsMaterial(zones, material));
  const isAllOutside = layer.outsideZones === 1 && isClipped;
  if (layer.areaCm2 === 0 || isAllOutside) {
    const hint = isAllOutside ? "Move it into a zone." : "Move it onto the surface.";
    yield violation("nothing-printed", null, "No part of it is printed.", hint, 0, 0);
    return;
  }
  if (layer.type === "fill") return;
  if (layer.dpi !== null) yield* densityFindings(zones, layer.dpi, zone, violation, warning);
  if (zones.zones.length > 0 && layer.outsideZones > SHARE_LIMIT) {
    const share = percent(layer.outsideZones);
    if (isClipped) {
      const message = `${share} % of it lies outside of the print area and is cut off.`;
      yield warning("outside-zones", zone, message, "Move it in, or make it smaller.", share, percent(SHARE_LIMIT));
    } else {
      const message = `${share} % of it lies outside of the print area.`;
      yield violation("outside-zones", zone, message, "Move it in, or make it smaller.", share, percent(SHARE_LIMIT));
    }
  }
  if (layer.inSafeMargin > SHARE_LIMIT) {
    const share = percent(layer.inSafeMargin);
    const message = `${share} % of it lies so near to the print area's edge that it may be cut.`;
    yield warning("safe-margin", zone, message, "Move what matters inward.", share, percent(SHARE_LIMIT));
  }
  const lost = layer.clipped - layer.hidden;
  if (lost > SHARE_LIMIT) {
    const message = `${percent(lost)} % of the picture lies on no surface.`;
    yield warning("clipped", zone, message, "Move it in from the edge, or make it smaller.", percent(lost), 1);
  }
  if (layer.hidden > SHARE_LIMIT) {
    const message = `${percent(layer.hidden)} % of the picture is hidden: behind something, or on a side that faces away.`;
    yield warning("hidden", zone, message, "Turn it to face the surface, or move it.", percent(layer.hidden), 1);
  }
  if (layer.stretch !== null && layer.stretch.mean > STRETCH_LIMIT) {
    const value = Math.round(layer.stretch.mean);
    const message = `The picture is stretched by ${value} % on the surface.`;
    const hint = "Give it the picture's own proportions, and let it face the surface.";
    yield warning("stretched", zone, message, hint, value, STRETCH_LIMIT);
  }
  if (layer.overlapTexels > 0) {
    const message = "This mark will appear twice: parts of the model share their place in the texture.";
    const hint = "Move it to where the model is unwrapped by itself.";
    yield warning("appears-twice", zone, message, hint, layer.overlapTexels, 0);
  }
  if (layer.mirroredTexels > 0) {
    const message = "The texture lies mirrored there: printed flat, it reads from right to left.";
    const hint = "Print this zone flattened, or have the model unwrapped unmirrored.";
    yield warning("mirrored", zone, message, hint, layer.mirroredTexels, 0);
  }
}

type Make = (...rest: FindingRest) => LayerFinding;

/** The mean decides: the least is that of a spot, on the side that turns away. */
function* densityFindings(
  { dpi: limits }: PrintZones,
  dpi: { readonly least: number; readonly mean: number },
  zone: string | null,
  violation: Make,
  warning: Make,
): Generator<LayerFinding> {
  const hint = "Use a picture with more pixels, or make it smaller.";
  const mean = Math.round(dpi.mean);
  const least = Math.round(dpi.least);
  if (mean < limits.least) {
    yield violation("low-dpi", zone, `Only ${mean} DPI: it will print blurred.`, hint, mean, limits.least);
  } else if (mean < limits.good) {
    yield warning("low-dpi", zone, `${mean} DPI: fine detail will be soft.`, hint, mean, limits.good);
  } else if (least < limits.least) {
    yield warning("low-dpi", zone, `Down to ${least} DPI where it is stretched most.`, hint, least, limits.least);
  }
}

type FindingRest = [
  code: PrintFindingCode,
  zone: string | null,
  message: string,
  hint: string,
  value: number,
  limit: number,
];

const of = (layer: string, [code, zone, message, hint, value, limit]: FindingRest): PrintFinding =>
  finding(code, layer, zone, message, hint, value, limit);

function finding(
  code: PrintFindingCode,
  layer: string | null,
  zone: string | null,
  message: string,
  hint: string,
  value: number,
  limit: number,
): PrintFinding {
  return { code, layer, zone, message, hint, value, limit };
}

/** A whole percent, never 0 for something. */
const percent = (share: number): number => Math.max(1, Math.round(share * 100));
