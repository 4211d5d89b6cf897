/** The layers that a print consists of. */
import type { EngineLayer } from "./engine-api.ts";
import type { EnginePaintingLayer } from "./layer-tree.ts";

/** Those that paint and are shown, bottom to top, with those of groups; masks paint nothing. */
export function* printedLayers(layers: readonly EngineLayer[]): Generator<EnginePaintingLayer> {
  for (const layer of layers) {
    if (!layer.visible || !(layer.opacity > 0)) continue;
    if (layer.type === "group") yield* printedLayers(layer.layers);
    else yield layer;
  }
}
