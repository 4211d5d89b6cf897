/**
 * Lists of layers on their way to the worker. A stroke's dabs are many and all but the newest stay as they are, so only
 * what the worker does not have yet is sent; both ends remember the list before.
 */
import type { EngineDab, EngineGroupLayer, EngineLayer, EngineMask, EngineStrokeLayer } from "./engine-api.ts";
import { paintingLayers } from "./layer-tree.ts";

/** A stroke whose first `kept` dabs are those of the list before. */
interface SentStroke extends Omit<EngineStrokeLayer, "dabs" | "mask"> {
  readonly dabs: { readonly kept: number; readonly added: readonly EngineDab[] };
}
type SentGroup = Omit<EngineGroupLayer, "layers" | "mask"> & { readonly layers: readonly SentLayer[] };
type Plain = Exclude<EngineLayer, EngineStrokeLayer | EngineGroupLayer>;
type SentPlain = Plain extends infer Layer ? Omit<Layer, "mask"> : never;

export type SentLayer = (SentPlain | SentStroke | SentGroup) & {
  readonly mask?: (Omit<EngineMask, "layers"> & { readonly layers: readonly SentLayer[] }) | null;
};

/** The page's end. One for each worker, as each begins with nothing. */
export class LayerSender {
  #dabs: ReadonlyMap<string, readonly EngineDab[]> = new Map();

  /** The list as it is to be sent; it must arrive, and in the order of these calls. */
  pack(layers: readonly EngineLayer[]): SentLayer[] {
    const before = this.#dabs;
    this.#dabs = dabsById(layers);
    return layers.map((layer) => pack(layer, before));
  }
}

function pack(layer: EngineLayer, before: ReadonlyMap<string, readonly EngineDab[]>): SentLayer {
  const mask = layer.mask && { ...layer.mask, layers: layer.mask.layers.map((held) => pack(held, before)) };
  if (layer.type === "group") return { ...layer, mask, layers: layer.layers.map((held) => pack(held, before)) };
  if (layer.type !== "stroke") return { ...layer, mask };
  const { dabs } = layer;
  const known = before.get(layer.id) ?? [];
  let kept = 0;
  // The very same objects: whoever makes a longer list of them does not copy them.
  while (kept < known.length && kept < dabs.length && known[kept] === dabs[kept]) kept++;
  return { ...layer, mask, dabs: { kept, added: dabs.slice(kept) } };
}

/** The worker's end. */
export class LayerReceiver {
  #dabs: ReadonlyMap<string, readonly EngineDab[]> = new Map();

  unpack(sent: readonly SentLayer[]): EngineLayer[] {
    const before = this.#dabs;
    const layers = sent.map((layer) => unpack(layer, before));
    this.#dabs = dabsById(layers);
    return layers;
  }
}

function unpack(layer: SentLayer, before: ReadonlyMap<string, readonly EngineDab[]>): EngineLayer {
  const mask = layer.mask && { ...layer.mask, layers: layer.mask.layers.map((held) => unpack(held, before)) };
  if (layer.type === "group") return { ...layer, mask, layers: layer.layers.map((held) => unpack(held, before)) };
  if (layer.type !== "stroke") return { ...layer, mask } as EngineLayer;
  const { kept, added } = layer.dabs;
  return { ...layer, mask, dabs: [...(before.get(layer.id) ?? []).slice(0, kept), ...added] };
}

function dabsById(layers: readonly EngineLayer[]): ReadonlyMap<string, readonly EngineDab[]> {
  const strokes = new Map<string, readonly EngineDab[]>();
  for (const layer of paintingLayers(layers)) if (layer.type === "stroke") strokes.set(layer.id, layer.dabs);
  return strokes;
}
