/** The material that a print is made of, looked at before the engine is asked: it knows neither options nor zones files. */
import type { ModelInfo } from "../web/engine/engine-api.ts";
import type { PrintFileOptions } from "../web/engine/print-report.ts";
import type { PrintZones } from "../web/engine/print-zones.ts";
import { findPaintable, type WantedBy } from "./find-material.ts";

export interface PrintNames {
  /** Who asks for a material where no zone does; without it, `--material`. */
  readonly material?: WantedBy;
  /** What errors call the zones file. */
  readonly zones: string;
}

const DEFAULT_MATERIAL = 0;

/** The index of the material that is printed: its zone's, the one that is asked for, or the first. */
export function printedMaterial({ material, zone }: PrintFileOptions, zones: PrintZones | null): number {
  const ofZone = zone === undefined ? undefined : zones?.zones.find(({ id }) => id === zone)?.material;
  return ofZone ?? material ?? DEFAULT_MATERIAL;
}

/**
 * A zone says itself on which material it is; of one that is not there the engine tells.
 *
 * @throws TexelcastError "no-material", or with the code of the material's refusal, such as "no-uvs".
 */
export function checkPrintedMaterial(
  model: ModelInfo,
  { material, zone }: PrintFileOptions,
  zones: PrintZones | null,
  names: PrintNames,
): void {
  if (zone === undefined) {
    findPaintable(model, material ?? DEFAULT_MATERIAL, names.material);
    return;
  }
  const index = zones?.zones.findIndex(({ id }) => id === zone) ?? -1;
  const found = zones?.zones[index];
  if (found) findPaintable(model, found.material, { file: names.zones, field: `zones[${index}].material` });
}
