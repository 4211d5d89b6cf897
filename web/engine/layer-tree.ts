/** The engine's layers as the tree that they are: groups hold layers, and so do masks. */
import type { EngineGroupLayer, EngineLayer } from "./engine-api.ts";
import { type LayerMaterials, materialsOf } from "./layer-materials.ts";
import { sameItems } from "./same-items.ts";

export type EnginePaintingLayer = Exclude<EngineLayer, EngineGroupLayer>;

/** All layers but groups, in groups and (unless `masks` is false) in masks too, bottom to top. */
export const paintingLayers = (layers: readonly EngineLayer[], masks = true): EnginePaintingLayer[] =>
  layers.flatMap((layer) => {
    const own = layer.type === "group" ? paintingLayers(layer.layers, masks) : [layer];
    return masks && layer.mask ? [...paintingLayers(layer.mask.layers), ...own] : own;
  });

/** The materials that a layer, or what is in it, paints; masks paint none. */
export const materialsIn = (layer: EngineLayer): number[] => [
  ...new Set(paintingLayers([layer], false).flatMap(materialsOf)),
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
    return [withMaskOn(sameItems(held, layer.layers) ? layer : { ...layer, layers: held }, material)];
  });
}

function withMaskOn<Layer extends EngineLayer>(layer: Layer, material: number): Layer {
  if (!layer.mask) return layer;
  const layers = layersOnMaterial(layer.mask.layers, material);
  return sameItems(layers, layer.mask.layers) ? layer : { ...layer, mask: { ...layer.mask, layers } };
}

const paints = (own: LayerMaterials, material: number): boolean =>
  typeof own === "number" ? own === material : own.includes(material);
