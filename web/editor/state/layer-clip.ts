/** Layers on their way from one design to another, or to another place in the same one: a design of their own. */
import { type Design, type DesignLayer, layerMaterials, materialsOf } from "../document/design.ts";
import {
  childLists,
  findLayer,
  freeIdsIn,
  insertAt,
  isLocked,
  topOf,
  visitOf,
  withIds,
} from "../document/layer-tree.ts";
import { freeNames, withAsset, withoutUnusedAssets } from "./design-edits.ts";
import { outermost, type TreePlace } from "./layer-edits.ts";

/** The named layers alone, with the pictures and fonts that they use. */
export function clipOf(design: Design, ids: readonly string[]): Design {
  return withoutUnusedAssets({ ...design, layers: outermost(design, ids).map(({ layer }) => layer) });
}

/**
 * Puts a clip's layers above the layer `id`, or on top of what it holds where it is a group that the clip is not a part of;
 * without one, or where that would be in a locked group, on top of all. `fitted` fits each to its new place. Ids are those that the
 * clip's own layers have now.
 *
 * @throws TexelcastError "bad-argument" where layers would lie deeper than a design may have them.
 */
export function putClip(
  design: Design,
  clip: Design,
  id: string | null,
  fitted: (layer: DesignLayer) => DesignLayer = (layer) => layer,
): { design: Design; ids: string[] } {
  const place = placeFor(design, clip, id);
  const keys = new Map<string, string>();
  let made = design;
  for (const [name, asset] of Object.entries(clip.assets)) {
    const kept = withAsset(made, name, asset);
    made = kept.design;
    keys.set(name, kept.key);
  }
  const nextId = freeIdsIn(made);
  const held = clip.layers.flatMap((layer) => (layer.type === "group" ? layer.layers : []));
  const nextName = freeNames({ ...made, layers: [...made.layers, ...held] });
  const copies = clip.layers.map((layer) => {
    const put = fitted(throughout(layer, (each) => withKeys(each, keys)));
    return withIds({ ...put, name: nextName(layer.name) }, nextId);
  });
  return { design: insertAt(made, { ...place, list: "layers" }, ...copies), ids: copies.map(({ id }) => id) };
}

/**
 * The layer as another model can have it: what paints no material that is there paints `shown`.
 *
 * @param materials those of the model
 */
export function fitToModel(layer: DesignLayer, materials: ReadonlySet<number>, shown: number): DesignLayer {
  return throughout(layer, (each) => {
    const own = materialsOf(each).filter((material) => materials.has(material));
    if (own.length > 0)
      return own.length === materialsOf(each).length ? each : { ...each, material: layerMaterials(own) };
    // Faces are counted in their own material: in another one they would be any.
    return each.type === "fill" ? { ...each, material: shown, parts: null } : { ...each, material: shown };
  });
}

function placeFor(design: Design, clip: Design, id: string | null): TreePlace {
  const visit = visitOf(design, id);
  if (!visit) return topOf(design);
  const { layer, parentId, index } = visit;
  const takesIn = layer.type === "group" && findLayer(clip, layer.id) === undefined;
  const place = takesIn ? { parentId: layer.id, index: layer.layers.length } : { parentId, index: index + 1 };
  return place.parentId !== null && isLocked(design, place.parentId) ? topOf(design) : place;
}

/** The layer, with the names that its assets have in another design. */
function withKeys(layer: DesignLayer, keys: ReadonlyMap<string, string>): DesignLayer {
  const named = (key: string): string => keys.get(key) ?? key;
  if (layer.type === "decal") return { ...layer, asset: named(layer.asset) };
  if (layer.type === "text") return { ...layer, font: named(layer.font) };
  if (layer.type !== "stroke" || layer.brush.tip !== "picture") return layer;
  return { ...layer, brush: { ...layer.brush, asset: named(layer.brush.asset) } };
}

/** Changes the layer and all that it holds, masks and strokes too. */
function throughout(layer: DesignLayer, change: (layer: DesignLayer) => DesignLayer): DesignLayer {
  let changed = change(layer);
  for (const { list, layers } of childLists(layer)) {
    const held = layers.map((each) => throughout(each, change));
    const part = list === "mask" ? { mask: { ...changed.mask, layers: held } } : { [list]: held };
    changed = { ...changed, ...part } as DesignLayer;
  }
  return changed;
}
