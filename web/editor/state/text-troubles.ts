/** What of a text cannot come onto the model as it was meant: characters that no font has, and words larger than the model. */
import type { Projector, TextMeasure } from "../../engine/engine-api.ts";
import type { OpenModel } from "./design-state.ts";

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

/** Whether a label goes once round, and words of it that grow longer can only become smaller. */
export const isAllRound = (projector: Projector): boolean => projector.kind === "cylindrical" && projector.arc >= 360;
