/**
 * How much work a design is for the press, in whole pictures: one that covers the product. A brush's dab is as much of one as it
 * covers, so that a customer may paint, and thousands of large dabs do not keep the press from everybody else.
 */
import { type Design, resolveLayers } from "../../web/editor/document/index.ts";
import type { EngineDab, EngineLayer, Vec3 } from "../../web/engine/engine-api.ts";

/**
 * Of the smallest dab: it looks for its texels before it colours any. Measured on the mug at 2048 texels: 0.3 to 2.5 ms a dab of
 * a centimetre, 185 to 490 ms one that covers everything.
 */
const LEAST = 1 / 50;

/** @param surface square metres of what is printed, as `boxSurface` gives them */
export const workOf = (design: Design, surface: number): number => workOfList(resolveLayers(design), surface);

/** Square metres of a box's sides: about those of what it holds. */
export function boxSurface(min: Vec3, max: Vec3): number {
  const [x, y, z] = [max[0] - min[0], max[1] - min[1], max[2] - min[2]];
  return 2 * (x * y + y * z + z * x);
}

function workOfList(layers: readonly EngineLayer[], surface: number): number {
  return layers.reduce((sum, layer) => sum + workOfLayer(layer, surface), 0);
}

function workOfLayer(layer: EngineLayer, surface: number): number {
  const inMask = workOfList(layer.mask?.layers ?? [], surface);
  if (layer.type === "group") return 1 + inMask + workOfList(layer.layers, surface);
  if (layer.type !== "stroke") return 1 + inMask;
  const dabs = layer.dabs.reduce((sum, dab) => sum + LEAST + shareOf(dab, surface), 0);
  return Math.max(1, dabs) + inMask;
}

/** Of the product's surface, 0 to 1. */
function shareOf(dab: EngineDab, surface: number): number {
  if (dab.kind === "uv") return Math.min(1, dab.size[0] * dab.size[1]);
  // What looks from afar, or all around, may see everything.
  if (dab.kind !== "planar") return 1;
  const [, second, first] = [...dab.size].sort((a, b) => a - b) as [number, number, number];
  // What of a surface lies in a box is not much more than two of its sides: a front and a back.
  return Math.min(1, (2 * first * second) / surface);
}
