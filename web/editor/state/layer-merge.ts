/**
 * Merging a layer with the one below it. Paint layers become one where that leaves the picture as it is; all else is put
 * into a group, which paints as the two did: a recipe stays one, and nothing is turned into texels.
 */
import {
  type Design,
  type DesignLayer,
  layersAt,
  mapLayer,
  type PaintLayer,
  removeById,
  visitOf,
} from "../document/index.ts";
import { withoutUnusedAssets } from "./design-edits.ts";
import { groupLayers } from "./layer-edits.ts";

/** Why two layers cannot become one: the words for it are the page's. */
export type MergeObstacle =
  | "kind"
  | "hidden"
  | "mask"
  | "opacity"
  | "blend"
  | "lockAlpha"
  | "mirror"
  | "material"
  | "erase";

export interface Merge {
  readonly design: Design;
  /** Of the layer, or the group, that holds both now. */
  readonly id: string;
  /** Null: strokes were joined into one paint layer. */
  readonly obstacle: MergeObstacle | null;
}

/** The layer that a merge would take in; undefined at the bottom of a list. */
export function layerBelow(design: Design, id: string): DesignLayer | undefined {
  const visit = visitOf(design, id);
  return visit && layersAt(design, visit)?.[visit.index - 1];
}

/** @throws TexelcastError "bad-argument" where layers would lie deeper than a design may have them. */
export function mergeDown(design: Design, id: string, groupName: string): Merge | undefined {
  const upper = visitOf(design, id)?.layer;
  const lower = layerBelow(design, id);
  if (!upper || !lower) return undefined;
  const obstacle = mergeObstacle(upper, lower);
  if (obstacle === null) {
    const strokes = [...(lower as PaintLayer).strokes, ...(upper as PaintLayer).strokes];
    const joined = mapLayer(design, lower.id, (layer) => ({ ...(layer as PaintLayer), strokes }));
    return { design: withoutUnusedAssets(removeById(joined, upper.id)), id: lower.id, obstacle };
  }
  const grouped = groupLayers(design, [lower.id, upper.id], { name: groupName });
  return grouped && { ...grouped, obstacle };
}

/**
 * What hinders the upper layer's strokes from being painted in the lower layer with the same picture. Each layer's own
 * opacity, blending and mask are for its strokes alone, and an eraser or a blending stroke means what is in its own layer.
 */
export function mergeObstacle(upper: DesignLayer, lower: DesignLayer): MergeObstacle | null {
  if (upper.type !== "paint" || lower.type !== "paint") return "kind";
  const both = [upper, lower];
  if (both.some(({ visible }) => !visible)) return "hidden";
  if (both.some(({ mask }) => mask !== null)) return "mask";
  if (both.some(({ opacity }) => opacity !== 1)) return "opacity";
  if (both.some(({ blend }) => blend !== "normal") || upper.blendSpace !== lower.blendSpace) return "blend";
  if (both.some(({ lockAlpha }) => lockAlpha)) return "lockAlpha";
  if (JSON.stringify(upper.mirror) !== JSON.stringify(lower.mirror)) return "mirror";
  if (JSON.stringify(upper.material) !== JSON.stringify(lower.material)) return "material";
  const shown = upper.strokes.filter(({ visible }) => visible);
  if (shown.some(({ blend }) => blend === "erase")) return "erase";
  if (
    shown.some(({ blend, lockAlpha, blendSpace }) => blend !== "normal" || lockAlpha || blendSpace !== upper.blendSpace)
  )
    return "blend";
  return null;
}
