/** Which pictures layers show, of those given to `Engine.setAsset`. */
import type { EngineLayer, EngineMask } from "./engine-api.ts";
import { paintingLayers } from "./layer-tree.ts";

/** The key of the picture that the layer itself throws; null for layers that throw none. */
export function pictureOf(layer: EngineLayer): string | null {
  if (layer.type === "decal") return layer.asset;
  if (layer.type === "stroke" && layer.brush.tip === "picture") return layer.brush.asset;
  return null;
}

/** The keys of all pictures that layers show, in groups and masks too. */
export const picturesOf = (layers: readonly EngineLayer[]): Set<string> =>
  new Set(Array.from(paintingLayers(layers), pictureOf).filter((key) => key !== null));

/** The layer with its pictures, in groups and masks too, under the keys that `rename` gives. */
export function withPictures(layer: EngineLayer, rename: (asset: string) => string): EngineLayer {
  const own = withOwnPicture(layer, rename);
  if (!own.mask) return own;
  const mask: EngineMask = { ...own.mask, layers: own.mask.layers.map((held) => withPictures(held, rename)) };
  return { ...own, mask };
}

function withOwnPicture(layer: EngineLayer, rename: (asset: string) => string): EngineLayer {
  if (layer.type === "decal") return { ...layer, asset: rename(layer.asset) };
  if (layer.type === "group") return { ...layer, layers: layer.layers.map((held) => withPictures(held, rename)) };
  if (layer.type === "stroke" && layer.brush.tip === "picture")
    return { ...layer, brush: { ...layer.brush, asset: rename(layer.brush.asset) } };
  return layer;
}
