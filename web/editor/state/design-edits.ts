/** The edits of a design: each takes a design and gives a new one that shares all that did not change. */

import { sameItems } from "../../engine/same-items.ts";
import { type Design, type DesignAsset, type DesignLayer, isPlaced } from "../document/design.ts";
import { DESIGN_LIMITS, RESERVED_KEYS } from "../document/design-limits.ts";
import { assetsOf, findLayer, flattenLayers, insertAt, mapLayers, materialsIn } from "../document/layer-tree.ts";
import { liesOnTexture } from "../document/mirror-layer.ts";
import { countedNames } from "../files/counted-name.ts";

export const layerById = findLayer;

/** Characters of the number behind a name that is taken, with what stands between. */
const LONGEST_NUMBER = 7;

/** How many pictures and texts a design puts on its model. */
export function placedCount(design: Design): number {
  const layers = flattenLayers(design, { masks: false, strokes: false });
  return layers.filter(isPlaced).length;
}

/** `patch` may hold any field of the layer but its id and type. An unknown id or an equal value changes nothing. */
export const patchLayer = <L extends DesignLayer>(
  design: Design,
  id: string,
  patch: Partial<Omit<L, "id" | "type">>,
): Design => patchLayers(design, [id], patch);

/** `patchLayer` for several, in one walk. */
export function patchLayers<L extends DesignLayer>(
  design: Design,
  ids: readonly string[],
  patch: Partial<Omit<L, "id" | "type">>,
): Design {
  return patchEach(design, new Map(ids.map((id) => [id, patch])));
}

/** Patches for several layers, one each, in one walk. */
export function patchEach<L extends DesignLayer>(
  design: Design,
  patches: ReadonlyMap<string, Partial<Omit<L, "id" | "type">>>,
): Design {
  return mapLayers(design, new Set(patches.keys()), (before) => {
    const patch = patches.get(before.id) ?? {};
    const fields = Object.entries(patch) as [keyof DesignLayer, unknown][];
    if (fields.every(([key, value]) => sameValue(before[key], value))) return before;
    const after = { ...before, ...patch } as DesignLayer;
    // Documents refuse it; a patch for several layers does not know which of them lie on the texture.
    return "mirror" in after && after.mirror !== null && liesOnTexture(after) ? { ...after, mirror: null } : after;
  });
}

/** Puts a layer on top of all others, or of those in a group; gives it another name where its own is taken. */
export function addOnTop(design: Design, layer: DesignLayer, parentId: string | null = null): Design {
  const place = { parentId, list: "layers", index: Number.POSITIVE_INFINITY } as const;
  return insertAt(design, place, { ...layer, name: freeName(design, layer.name) });
}

/** Gives the asset's key: the existing one where the same picture is already part of the design. */
export function withAsset(design: Design, name: string, asset: DesignAsset): { design: Design; key: string } {
  for (const [key, present] of Object.entries(design.assets)) {
    if (present.uri === asset.uri) return { design, key };
  }
  const words = name
    .replace(/\.[^.]*$/, "")
    .replace(/[^\p{L}\p{N}_-]+/gu, "-")
    .replace(/^-+|-+$/g, "");
  const stem = shortened(words, DESIGN_LIMITS.idLength) || "picture";
  let key = stem;
  for (let number = 2; Object.hasOwn(design.assets, key) || RESERVED_KEYS.includes(key); number += 1) {
    key = `${stem}-${number}`;
  }
  return { design: { ...design, assets: { ...design.assets, [key]: asset } }, key };
}

/** A group paints nothing itself. */
export function usedMaterials(design: Pick<Design, "layers">): Set<number> {
  return new Set(design.layers.flatMap(materialsIn));
}

/** Those whose textures are no longer the model's own: as used, but for what is hidden. */
export function paintedMaterials({ layers }: Design): number[] {
  return [...usedMaterials({ layers: layers.filter(({ visible }) => visible) })];
}

export function withoutUnusedAssets(design: Design): Design {
  const used = new Set(flattenLayers(design).flatMap(assetsOf));
  const kept = Object.entries(design.assets).filter(([key]) => used.has(key));
  return kept.length === Object.keys(design.assets).length ? design : { ...design, assets: Object.fromEntries(kept) };
}

/** "Star", "Star 2", "Star 3": two rows of a list must be told apart by ear too. `own`: the layer that it is for, if it has a name. */
export const freeName = (design: Design, name: string, own?: string): string => freeNames(design, own)(name);

/** Such names for several new layers, one after the other. */
export function freeNames(design: Design, own?: string): (name: string) => string {
  const layers = flattenLayers(design, { masks: false, strokes: false }).filter(({ id }) => id !== own);
  const next = countedNames(new Set(layers.map(({ name }) => name)));
  return (name) => next(shortened(name, DESIGN_LIMITS.nameLength));
}

/** As much of a name as a document takes, with room for a number that tells it from others, and no character cut in two. */
function shortened(name: string, most: number): string {
  return name.slice(0, most - LONGEST_NUMBER).replace(/[\ud800-\udbff]$/, "");
}

const sameValue = (a: unknown, b: unknown): boolean =>
  Object.is(a, b) || (Array.isArray(a) && Array.isArray(b) && sameItems(a, b));
