/**
 * Clipping to zones: a material's layers as one group whose mask is the zones' cover. A group that is passed through and
 * fully shown composites as its layers would without it, so inside the zones no byte changes.
 */
import type { EngineDecalLayer, EngineGroupLayer, EngineLayer, Picture } from "./engine-api.ts";
import type { PrintZones } from "./print-zones.ts";

/** Keys that no asset and no layer of a design has: they are longer than a design allows. */
const RESERVED = "texelcast zones ".padEnd(240, "·");
export const ZONE_PICTURE = `${RESERVED}picture`;

/** Whether a material's layers are cut off at its zones: it has some, and all of them say so. */
export function clipsMaterial(zones: PrintZones | null, material: number): boolean {
  const own = zones?.zones.filter((zone) => zone.material === material) ?? [];
  return own.length > 0 && own.every(({ policy }) => policy === "clip");
}

/** A rectangle of a texture, texels. */
export interface TexelRect {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** The part of the cover that is not empty, as white of that alpha, and where it lies in the target. */
export interface ZoneCover {
  readonly rect: TexelRect;
  readonly picture: Picture;
}

/** `cover`: one byte a texel. Of an empty one, a single clear texel. */
export function zoneCover(cover: Uint8Array, width: number): ZoneCover {
  const rect = boundsOf(cover, width);
  const rgba = new Uint8Array(rect.width * rect.height * 4).fill(255);
  for (let y = 0; y < rect.height; y++) {
    for (let x = 0; x < rect.width; x++) {
      rgba[(y * rect.width + x) * 4 + 3] = cover[(rect.y + y) * width + rect.x + x] ?? 0;
    }
  }
  return { rect, picture: { width: rect.width, height: rect.height, rgba } };
}

function boundsOf(cover: Uint8Array, width: number): TexelRect {
  const height = cover.length / width;
  let [left, right, top, bottom] = [width, -1, height, -1];
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      if (cover[y * width + x] === 0) continue;
      left = Math.min(left, x);
      right = Math.max(right, x);
      top = Math.min(top, y);
      bottom = y;
    }
  }
  if (right < 0) return { x: 0, y: 0, width: 1, height: 1 };
  return { x: left, y: top, width: right - left + 1, height: bottom - top + 1 };
}

/**
 * The layers of one material, cut off where the cover ends.
 *
 * @param place The cover's rectangle in u and v of the whole texture.
 */
export function clippedLayers(layers: readonly EngineLayer[], material: number, place: TexelRect): EngineLayer[] {
  if (layers.length === 0) return [];
  const laidOn = { visible: true, opacity: 1, blendSpace: "srgb", lockAlpha: false } as const;
  const cover: EngineDecalLayer = {
    ...laidOn,
    id: `${RESERVED}cover`,
    type: "decal",
    material,
    blend: "erase",
    asset: ZONE_PICTURE,
    filter: "nearest",
    wrap: "none",
    flipX: false,
    flipY: false,
    backfaces: true,
    angleFade: [90, 90],
    occlusion: "none",
    projector: {
      kind: "uv",
      center: [place.x + place.width / 2, place.y + place.height / 2],
      size: [place.width, place.height],
      angle: 0,
    },
  };
  // A mask begins as full. Inverted it begins as empty, and shows what is erased from it.
  const group: EngineGroupLayer = {
    ...laidOn,
    id: `${RESERVED}clip`,
    type: "group",
    blend: "normal",
    isolated: false,
    layers,
    mask: { layers: [cover], invert: true },
  };
  return [group];
}
