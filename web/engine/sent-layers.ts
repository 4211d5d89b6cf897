/**
 * Lists of layers on their way to the worker. A design's layers are many, a stroke's dabs more, and all but the newest stay as
 * they are, so only what the worker does not have yet is sent; both ends remember the list before.
 */
import type { EngineDab, EngineGroupLayer, EngineLayer, EngineMask, EngineStrokeLayer } from "./engine-api.ts";

/** Layers that stand one after the other as they did before, each the very object that it was, with all that is in it. */
interface KnownLayers {
  readonly type: "known";
  /** Of the first. */
  readonly id: string;
  readonly count: number;
}
/** A stroke whose first `kept` dabs are those of the list before. */
interface SentStroke extends Omit<EngineStrokeLayer, "dabs" | "mask"> {
  readonly dabs: { readonly kept: number; readonly added: readonly EngineDab[] };
}
type SentGroup = Omit<EngineGroupLayer, "layers" | "mask"> & { readonly layers: readonly SentLayer[] };
type Plain = Exclude<EngineLayer, EngineStrokeLayer | EngineGroupLayer>;
type SentPlain = Plain extends infer Layer ? Omit<Layer, "mask"> : never;
type SentMask = Omit<EngineMask, "layers"> & { readonly layers: readonly SentLayer[] };

export type SentLayer = KnownLayers | ((SentPlain | SentStroke | SentGroup) & { readonly mask?: SentMask | null });

/** Where each layer stood. */
type Places = ReadonlyMap<string, readonly [list: readonly EngineLayer[], at: number]>;

/** The page's end. One for each worker, as each begins with nothing. */
export class LayerSender {
  #before: Places = new Map();

  /** The list as it is to be sent; it must arrive, and in the order of these calls. Throws where it is no list of layers. */
  pack(layers: readonly EngineLayer[]): SentLayer[] {
    const sent = packList(layers, this.#before);
    this.#before = placesOf(layers);
    return sent;
  }
}

function packList(layers: readonly EngineLayer[], before: Places): SentLayer[] {
  const sent: SentLayer[] = [];
  for (let at = 0, count = 0; at < layers.length; at += count || 1) {
    const layer = layers[at] as EngineLayer;
    const [list, from] = before.get(layer.id) ?? [[], 0];
    for (count = 0; list[from + count] && list[from + count] === layers[at + count]; ) count++;
    sent.push(count > 0 ? { type: "known", id: layer.id, count } : pack(layer, list[from], before));
  }
  return sent;
}

function pack(layer: EngineLayer, known: EngineLayer | undefined, before: Places): SentLayer {
  const mask = layer.mask && { ...layer.mask, layers: packList(layer.mask.layers, before) };
  if (layer.type === "group") return { ...layer, mask, layers: packList(layer.layers, before) };
  if (layer.type !== "stroke") return { ...layer, mask };
  const { dabs } = layer;
  const knownDabs = dabsOf(known);
  let kept = 0;
  // The very same objects: whoever makes a longer list of them does not copy them.
  while (dabs[kept] && dabs[kept] === knownDabs[kept]) kept++;
  return { ...layer, mask, dabs: { kept, added: dabs.slice(kept) } };
}

/** The worker's end. */
export class LayerReceiver {
  #before: Places = new Map();

  unpack(sent: readonly SentLayer[]): EngineLayer[] {
    const layers = unpackList(sent, this.#before);
    this.#before = placesOf(layers);
    return layers;
  }
}

function unpackList(sent: readonly SentLayer[], before: Places): EngineLayer[] {
  return sent.flatMap((layer) => {
    const place = before.get(layer.id);
    if (layer.type !== "known") return unpack(layer, place?.[0][place[1]], before);
    // One that was not sent before has none: this throws.
    const [list, at] = place as NonNullable<typeof place>;
    return list.slice(at, at + layer.count);
  });
}

function unpack(layer: Exclude<SentLayer, KnownLayers>, known: EngineLayer | undefined, before: Places): EngineLayer {
  const mask = layer.mask && { ...layer.mask, layers: unpackList(layer.mask.layers, before) };
  if (layer.type === "group") return { ...layer, mask, layers: unpackList(layer.layers, before) };
  if (layer.type !== "stroke") return { ...layer, mask } as EngineLayer;
  const { kept, added } = layer.dabs;
  return { ...layer, mask, dabs: [...dabsOf(known).slice(0, kept), ...added] };
}

const dabsOf = (layer: EngineLayer | undefined): readonly EngineDab[] => (layer?.type === "stroke" ? layer.dabs : []);

function placesOf(layers: readonly EngineLayer[]): Places {
  const all = new Map<string, readonly [readonly EngineLayer[], number]>();
  const add = (layer: EngineLayer, at: number, list: readonly EngineLayer[]): void => {
    all.set(layer.id, [list, at]);
    layer.mask?.layers.forEach(add);
    if (layer.type === "group") layer.layers.forEach(add);
  };
  layers.forEach(add);
  return all;
}
