/**
 * What of a text cannot come onto the model as it was meant: characters that no font has, words larger than the model, and
 * words that run past its edge.
 */
import type { Projector, TextMeasure } from "../../engine/engine-api.ts";
import type { ModelViewer } from "../../viewer/viewer-api.ts";
import type { TextLayer } from "../document/design.ts";
import { plus, turned } from "../document/rigid-motion.ts";
import type { OpenModel } from "./design-state.ts";
import { emOf } from "./text-box.ts";

/** Of the characters that no font has, those that none had before the change. */
export function newlyMissing(before: TextMeasure, now: TextMeasure): readonly string[] {
  return now.missing.filter((character) => !before.missing.includes(character));
}

/**
 * A box's width or height as a share of the model's in the box's own direction, whichever is more; of a label its height alone, as it
 * goes round. Beyond 1 the rest is surely not painted.
 */
export function shareOfModel(model: OpenModel | null, projector: Projector): number {
  if (!model || (projector.kind !== "planar" && projector.kind !== "cylindrical")) return 0;
  const [x, y, z, w] = projector.rotation;
  const across = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)];
  const up = [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)];
  const { boundsMin: low, boundsMax: high } = model.info;
  const extent = (way: readonly number[]): number =>
    way.reduce((sum, part, axis) => sum + Math.abs(part) * ((high[axis] ?? 0) - (low[axis] ?? 0)), 0);
  if (projector.kind === "cylindrical") return projector.height / extent(up);
  return Math.max(projector.size[0] / extent(across), projector.size[1] / extent(up));
}

/** What is asked for at each side of a box: of the letters' height, and of the side at most. */
const RIM = { em: 0.25, side: 0.1 };

/**
 * Whether a text that is thrown from a box close about its words has a side below which there is no surface: the letters there
 * are not painted, though the model may be wider elsewhere, as a mug is by its handle.
 */
export function runsPastEdge(
  viewer: Pick<ModelViewer, "materialsReached">,
  layer: Pick<TextLayer, "projector" | "fontSize" | "backfaces">,
): boolean {
  const { projector, backfaces } = layer;
  if (projector.kind !== "planar") return false;
  const { position, rotation, size } = projector;
  const [width, height, depth] = size;
  const thickness = (side: number): number => Math.min(RIM.em * emOf(layer), RIM.side * side);
  const [wide, high] = [thickness(width), thickness(height)];
  const [right, up] = [(width - wide) / 2, (height - high) / 2];
  const rims = [
    { at: [right, 0, 0], size: [wide, height, depth] },
    { at: [-right, 0, 0], size: [wide, height, depth] },
    { at: [0, up, 0], size: [width, high, depth] },
    { at: [0, -up, 0], size: [width, high, depth] },
  ] as const;
  return rims.some((rim) => {
    const strip = { ...projector, position: plus(position, turned(rotation, rim.at)), size: rim.size };
    return viewer.materialsReached(strip, backfaces).length === 0;
  });
}

/** Whether a label goes once round, and words of it that grow longer can only become smaller. */
export const isAllRound = (projector: Projector): boolean => projector.kind === "cylindrical" && projector.arc >= 360;
