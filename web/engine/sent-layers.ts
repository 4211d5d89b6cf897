/**
 * Lists of layers on their way to the worker. A stroke's dabs are many and all but the newest stay as they are, so only
 * what the worker does not have yet is sent; both ends remember the list before.
 */
import type { EngineDab, EngineLayer, EngineStrokeLayer } from "./engine-api.ts";

/** A stroke whose first `kept` dabs are those of the list before. */
interface SentStroke extends Omit<EngineStrokeLayer, "dabs"> {
  readonly dabs: { readonly kept: number; readonly added: readonly EngineDab[] };
}

export type SentLayer = Exclude<EngineLayer, EngineStrokeLayer> | SentStroke;

/** The page's end. One for each worker, as each begins with nothing. */
export class LayerSender {
  #dabs: ReadonlyMap<string, readonly EngineDab[]> = new Map();

  /** The list as it is to be sent; it must arrive, and in the order of these calls. */
  pack(layers: readonly EngineLayer[]): SentLayer[] {
    const before = this.#dabs;
    this.#dabs = dabsById(layers);
    return layers.map((layer) => {
      if (layer.type !== "stroke") return layer;
      const { dabs } = layer;
      const known = before.get(layer.id) ?? [];
      let kept = 0;
      // The very same objects: whoever makes a longer list of them does not copy them.
      while (kept < known.length && kept < dabs.length && known[kept] === dabs[kept]) kept++;
      return { ...layer, dabs: { kept, added: dabs.slice(kept) } };
    });
  }
}

/** The worker's end. */
export class LayerReceiver {
  #dabs: ReadonlyMap<string, readonly EngineDab[]> = new Map();

  unpack(sent: readonly SentLayer[]): EngineLayer[] {
    const layers = sent.map((layer): EngineLayer => {
      if (layer.type !== "stroke") return layer;
      const { kept, added } = layer.dabs;
      return { ...layer, dabs: [...(this.#dabs.get(layer.id) ?? []).slice(0, kept), ...added] };
    });
    this.#dabs = dabsById(layers);
    return layers;
  }
}

function dabsById(layers: readonly EngineLayer[]): ReadonlyMap<string, readonly EngineDab[]> {
  return new Map(layers.flatMap((layer) => (layer.type === "stroke" ? [[layer.id, layer.dabs]] : [])));
}
