/** The engine's layers as the tree that they are: groups hold layers, and so do masks. */
import type { EngineGroupLayer, EngineLayer } from "./engine-api.ts";
import { type LayerMaterials, materialsOf } from "./layer-materials.ts";

export type EnginePaintingLayer = Exclude<EngineLayer, EngineGroupLayer>;

/** All layers but groups, in groups and (unless `masks` is false) in masks too, bottom to top. */
export function* paintingLayers(layers: readonly EngineLayer[], masks = true): Generator<EnginePaintingLayer> {
  for (const layer of layers) {
    if (masks && layer.mask) yield* paintingLayers(layer.mask.layers);
    if (layer.type === "group") yield* paintingLayers(layer.layers, masks);
    else yield layer;
  }
}

/** The materials that a layer, or what is in it, paints; masks paint none. */
export const materialsIn = (layer: EngineLayer): number[] => [
  ...new Set([...paintingLayers([layer], false)].flatMap(materialsOf)),
];

/**
 * What of the layers concerns one material, groups and masks thinned out; groups that come to hold nothing are left out. What
 * needs no thinning is the same object.
 */
export function layersOnMaterial(layers: readonly EngineLayer[], material: number): EngineLayer[] {
  return layers.flatMap((layer): EngineLayer[] => {
    if (layer.type !== "group") return paints(layer.material, material) ? [withMaskOn(layer, material)] : [];
    const held = layersOnMaterial(layer.layers, material);
    if (held.length === 0) return [];
    return [withMaskOn(isSame(held, layer.layers) ? layer : { ...layer, layers: held }, material)];
  });
}

function withMaskOn<Layer extends EngineLayer>(layer: Layer, material: number): Layer {
  if (!layer.mask) return layer;
  const layers = layersOnMaterial(layer.mask.layers, material);
  return isSame(layers, layer.mask.layers) ? layer : { ...layer, mask: { ...layer.mask, layers } };
}

const paints = (own: LayerMaterials, material: number): boolean =>
  typeof own === "number" ? own === material : own.includes(material);

const isSame = (a: readonly EngineLayer[], b: readonly EngineLayer[]): boolean =>
  a.length === b.length && a.every((layer, index) => layer === b[index]);
