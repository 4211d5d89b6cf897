/**
 * Lists of layers on their way to the worker. A design's layers are many, a stroke's dabs more, and all but the newest stay as
 * they are, so only what the worker does not have yet is sent; both ends remember the list before.
 */
import type { EngineDab, EngineGroupLayer, EngineLayer, EngineMask, EngineStrokeLayer } from "./engine-api.ts";

/** A layer that is the very object that it was in the list before, with all that is in it. */
interface KnownLayer {
  readonly type: "known";
  readonly id: string;
}
/** A stroke whose first `kept` dabs are those of the list before. */
interface SentStroke extends Omit<EngineStrokeLayer, "dabs" | "mask"> {
  readonly dabs: { readonly kept: number; readonly added: readonly EngineDab[] };
}
type SentGroup = Omit<EngineGroupLayer, "layers" | "mask"> & { readonly layers: readonly SentLayer[] };
type Plain = Exclude<EngineLayer, EngineStrokeLayer | EngineGroupLayer>;
type SentPlain = Plain extends infer Layer ? Omit<Layer, "mask"> : never;
type SentMask = Omit<EngineMask, "layers"> & { readonly layers: readonly SentLayer[] };

export type SentLayer = KnownLayer | ((SentPlain | SentStroke | SentGroup) & { readonly mask?: SentMask | null });

type LayersById = ReadonlyMap<string, EngineLayer>;

/** The page's end. One for each worker, as each begins with nothing. */
export class LayerSender {
  #before: LayersById = new Map();

  /** The list as it is to be sent; it must arrive, and in the order of these calls. Throws where it is no list of layers. */
  pack(layers: readonly EngineLayer[]): SentLayer[] {
    const before = this.#before;
    const sent = layers.map((layer) => pack(layer, before));
    this.#before = byId(layers);
    return sent;
  }
}

function pack(layer: EngineLayer, before: LayersById): SentLayer {
  const known = before.get(layer.id);
  if (known === layer) return { type: "known", id: layer.id };
  const mask = layer.mask && { ...layer.mask, layers: layer.mask.layers.map((held) => pack(held, before)) };
  if (layer.type === "group") return { ...layer, mask, layers: layer.layers.map((held) => pack(held, before)) };
  if (layer.type !== "stroke") return { ...layer, mask };
  const { dabs } = layer;
  const knownDabs = dabsOf(known);
  let kept = 0;
  // The very same objects: whoever makes a longer list of them does not copy them.
  while (kept < knownDabs.length && kept < dabs.length && knownDabs[kept] === dabs[kept]) kept++;
  return { ...layer, mask, dabs: { kept, added: dabs.slice(kept) } };
}

/** The worker's end. */
export class LayerReceiver {
  #before: LayersById = new Map();

  unpack(sent: readonly SentLayer[]): EngineLayer[] {
    const before = this.#before;
    const layers = sent.map((layer) => unpack(layer, before));
    this.#before = byId(layers);
    return layers;
  }
}

function unpack(layer: SentLayer, before: LayersById): EngineLayer {
  const known = before.get(layer.id);
  if (layer.type === "known") {
    if (known === undefined) throw new Error(`The layer “${layer.id}” was not sent before.`);
    return known;
  }
  const mask = layer.mask && { ...layer.mask, layers: layer.mask.layers.map((held) => unpack(held, before)) };
  if (layer.type === "group") return { ...layer, mask, layers: layer.layers.map((held) => unpack(held, before)) };
  if (layer.type !== "stroke") return { ...layer, mask } as EngineLayer;
  const { kept, added } = layer.dabs;
  return { ...layer, mask, dabs: [...dabsOf(known).slice(0, kept), ...added] };
}

const dabsOf = (layer: EngineLayer | undefined): readonly EngineDab[] => (layer?.type === "stroke" ? layer.dabs : []);

function byId(layers: readonly EngineLayer[]): LayersById {
  const all = new Map<string, EngineLayer>();
  const add = (layer: EngineLayer): void => {
    all.set(layer.id, layer);
    layer.mask?.layers.forEach(add);
    if (layer.type === "group") layer.layers.forEach(add);
  };
  layers.forEach(add);
  return all;
}
