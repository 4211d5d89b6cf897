/** Zones in the core's terms: metres of the model, and all corners in one list. */
import { type CoreZone, ZoneKinds } from "../core/abi.ts";
import { checkZones } from "./check-zones.ts";
import type { PrintZone, PrintZones } from "./print-zones.ts";

const MILLIMETRES = 1000;
export const METRES_PER_INCH = 0.0254;

/** Millimetres of the print as metres of the model. */
export const modelMetres = (millimetres: number, { printScale }: PrintZones): number =>
  millimetres / MILLIMETRES / printScale;

/** How many of something an inch of the print, that are so many a metre of the model. */
export const perInch = (perMetre: number, { printScale }: PrintZones): number =>
  (perMetre * METRES_PER_INCH) / printScale;

/** In the zones' own order. @throws TexelcastError "bad-argument" for what are no zones. */
export function coreZones(zones: PrintZones): {
  readonly zones: readonly Partial<CoreZone>[];
  readonly corners: Float32Array;
} {
  checkZones(zones);
  const corners: number[] = [];
  const made = zones.zones.map((zone) => coreZone(zone, zones, corners));
  return { zones: made, corners: Float32Array.from(corners) };
}

function coreZone(zone: PrintZone, zones: PrintZones, corners: number[]): Partial<CoreZone> {
  const { material, shape } = zone;
  const margins = { safe: modelMetres(zone.safe, zones), bleed: modelMetres(zone.bleed, zones) };
  if (shape.kind === "box") {
    const { position, rotation, size } = shape;
    return { kind: ZoneKinds.box, material, ...margins, positionModel: position, rotation, size };
  }
  const firstCorner = corners.length / 2;
  for (const corner of shape.polygon) corners.push(...corner);
  return { kind: ZoneKinds.uv, material, ...margins, firstCorner, cornerCount: shape.polygon.length };
}
