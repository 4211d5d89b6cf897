/** The edits of a design: each takes a design and gives a new one that shares all that did not change. */
import {
  assetsOf,
  type DecalLayer,
  type Design,
  type DesignAsset,
  type DesignLayer,
  findLayer,
  flattenLayers,
  freeIdIn,
  insertAt,
  makeDecalLayer,
  mapLayer,
  materialsIn,
  removeById,
  visitOf,
  withFreeIds,
} from "../document/index.ts";

export const layerById = findLayer;

/** `patch` may hold any field of the layer but its id and type. An unknown id or an equal value changes nothing. */
export function patchLayer<L extends DesignLayer>(
  design: Design,
  id: string,
  patch: Partial<Omit<L, "id" | "type">>,
): Design {
  return mapLayer(design, id, (layer) => {
    const fields = Object.entries(patch) as [keyof DesignLayer, unknown][];
    return fields.every(([key, value]) => sameValue(layer[key], value))
      ? layer
      : ({ ...layer, ...patch } as DesignLayer);
  });
}

/** Adds a decal on top of all others. */
export function addDecal(
  design: Design,
  fields: Pick<DecalLayer, "name" | "material" | "asset" | "projector">,
): { design: Design; id: string } {
  const id = freeIdIn(design);
  const layer = makeDecalLayer({ id, ...fields, name: freeName(design, fields.name) });
  return { design: { ...design, layers: [...design.layers, layer] }, id };
}

/** Puts a copy right above the original. `patch` sets the copy apart (its place). */
export function duplicateLayer<L extends DesignLayer>(
  design: Design,
  id: string,
  patch: Partial<Omit<L, "id" | "type">> = {},
): { design: Design; id: string } | undefined {
  const original = visitOf(design, id);
  if (!original) return undefined;
  const name = freeName(design, original.layer.name);
  const copy = withFreeIds(design, { ...original.layer, ...patch, name } as DesignLayer);
  return { design: insertAt(design, { ...original, index: original.index + 1 }, copy), id: copy.id };
}

/** Takes a layer out, and its picture where no other layer uses it. */
export function removeLayer(design: Design, id: string): Design {
  const without = removeById(design, id);
  return without === design ? design : withoutUnusedAssets(without);
}

/** `to` counts from the bottom, 0 to layers.length - 1, and is clamped to that. */
export function moveLayer(design: Design, id: string, to: number): Design {
  const from = design.layers.findIndex((layer) => layer.id === id);
  const layer = design.layers[from];
  const target = Math.max(0, Math.min(design.layers.length - 1, to));
  if (!layer || from === target) return design;
  return { ...design, layers: design.layers.toSpliced(from, 1).toSpliced(target, 0, layer) };
}

/** Gives the asset's key: the existing one where the same picture is already part of the design. */
export function withAsset(design: Design, name: string, asset: DesignAsset): { design: Design; key: string } {
  for (const [key, present] of Object.entries(design.assets)) {
    if (present.uri === asset.uri) return { design, key };
  }
  const stem =
    name
      .replace(/\.[^.]*$/, "")
      .replace(/[^\p{L}\p{N}_-]+/gu, "-")
      .replace(/^-+|-+$/g, "") || "picture";
  let key = stem;
  for (let number = 2; Object.hasOwn(design.assets, key) || key in Object.prototype; number += 1)
    key = `${stem}-${number}`;
  return { design: { ...design, assets: { ...design.assets, [key]: asset } }, key };
}

export function usedMaterials(design: Design): Set<number> {
  return new Set(design.layers.flatMap(materialsIn));
}

function withoutUnusedAssets(design: Design): Design {
  const used = new Set(flattenLayers(design).flatMap(assetsOf));
  const kept = Object.entries(design.assets).filter(([key]) => used.has(key));
  return kept.length === Object.keys(design.assets).length ? design : { ...design, assets: Object.fromEntries(kept) };
}

/** "Star", "Star 2", "Star 3": two rows of a list must be told apart by ear too. */
export function freeName(design: Design, name: string): string {
  const taken = new Set(flattenLayers(design).map((layer) => layer.name));
  // Only what was counted on before: the 07 of "Number 07" is part of the name.
  const stem = name.replace(/ (?:[2-9]|[1-9]\d+)$/, "");
  let free = name;
  for (let number = 2; taken.has(free); number += 1) free = `${stem} ${number}`;
  return free;
}

function sameValue(a: unknown, b: unknown): boolean {
  if (Object.is(a, b)) return true;
  return (
    Array.isArray(a) &&
    Array.isArray(b) &&
    a.length === b.length &&
    a.every((value, index) => Object.is(value, b[index]))
  );
}
