/** Where a product may be printed, and how its numbers turn into those of the print. Plain data. */
import type { Quaternion, Vec3 } from "./engine-api.ts";

/** A part of the texture: corners in u and v (v down, 0 to 1), in order; the last is joined to the first. */
export interface UvZoneShape {
  readonly kind: "uv";
  readonly polygon: readonly (readonly [number, number])[];
}

/**
 * The surface inside a box of model space that faces the box's +Z, as a decal's box does: a wall's outside, and not its
 * inside. Metres; `rotation` is x, y, z, w, `size` full extents.
 */
export interface BoxZoneShape {
  readonly kind: "box";
  readonly position: Vec3;
  readonly rotation: Quaternion;
  readonly size: Vec3;
}

/**
 * "clip": nothing is printed further out than the zone's bleed. It holds on a material whose zones are all of this policy.
 * "warn": what lies further out is printed and reported.
 */
export type ZonePolicy = "clip" | "warn";

export interface PrintZone {
  readonly id: string;
  readonly name: string;
  /** glTF material index. */
  readonly material: number;
  readonly shape: UvZoneShape | BoxZoneShape;
  /** Millimetres of the print inside the zone's edge that should stay free of what must not be cut. */
  readonly safe: number;
  /** Millimetres of the print beyond the zone's edge that may be printed, for the cut to fall in. */
  readonly bleed: number;
  readonly policy: ZonePolicy;
}

/** What a zones file says; one file a product. */
export interface PrintZones {
  readonly texelcastZones: 1;
  /** Printed metres a metre of the model. */
  readonly printScale: number;
  /** Pixels an inch of print: below `least` is a violation, below `good` a warning. */
  readonly dpi: { readonly least: number; readonly good: number };
  readonly zones: readonly PrintZone[];
}

/** What holds where a product has no zones file: its true size, 150 and 300 DPI, printed everywhere. */
export const NO_ZONES: PrintZones = { texelcastZones: 1, printScale: 1, dpi: { least: 150, good: 300 }, zones: [] };
