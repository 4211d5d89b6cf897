/**
 * The design's layers as the tree that they are: groups hold layers, paint layers hold strokes, and any layer's mask holds
 * layers. Edits take a design and give a new one that shares all that did not change; the same one where nothing did.
 */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { sameItems } from "../../engine/same-items.ts";
import { type Design, type DesignLayer, freeLayerNumber, layerIdOf, MASK_DEFAULTS, materialsOf } from "./design.ts";
import { DESIGN_LIMITS } from "./design-limits.ts";
import type { DesignPath } from "./design-problem.ts";
import { liesOnTexture } from "./mirror-layer.ts";

/** Which of a layer's lists: what a group holds, what a paint layer holds, what a mask holds. */
export type LayerList = "layers" | "strokes" | "mask";

/** Where a layer stands, or is to stand. */
export interface LayerPlace {
  /** Null: the design's own list. */
  readonly parentId: string | null;
  /** Of the parent's; "layers" for the design's own. */
  readonly list: LayerList;
  /** From the bottom. */
  readonly index: number;
}

/** A layer met on a walk. */
export interface LayerVisit<Layer extends DesignLayer = DesignLayer> extends LayerPlace {
  readonly layer: Layer;
  readonly parent: DesignLayer | null;
  /** 1 for those of the design's own list. */
  readonly depth: number;
  /** As errors name it: ["layers", 2, "mask", "layers", 0]. */
  readonly path: DesignPath;
  /** It is part of a mask, or of something in a mask. */
  readonly inMask: boolean;
  /** It and all that it is in are shown. */
  readonly shown: boolean;
  /** It, or something that it is in, is locked. */
  readonly locked: boolean;
}

export interface WalkOptions {
  /** Also go through masks; default true. */
  readonly masks?: boolean;
  /** Also go through the strokes of paint layers; default true. */
  readonly strokes?: boolean;
}

/** The lists that a layer holds, the mask's first. */
export function childLists(layer: DesignLayer): readonly { list: LayerList; layers: readonly DesignLayer[] }[] {
  const lists: { list: LayerList; layers: readonly DesignLayer[] }[] = [];
  if (layer.mask !== null) lists.push({ list: "mask", layers: layer.mask.layers });
  if (layer.type === "group") lists.push({ list: "layers", layers: layer.layers });
  if (layer.type === "paint") lists.push({ list: "strokes", layers: layer.strokes });
  return lists;
}

const walkedLists = (layer: DesignLayer, { masks = true, strokes = true }: WalkOptions) =>
  childLists(layer).filter(({ list }) => (list === "mask" ? masks : list === "layers" || strokes));

/** Every layer, bottom to top, each before those that it holds. */
export function* walkLayers(
  { layers }: { readonly layers: readonly DesignLayer[] },
  options: WalkOptions = {},
): Generator<LayerVisit> {
  function* walk(
    list: LayerList,
    within: readonly DesignLayer[],
    parent: Omit<LayerVisit, "layer"> & { layer: DesignLayer | null },
  ): Generator<LayerVisit> {
    const key = list === "mask" ? ["mask", "layers"] : [list];
    for (const [index, layer] of within.entries()) {
      const visit: LayerVisit = {
        layer,
        parent: parent.layer,
        parentId: parent.layer?.id ?? null,
        list,
        index,
        depth: parent.depth + 1,
        path: [...parent.path, ...key, index],
        inMask: parent.inMask || list === "mask",
        shown: parent.shown && layer.visible,
        locked: parent.locked || layer.locked,
      };
      yield visit;
      for (const child of walkedLists(layer, options)) yield* walk(child.list, child.layers, visit);
    }
  }
  const top = { parentId: null, list: "layers", index: 0, layer: null, parent: null, depth: 0 } as const;
  yield* walk("layers", layers, { ...top, path: [], inMask: false, shown: true, locked: false });
}

/** Every layer, in the order of `walkLayers`. */
export const flattenLayers = ({ layers }: Pick<Design, "layers">, options: WalkOptions = {}): DesignLayer[] =>
  layers.flatMap((layer) => [layer, ...walkedLists(layer, options).flatMap((held) => flattenLayers(held, options))]);

/** The layer of that id, wherever it is. */
export const findLayer = (design: Pick<Design, "layers">, id: string | null): DesignLayer | undefined =>
  visitOf(design, id)?.layer;

/**
 * The walk through the newest list that was asked about, which goes on when a layer is asked for that it has not come to yet:
 * in each frame of a drag a dozen panels and tools ask for the selected layer of that frame's design, some for each of its
 * layers. Of no other list, as a history holds hundreds.
 */
let walked: readonly DesignLayer[] | undefined;
let met: Map<string, LayerVisit>;
let rest: Iterator<LayerVisit>;

/** Where the layer of that id is. */
export function visitOf({ layers }: Pick<Design, "layers">, id: string | null): LayerVisit | undefined {
  if (id === null) return undefined;
  if (walked !== layers) {
    walked = layers;
    met = new Map();
    rest = walkLayers({ layers });
  }
  while (!met.has(id)) {
    const { done, value } = rest.next();
    if (done) return undefined;
    met.set(value.layer.id, value);
  }
  return met.get(id);
}

/** The list that `place` names, as it is. */
export function layersAt(
  design: Pick<Design, "layers">,
  { parentId, list }: Pick<LayerPlace, "parentId" | "list">,
): readonly DesignLayer[] | undefined {
  if (parentId === null) return list === "layers" ? design.layers : undefined;
  const parent = findLayer(design, parentId);
  return parent === undefined ? undefined : childLists(parent).find((child) => child.list === list)?.layers;
}

/** The place above all of a design's layers. */
export const topOf = ({ layers }: Pick<Design, "layers">): LayerPlace => ({
  parentId: null,
  list: "layers",
  index: layers.length,
});

/** All ids in use: a new layer needs another one, wherever it goes. */
export const layerIds = (design: Pick<Design, "layers">): Set<string> =>
  new Set(flattenLayers(design).map(({ id }) => id));

/** Ids that no layer of the design has, another one with each call. */
export function freeIdsIn(design: Pick<Design, "layers">): () => string {
  const taken = layerIds(design);
  let number = taken.size;
  return () => {
    number = freeLayerNumber(taken, number + 1);
    return layerIdOf(number);
  };
}

/** An id that no layer of the design has. */
export const freeIdIn = (design: Pick<Design, "layers">): string => freeIdsIn(design)();

/** A copy of the layer in which it, and all that it holds, have ids of those. */
export function withIds(layer: DesignLayer, nextId: () => string): DesignLayer {
  let result: DesignLayer = { ...layer, id: nextId() };
  for (const { list, layers } of childLists(layer)) {
    const held = layers.map((each) => withIds(each, nextId));
    result = withList(result, list, held);
  }
  return result;
}

/** Whether a design may have so many more layers, those within others counted. */
export const hasRoom = (design: Pick<Design, "layers">, more: number): boolean =>
  flattenLayers(design).length + more <= DESIGN_LIMITS.layers;

/** The materials that a layer, or what is in it, paints; masks paint none. */
export const materialsIn = (layer: DesignLayer): number[] => [
  ...new Set(
    flattenLayers({ layers: [layer] }, { masks: false }).flatMap((held) =>
      held.type === "group" || held.type === "paint" ? [] : materialsOf(held),
    ),
  ),
];

/** The names of the assets that the layer itself uses, without those of layers that it holds. */
export function assetsOf(layer: DesignLayer): string[] {
  if (layer.type === "decal") return [layer.asset];
  if (layer.type === "text") return [layer.font];
  return layer.type === "stroke" && layer.brush.tip === "picture" ? [layer.brush.asset] : [];
}

/** How many levels a layer takes up: 1 where it holds nothing. */
export const layerDepth = (layer: DesignLayer): number =>
  1 + Math.max(0, ...childLists(layer).flatMap(({ layers }) => layers.map(layerDepth)));

/** Replaces one layer by what `change` makes of it. */
export const mapLayer = (design: Design, id: string, change: (layer: DesignLayer) => DesignLayer): Design =>
  mapLayers(design, new Set([id]), change);

/** Replaces each of those layers by what `change` makes of it, in one walk. */
export const mapLayers = (
  design: Design,
  ids: ReadonlySet<string>,
  change: (layer: DesignLayer) => DesignLayer,
): Design =>
  withLayers(
    design,
    changeLists(design.layers, (list) => list.map((layer) => (ids.has(layer.id) ? change(layer) : layer))),
  );

/**
 * Puts a layer that is not in the design yet right above each that `above` names by its id, in one walk. They must fit there: be
 * of the same type, and no deeper.
 *
 * @throws TexelcastError "bad-argument" where layers would be more than a design may have.
 */
export function insertAboveEach(design: Design, above: ReadonlyMap<string, DesignLayer>): Design {
  checkRoom(design, [...above.values()]);
  const layers = changeLists(design.layers, (list) =>
    list.flatMap((layer) => [layer].concat(above.get(layer.id) ?? [])),
  );
  return withLayers(design, layers);
}

/** Takes layers out, with all that they hold. */
export const removeByIds = (design: Design, ids: ReadonlySet<string>): Design =>
  withLayers(
    design,
    changeLists(design.layers, (list) => list.filter(({ id }) => !ids.has(id))),
  );

/** Takes a layer out, with all that it holds. */
export const removeById = (design: Design, id: string): Design => removeByIds(design, new Set([id]));

function checkRoom(design: Pick<Design, "layers">, layers: readonly DesignLayer[]): void {
  if (hasRoom(design, flattenLayers({ layers }).length)) return;
  const most = `A design holds ${DESIGN_LIMITS.layers} layers, those within others included, and no more.`;
  throw refusal("too-many", "layers", String(layers[0]?.type), most);
}

/**
 * Puts layers that are not in the design yet at a place, beside each other, bottom to top; `index` is clamped to the list's
 * ends. A mask is made where the parent has none.
 *
 * @throws TexelcastError "bad-argument" where there is no such list, where it takes no layers of that type, and where
 * layers would lie deeper, or be more, than a design may have them.
 */
export function insertAt(
  design: Design,
  { parentId, list, index }: LayerPlace,
  ...layers: readonly DesignLayer[]
): Design {
  const put = (present: readonly DesignLayer[]): DesignLayer[] =>
    present.toSpliced(Math.max(0, Math.min(index, present.length)), 0, ...layers);
  const parent = visitOf(design, parentId);
  const depth = parent?.depth ?? 0;
  if (depth + Math.max(0, ...layers.map(layerDepth)) > DESIGN_LIMITS.depth) {
    throw refusal("too-deep", "parentId", parentId, `Layers can lie ${DESIGN_LIMITS.depth} deep and no deeper.`);
  }
  checkRoom(design, layers);
  if (parentId === null && list === "layers") return { ...design, layers: put(design.layers) };
  if (parent === undefined)
    throw refusal("no-layer", "parentId", parentId, "There is no such layer to put another into.");
  const isHolder =
    list === "mask" ||
    (list === "layers" && parent.layer.type === "group") ||
    (list === "strokes" && parent.layer.type === "paint");
  if (!isHolder) throw refusal("no-list", "list", list, `A layer of type “${parent.layer.type}” has no such list.`);
  const takes = ({ type }: DesignLayer): boolean =>
    list === "layers" || (list === "strokes" ? type === "stroke" : type !== "group" && type !== "paint");
  const other = layers.find((layer) => !takes(layer))?.type;
  if (other) throw refusal("not-taken", "type", other, `The list “${list}” takes no layers of type “${other}”.`);
  if (list === "strokes" && parent.layer.type === "paint" && parent.layer.mirror && layers.some(liesOnTexture)) {
    throw refusal(
      "not-mirrored",
      "mirror",
      parent.layer.mirror.axis,
      "A stroke that lies on the texture cannot be mirrored.",
    );
  }
  return mapLayer(design, parent.layer.id, (holder) =>
    list === "mask"
      ? withList(
          holder.mask === null ? ({ ...holder, mask: { layers: [], ...MASK_DEFAULTS } } as DesignLayer) : holder,
          list,
          put(holder.mask?.layers ?? []),
        )
      : withList(holder, list, put(layersAt(design, { parentId, list }) ?? [])),
  );
}

/** Changes every list of the tree, each after those below it; lists that stay as they are are shared. */
function changeLists(
  layers: readonly DesignLayer[],
  change: (list: readonly DesignLayer[]) => readonly DesignLayer[],
): readonly DesignLayer[] {
  const within = layers.map((layer) => {
    let result = layer;
    for (const { list, layers: held } of childLists(layer)) {
      const next = changeLists(held, change);
      if (next !== held) result = withList(result, list, next);
    }
    return result;
  });
  const result = change(within);
  return sameItems(result, layers) ? layers : result;
}

/** The caller answers for the types of what the list holds. */
function withList(layer: DesignLayer, list: LayerList, layers: readonly DesignLayer[]): DesignLayer {
  if (list === "mask") return { ...layer, mask: { ...layer.mask, layers } } as DesignLayer;
  return { ...layer, [list]: layers } as DesignLayer;
}

function withLayers(design: Design, layers: readonly DesignLayer[]): Design {
  return layers === design.layers ? design : { ...design, layers };
}

function refusal(reason: string, field: string, value: string | null, message: string): TexelcastError {
  return new TexelcastError("bad-argument", message, { field, value: String(value), reason });
}

/** It, or a group that it lies in, is locked. */
export const isLocked = (design: Pick<Design, "layers">, id: string): boolean => visitOf(design, id)?.locked ?? false;
