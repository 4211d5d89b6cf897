/** Where a stroke goes: the paint layer that is selected, the mask of another layer, or a new paint layer. */
import {
  type Design,
  type DesignLayer,
  findLayer,
  freeIdIn,
  insertAt,
  isLocked,
  type LayerPlace,
  MASK_DEFAULTS,
  type Mask,
  makePaintLayer,
  type StrokeLayer,
  topOf,
  visitOf,
} from "../document/index.ts";
import { freeName } from "../state/design-edits.ts";
import { maskBlend } from "../state/mask-edits.ts";
import type { Strings } from "../strings.ts";

export type PaintTarget =
  | { readonly kind: "strokes"; readonly layerId: string }
  | { readonly kind: "mask"; readonly layerId: string }
  /** Above the selection, in its list. */
  | { readonly kind: "new"; readonly place: LayerPlace };

export interface PaintRefusal {
  readonly kind: "refused";
  readonly reason: "locked" | "hidden" | "nothing-to-erase" | "mask";
  readonly name: string;
}

/**
 * What a stroke would change. `editingMask`: the layer whose mask is painted on instead of the layer. An eraser on a layer that is no paint layer hides it by its mask, so that nothing is lost.
 */
export function paintTargetOf(
  design: Design,
  selectedId: string | null,
  erases: boolean,
  editingMask: string | null = null,
): PaintTarget | PaintRefusal {
  const visit = visitOf(design, selectedId);
  if (visit === undefined) {
    if (erases) return { kind: "refused", reason: "nothing-to-erase", name: "" };
    return { kind: "new", place: topOf(design) };
  }
  const { layer, parent } = visit;
  const onMask = layer.id === editingMask;
  const paint = onMask
    ? null
    : layer.type === "paint"
      ? layer
      : parent?.type === "paint" && visit.list === "strokes"
        ? parent
        : null;
  const changed: DesignLayer = paint ?? layer;
  if (paint !== null || erases || onMask) {
    if (isLocked(design, changed.id)) return { kind: "refused", reason: "locked", name: changed.name };
    if (!changed.visible) return { kind: "refused", reason: "hidden", name: changed.name };
    return { kind: paint === null ? "mask" : "strokes", layerId: changed.id };
  }
  // A new layer goes beside layers, not into a mask.
  if (visit.list !== "layers") {
    return { kind: "new", place: topOf(design) };
  }
  return { kind: "new", place: { parentId: visit.parentId, list: "layers", index: visit.index + 1 } };
}

/**
 * The design with the stroke where the target says, and the id of the layer that it belongs to. The design may have lost the
 * target's layer since the press: then what paints goes into a new layer on top, and for what hides or erases it is null.
 */
export function withStroke(
  design: Design,
  target: PaintTarget,
  stroke: StrokeLayer,
  strings: Strings,
): { readonly design: Design; readonly layerId: string } | null {
  if (target.kind !== "new") {
    const { layerId } = target;
    const holder = findLayer(design, layerId);
    const isMask = target.kind === "mask";
    if (isMask ? holder !== undefined : holder?.type === "paint") {
      const list = isMask ? "mask" : "strokes";
      const painted = isMask ? onMask(stroke, holder?.mask ?? MASK_DEFAULTS) : stroke;
      return {
        design: insertAt(design, { parentId: layerId, list, index: Number.MAX_SAFE_INTEGER }, painted),
        layerId,
      };
    }
    if (isMask || stroke.blend === "erase") return null;
  }
  const place = placeOrTop(design, target.kind === "new" ? target.place : null);
  const id = freeIdIn({ layers: [...design.layers, stroke] });
  const name = freeName(design, strings.tools.paintLayer);
  const { material } = stroke;
  return {
    design: insertAt(design, place, makePaintLayer({ id, name, material, strokes: [stroke] })),
    layerId: id,
  };
}

/** A mask is alpha and nothing else: where that were locked, the brush would paint nothing. */
const onMask = (stroke: StrokeLayer, mask: Pick<Mask, "invert">): StrokeLayer => ({
  ...stroke,
  blend: maskBlend(mask, stroke.blend === "erase"),
  lockAlpha: false,
});

/** A place among layers, or the top of the design where its group is no longer there. */
export function placeOrTop(design: Design, place: LayerPlace | null): LayerPlace {
  const isThere = place !== null && (place.parentId === null || findLayer(design, place.parentId)?.type === "group");
  return isThere ? place : topOf(design);
}
