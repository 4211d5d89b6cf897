/**
 * How many pixels a drawing gets: as many as make it sharp where it lies, in powers of two, so that a drag draws it anew
 * only now and then. It hangs on the projector and the target alone, never on what was drawn before (spec.md, 7).
 */
import type { Projector, Vec3 } from "./engine-api.ts";
import { turnBy } from "./exact-turn.ts";

/** What of a target decides. */
export interface RasterTarget {
  /** Texels. */
  readonly width: number;
  readonly height: number;
  readonly texelsPerMetre: number;
  readonly boundsMin: Vec3;
  readonly boundsMax: Vec3;
}

/** Pixels along the longer side. */
export const LEAST_RASTER_PIXELS = 64;
export const MOST_RASTER_PIXELS = 4096;
/** Texels lie askew to a drawing's pixels: with only one for each, edges would blur. */
const MARGIN = 1.5;
/**
 * Up to so many pixels a drawing has twice that margin, since its own softness is seen beside a texel's: small words are then 36 dB
 * and more like those of a large texture, and were 26 to 34.
 */
const CHEAP_PIXELS = 2 ** 20;

/** Width and height of the projector's picture where it lies, in texels. */
export function footprintTexels(projector: Projector, target: RasterTarget): readonly [number, number] {
  const density = target.texelsPerMetre;
  switch (projector.kind) {
    case "planar":
      return [projector.size[0] * density, projector.size[1] * density];
    case "cylindrical":
      return [((projector.arc * Math.PI) / 180) * projector.radius * density, projector.height * density];
    case "uv":
      return [projector.size[0] * target.width, projector.size[1] * target.height];
    case "perspective": {
      const half = turnBy((projector.fov * Math.PI) / 360);
      const distance = Math.min(projector.far, Math.max(projector.near, reachOf(projector.position, target)));
      const height = 2 * distance * (half.sin / half.cos) * density;
      return [height * projector.aspect, height];
    }
  }
}

/**
 * Pixels of a drawing of that aspect (width by height) on a footprint of so many texels: neither side has fewer than the
 * footprint asks for, until the longer one comes to its most.
 */
export function rasterSize(aspect: number, [wide, high]: readonly [number, number]): readonly [number, number] {
  const longer = Math.max(wide, high * aspect, 1) * MARGIN * (aspect >= 1 ? 1 : 1 / aspect);
  const narrow = Math.min(aspect, 1 / aspect);
  const margin = (side: number): number => (side * side * narrow <= CHEAP_PIXELS ? 2 : 1);
  let side = LEAST_RASTER_PIXELS;
  while (side < longer * margin(2 * side) && side < MOST_RASTER_PIXELS) side *= 2;
  return aspect >= 1 ? [side, Math.max(1, Math.round(side / aspect))] : [Math.max(1, Math.round(side * aspect)), side];
}

/** From the eye to the middle of the model. */
function reachOf(eye: Vec3, { boundsMin, boundsMax }: RasterTarget): number {
  let sum = 0;
  for (const axis of [0, 1, 2] as const) {
    const away = (boundsMin[axis] + boundsMax[axis]) / 2 - eye[axis];
    sum += away * away;
  }
  return Math.sqrt(sum);
}
