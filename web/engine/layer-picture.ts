/** Which picture a layer shows, of those given to `Engine.setAsset`. */
import type { EngineLayer } from "./engine-api.ts";

/** The picture's key; null for layers that have none. */
export function pictureOf(layer: EngineLayer): string | null {
  if (layer.type === "decal") return layer.asset;
  if (layer.type === "stroke" && layer.brush.tip === "picture") return layer.brush.asset;
  return null;
}

/** The layer with its picture under another key; layers that have none as they are. */
export function withPicture(layer: EngineLayer, asset: string): EngineLayer {
  if (layer.type === "decal") return { ...layer, asset };
  if (layer.type === "stroke" && layer.brush.tip === "picture") return { ...layer, brush: { ...layer.brush, asset } };
  return layer;
}
