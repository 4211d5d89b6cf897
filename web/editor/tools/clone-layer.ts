/**
 * What a clone stroke becomes in the design: a decal of what was copied, shown where the brush went by its mask, in a group
 * with those before it.
 */
import {
  type Dab,
  type DecalLayer,
  type Design,
  type DesignAsset,
  type DesignLayer,
  findLayer,
  freeIdsIn,
  type GroupLayer,
  insertAt,
  isLocked,
  type LayerMaterials,
  type LayerPlace,
  type Mirror,
  makeDecalLayer,
  makeGroupLayer,
  mirroredProjector,
  type Projector,
  type StrokeLayer,
  sameMirror,
  topOf,
  visitOf,
} from "../document/index.ts";
import { freeName, withAsset } from "../state/design-edits.ts";
import type { Strings } from "../strings.ts";
import { type PaintRefusal, placeOrTop } from "./paint-target.ts";

export type CloneTarget =
  | { readonly kind: "group"; readonly groupId: string }
  /** Above the selection, in its list. */
  | { readonly kind: "new"; readonly place: LayerPlace };

/** What was copied, and where it is thrown. */
export interface ClonePatch {
  readonly asset: DesignAsset;
  readonly projector: Projector;
  readonly material: LayerMaterials;
  readonly filter: "linear" | "nearest";
  readonly opacity: number;
  readonly mirror: Mirror | null;
}

/** Whether clone strokes are gathered in a group: it holds nothing but them. */
export function isCloneGroup(layer: DesignLayer | null | undefined): layer is GroupLayer {
  return layer?.type === "group" && layer.layers.length > 0 && layer.layers.every(isClone);
}

/** A decal that shows where a stroke went. */
export function isClone(layer: DesignLayer): boolean {
  if (layer.type !== "decal" || layer.mask?.invert !== true) return false;
  const [shown] = layer.mask.layers;
  return shown?.type === "stroke" && shown.blend === "erase";
}

/**
 * The selected group of clone strokes, or the one that the selected stroke is in; else a new one above the selection. A mask has no
 * picture that could be copied: while one is painted on, nothing is.
 */
export function cloneTargetOf(
  design: Design,
  selectedId: string | null,
  editingMask: string | null = null,
): CloneTarget | PaintRefusal {
  const masked = findLayer(design, editingMask);
  if (masked !== undefined) return { kind: "refused", reason: "mask", name: masked.name };
  const visit = visitOf(design, selectedId);
  const top = { kind: "new", place: topOf(design) } as const;
  if (visit === undefined) return top;
  const group = [visit.layer, visit.parent].find(isCloneGroup);
  if (group !== undefined) {
    if (isLocked(design, group.id)) return { kind: "refused", reason: "locked", name: group.name };
    if (!group.visible) return { kind: "refused", reason: "hidden", name: group.name };
    return { kind: "group", groupId: group.id };
  }
  if (visit.list !== "layers") return top;
  if (visit.parent !== null && isLocked(design, visit.parent.id)) {
    return { kind: "refused", reason: "locked", name: visit.parent.name };
  }
  return { kind: "new", place: { parentId: visit.parentId, list: "layers", index: visit.index + 1 } };
}

/** The design with the stroke in it, and the id of its group; a new one where the target's is no longer there. With a mirror the stroke's twin is a layer of its own. */
export function withClone(
  design: Design,
  target: CloneTarget,
  stroke: StrokeLayer,
  patch: ClonePatch,
  words: Strings["clone"],
): { readonly design: Design; readonly layerId: string } {
  const { design: more, key } = withAsset(design, words.name, patch.asset);
  const nextId = freeIdsIn(more);
  const joined = target.kind === "group" && findLayer(design, target.groupId)?.type === "group" ? target.groupId : null;
  const groupId = joined ?? nextId();
  const layers: DecalLayer[] = [];
  const add = (projector: Projector, flipX: boolean, shown: StrokeLayer): void => {
    const { material, filter, opacity } = patch;
    layers.push(
      makeDecalLayer({
        ...{ id: nextId(), name: freeName(more, words.name), asset: key, projector, material, filter, opacity, flipX },
        // The stroke says where, whatever the surface turns to.
        ...{ angleFade: [90, 90], occlusion: "none" },
        mask: { layers: [{ ...shown, blend: "erase", opacity: 1 }], invert: true, linked: true },
      }),
    );
  };
  add(patch.projector, false, { ...stroke, id: nextId(), mirror: null });
  const { mirror } = patch;
  const twin = mirror === null ? null : mirroredProjector(patch.projector, mirror);
  if (mirror !== null && twin !== null) {
    const dabs = stroke.dabs.map((dab) => twinOf(dab, mirror));
    add(twin, !mirror.readable, { ...stroke, id: nextId(), mirror: null, dabs });
  }
  if (joined !== null) {
    const place = { parentId: groupId, list: "layers", index: Number.MAX_SAFE_INTEGER } as const;
    return { design: insertAt(more, place, ...layers), layerId: groupId };
  }
  const group = makeGroupLayer({ id: groupId, name: freeName(more, words.name), layers });
  const place = placeOrTop(more, target.kind === "new" ? target.place : null);
  return { design: insertAt(more, place, group), layerId: groupId };
}

/** By dab: while a stroke grows, the engine knows the dabs that it has by their being the same objects. */
const TWINS = new WeakMap<Dab, { readonly mirror: Mirror; readonly twin: Dab }>();

function twinOf(dab: Dab, mirror: Mirror): Dab {
  const known = TWINS.get(dab);
  if (known !== undefined && sameMirror(known.mirror, mirror)) return known.twin;
  const twin = mirroredProjector(dab, mirror) ?? dab;
  TWINS.set(dab, { mirror, twin });
  return twin;
}
