/** The edits of a design: each takes a design and gives a new one that shares all that did not change. */
import {
  type DecalLayer,
  type Design,
  type DesignAsset,
  type DesignLayer,
  freeLayerId,
  makeDecalLayer,
  materialsOf,
} from "../document/index.ts";

export function layerById(design: Design, id: string | null): DesignLayer | undefined {
  return id === null ? undefined : design.layers.find((layer) => layer.id === id);
}

/** `patch` may hold any field of the layer but its id and type. An unknown id or an equal value changes nothing. */
export function patchLayer<L extends DesignLayer>(
  design: Design,
  id: string,
  patch: Partial<Omit<L, "id" | "type">>,
): Design {
  let changed = false;
  const layers = design.layers.map((layer) => {
    if (layer.id !== id) return layer;
    const fields = Object.entries(patch) as [keyof DesignLayer, unknown][];
    if (fields.every(([key, value]) => sameValue(layer[key], value))) return layer;
    changed = true;
    return { ...layer, ...patch } as DesignLayer;
  });
  return changed ? { ...design, layers } : design;
}

/** Adds a decal on top of all others. */
export function addDecal(
  design: Design,
  fields: Pick<DecalLayer, "name" | "material" | "asset" | "projector">,
): { design: Design; id: string } {
  const id = freeId(design);
  const layer = makeDecalLayer({ id, ...fields, name: freeName(design, fields.name) });
  return { design: { ...design, layers: [...design.layers, layer] }, id };
}

/** Puts a copy right above the original. `patch` sets the copy apart (its place). */
export function duplicateLayer<L extends DesignLayer>(
  design: Design,
  id: string,
  patch: Partial<Omit<L, "id" | "type">> = {},
): { design: Design; id: string } | undefined {
  const index = design.layers.findIndex((layer) => layer.id === id);
  const original = design.layers[index];
  if (!original) return undefined;
  const copy = { ...original, ...patch, id: freeId(design), name: freeName(design, original.name) } as DesignLayer;
  return { design: { ...design, layers: design.layers.toSpliced(index + 1, 0, copy) }, id: copy.id };
}

/** Takes a layer out, and its picture where no other layer uses it. */
export function removeLayer(design: Design, id: string): Design {
  const layers = design.layers.filter((layer) => layer.id !== id);
  return layers.length === design.layers.length ? design : withoutUnusedAssets({ ...design, layers });
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
  return new Set(design.layers.flatMap(materialsOf));
}

function withoutUnusedAssets(design: Design): Design {
  const used = new Set<string>();
  for (const layer of design.layers) {
    if (layer.type === "decal") used.add(layer.asset);
    if (layer.type === "stroke" && layer.brush.tip === "picture") used.add(layer.brush.asset);
    if (layer.type === "text") used.add(layer.font);
  }
  const kept = Object.entries(design.assets).filter(([key]) => used.has(key));
  return kept.length === Object.keys(design.assets).length ? design : { ...design, assets: Object.fromEntries(kept) };
}

function freeId(design: Design): string {
  return freeLayerId(new Set(design.layers.map((layer) => layer.id)), design.layers.length + 1);
}

/** "Star", "Star 2", "Star 3": two rows of a list must be told apart by ear too. */
function freeName(design: Design, name: string): string {
  const taken = new Set(design.layers.map((layer) => layer.name));
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
