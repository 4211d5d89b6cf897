/**
 * A project taken apart for storage and put together again: text on one side, each picture and model file once on the
 * other, named by its content.
 */

import type { ModelSource } from "../../engine/engine-api.ts";
import { decodeDataUri, encodeDataUri } from "../document/data-uri.ts";
import {
  type Design,
  type DesignAsset,
  type DesignLayer,
  type Mirror,
  parseDesign,
  type StrokeLayer,
} from "../document/index.ts";
import { assetsOf, flattenLayers, hasRoom } from "../document/layer-tree.ts";
import type { ModelRef } from "../state/design-state.ts";
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";
import { contentHash } from "./content-hash.ts";
import type { ProjectContent, StoredModel } from "./project.ts";
import {
  gatherParts,
  hasParts,
  joinParts,
  knowParts,
  noteParts,
  partBytes,
  partsOf,
  printParts,
  type StrokePart,
} from "./stroke-parts.ts";

const PREFIX = "sha256/";
const MADE_UP_ID = /^layer-\d+$/;

export interface PackedText {
  readonly name: string;
  readonly design: string;
  readonly targets: readonly {
    readonly material: number;
    readonly size: number | null;
    readonly gutter: number | null;
  }[];
  readonly layers: number;
}

/** Bytes are made when asked for: most are stored already. */
interface StoredBlob {
  readonly size: number;
  readonly bytes: () => Uint8Array;
}

export interface PackedProject extends PackedText {
  readonly model: StoredModel;
  /** By name. */
  readonly blobs: ReadonlyMap<string, StoredBlob>;
  /** Of text and blobs, bytes. */
  readonly size: number;
}

interface KnownBlob {
  readonly hash: string;
  readonly size: number;
}

interface NewestPicture {
  readonly uri: string;
  readonly bytes: Uint8Array;
}

/** Remembers the names of what it packed last: hashing a model again at each step would cost more than all the rest. */
export class ProjectPacker {
  #pictures: ReadonlyMap<string, KnownBlob> = new Map();
  readonly #models = new WeakMap<Uint8Array, Promise<string>>();
  readonly #strings: Strings;

  constructor(strings: Strings) {
    this.#strings = strings;
  }

  /**
   * Rejects with a TexelcastError of code "bad-design" for a design that could not be read again: it must never take
   * the place of one that can.
   */
  async pack(content: ProjectContent): Promise<PackedProject> {
    const pictures = new Map<string, KnownBlob>();
    // What was decoded for its name is stored next. Of many pictures all would be too much to hold, and one is new at a time.
    let newest: NewestPicture | undefined;
    for (const [key, { uri }] of Object.entries(content.design.assets)) {
      if (!uri.startsWith("data:")) continue;
      let known = this.#pictures.get(uri) ?? pictures.get(uri);
      if (known === undefined) {
        const bytes = decodeDataUri(uri, key);
        known = { hash: await contentHash(bytes), size: bytes.length };
        newest = { uri, bytes };
      }
      pictures.set(uri, known);
    }
    this.#pictures = pictures;
    const blobs = new Map<string, StoredBlob>();
    const named = this.#named(content, blobs, newest);
    await gatherParts(named);
    const text = packText(content, named, blobs);
    noteParts(content.design, new Set(blobs.keys()));
    const model = await this.#packModel(content.model, blobs);
    const size = [...blobs.values()].reduce((sum, blob) => sum + blob.size, text.design.length);
    return { ...text, model, blobs, size };
  }

  /**
   * All but the model and the bytes of pictures, without waiting; null where a picture is not in `kept`, which was packed
   * before. Throws as `pack` rejects.
   */
  packText(content: ProjectContent, kept: Design): (PackedText & { readonly pictures: readonly string[] }) | null {
    const stored = new Set(Object.values(kept.assets).map(({ uri }) => uri));
    const isReady = (uri: string): boolean => stored.has(uri) && this.#pictures.has(uri);
    const uris = Object.values(content.design.assets).map(({ uri }) => uri);
    if (uris.some((uri) => uri.startsWith("data:") && !isReady(uri))) return null;
    const blobs = new Map<string, StoredBlob>();
    const text = packText(content, this.#named(content, blobs), blobs, partsOf(kept));
    return { ...text, pictures: [...blobs.keys()] };
  }

  /** A design that can be read again, its pictures by their names; they are added to `blobs`. */
  #named({ name, design }: ProjectContent, blobs: Map<string, StoredBlob>, newest?: NewestPicture): Design {
    const assets: Record<string, DesignAsset> = {};
    for (const [key, asset] of Object.entries(design.assets)) {
      const blob = this.#pictures.get(asset.uri);
      assets[key] = blob ? { ...asset, uri: PREFIX + blob.hash } : asset;
      if (!blob) continue;
      const bytes = () => (newest?.uri === asset.uri ? newest.bytes : decodeDataUri(asset.uri, key));
      blobs.set(blob.hash, { size: blob.size, bytes });
    }
    const named = { ...design, assets };
    checkReadable(named, name, this.#strings);
    return named;
  }

  async #packModel({ source, title, demoId }: ModelRef, blobs: Map<string, StoredBlob>): Promise<StoredModel> {
    if (demoId !== null) return { kind: "demo", id: demoId, title };
    const add = async (bytes: Uint8Array): Promise<string> => {
      const known = this.#models.get(bytes) ?? contentHash(bytes);
      this.#models.set(bytes, known);
      const hash = await known;
      blobs.set(hash, { size: bytes.length, bytes: () => bytes });
      return hash;
    };
    const blob = await add(source.bytes);
    const resources: { uri: string; blob: string }[] = [];
    for (const [uri, bytes] of source.resources ?? []) resources.push({ uri, blob: await add(bytes) });
    return { kind: "files", title, name: source.name, blob, resources };
  }
}

/** Strokes by the names of the parts that they are in, of `parts` if given; these are added to `blobs`. */
function packText(
  { name, targets }: ProjectContent,
  named: Design,
  blobs: Map<string, StoredBlob>,
  parts?: ReadonlySet<string>,
): PackedText {
  const note = (part: StrokePart): void => {
    blobs.set(part.hash, { size: part.size, bytes: () => partBytes(part) });
  };
  const text = printParts(named, note, parts);
  const list = [...targets].map(([material, settings]) => ({ material, ...settings }));
  return { name, design: text, targets: list, layers: named.layers.length };
}

/** Layers that hold no others and could be read again once, with the mirror of the paint layer that they were in. */
const READ = new WeakMap<DesignLayer, Mirror | null>();
/** Of a stroke's dabs, which its copies share, the stroke that was read with them. */
const READ_WITH = new WeakMap<StrokeLayer["dabs"], StrokeLayer>();

/** Says that a design came out of the reading as it is: to read it once more before it is kept takes seconds where it is large. */
export function noteRead(design: Design): void {
  for (const layer of flattenLayers(design, { strokes: false })) {
    if (layer.type === "paint") for (const stroke of layer.strokes) noteLayer(stroke, layer.mirror);
    else if (layer.type !== "group") noteLayer(layer, null);
  }
}

function noteLayer(layer: DesignLayer, mirror: Mirror | null): void {
  if (READ.get(layer) === mirror) return;
  READ.set(layer, mirror);
  if (layer.type === "stroke") READ_WITH.set(layer.dabs, layer);
}

/** Whether a layer was read before, or is a copy of a stroke that was. */
function wasRead(layer: DesignLayer, mirror: Mirror | null): boolean {
  if (READ.get(layer) === mirror) return true;
  const twin = layer.type === "stroke" ? READ_WITH.get(layer.dabs) : undefined;
  return twin !== undefined && READ.get(twin) === mirror && isCopy(layer, twin);
}

/** Whether two layers have the same, but for an id that was made up. */
function isCopy({ id, ...copy }: DesignLayer, { id: _, ...layer }: DesignLayer): boolean {
  const fields = Object.entries(copy);
  const known = layer as Readonly<Record<string, unknown>>;
  return (
    MADE_UP_ID.test(id) &&
    fields.length === Object.keys(known).length &&
    fields.every(([field, value]) => value === known[field])
  );
}

/** Throws "bad-design" for one that could not be read again. */
function checkReadable(design: Design, name: string, strings: Strings): void {
  const refusal = strings.storage.unwritable(name);
  try {
    const thin = { ...design, layers: withNewLayers(design.layers) };
    // As data: in a text of one's own no key stands twice, and to look for such takes as long as all the rest.
    const data = JSON.parse(printParts(thin, () => {}, new Set()));
    const { length } = parseDesign(data, name).layers;
    if (length === thin.layers.length && isWhole(design)) {
      noteRead(design);
      return;
    }
  } catch (thrown) {
    throw new ToldError("bad-design", refusal, { subject: name, cause: thrown });
  }
  throw new ToldError("bad-design", refusal, { subject: name });
}

/**
 * A list of layers as it is to be read for a test: without those that were read before. In a design of ten thousand strokes all
 * but one are such, and to read them all takes seconds. The first stays, since it tells how deep the others lie.
 */
function withNewLayers<Layer extends DesignLayer>(layers: readonly Layer[], mirror: Mirror | null = null): Layer[] {
  const isNew = (layer: Layer): boolean => layer.mask !== null || !wasRead(layer, mirror);
  return layers.filter((layer, index) => index === 0 || isNew(layer)).map(withNewHeld);
}

function withNewHeld<Layer extends DesignLayer>(whole: Layer): Layer {
  const { mask } = whole;
  const layer = mask === null ? whole : { ...whole, mask: { ...mask, layers: withNewLayers(mask.layers) } };
  if (layer.type === "group") return { ...layer, layers: withNewLayers(layer.layers) };
  return layer.type === "paint" ? { ...layer, strokes: withNewLayers(layer.strokes, layer.mirror) } : layer;
}

/** What no single layer can tell: that no two have one id, that they are not too many, and that all their assets are there. */
function isWhole(design: Design): boolean {
  const all = flattenLayers(design);
  const uses = (layer: DesignLayer): boolean => assetsOf(layer).every((key) => Object.hasOwn(design.assets, key));
  return new Set(all.map(({ id }) => id)).size === all.length && hasRoom(design, 0) && all.every(uses);
}

/**
 * The design with its pictures inside again.
 *
 * @throws TexelcastError "bad-design" for text that is no design, "missing-file" for a picture that is not there.
 */
export async function unpackDesign(
  text: string,
  name: string,
  bytesOf: (hash: string) => Uint8Array | undefined,
  strings: Strings,
): Promise<Design> {
  // A text without parts stays a text: what is wrong with it `parseDesign` says best.
  const { data, parts } = hasParts(text)
    ? await joinParts(text, (hash) => present(bytesOf(hash), name, hash, strings))
    : { data: text, parts: new Map() };
  const design = parseDesign(data, name);
  noteRead(design);
  const assets: Record<string, DesignAsset> = {};
  for (const [key, asset] of Object.entries(design.assets)) {
    if (!asset.uri.startsWith(PREFIX)) {
      assets[key] = asset;
      continue;
    }
    const bytes = present(bytesOf(asset.uri.slice(PREFIX.length)), name, key, strings);
    assets[key] = { ...asset, uri: encodeDataUri(asset.type, bytes) };
  }
  const whole = { ...design, assets };
  knowParts(whole, parts);
  return whole;
}

/** @throws TexelcastError "missing-file" for a file that is not there. */
export function unpackModel(
  model: Extract<StoredModel, { kind: "files" }>,
  name: string,
  bytesOf: (hash: string) => Uint8Array | undefined,
  strings: Strings,
): ModelRef {
  const resources = model.resources.map(({ uri, blob }) => [uri, present(bytesOf(blob), name, uri, strings)] as const);
  const source: ModelSource = {
    name: model.name,
    bytes: present(bytesOf(model.blob), name, model.name, strings),
    ...(resources.length > 0 && { resources: new Map(resources) }),
  };
  return { source, title: model.title, demoId: null };
}

function present(bytes: Uint8Array | undefined, name: string, part: string, strings: Strings): Uint8Array {
  if (bytes) return bytes;
  throw new ToldError("missing-file", strings.storage.partMissing(part), { subject: name, field: part });
}
