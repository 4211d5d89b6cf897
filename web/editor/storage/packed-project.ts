/**
 * A project taken apart for storage and put together again: text on one side, each picture and model file once on the
 * other, named by its content.
 */

import type { ModelSource } from "../../engine/engine-api.ts";
import { type Design, type DesignAsset, parseDesign, serialiseDesign } from "../document/index.ts";
import { decodeDataUri, encodeDataUri } from "../files/data-uri.ts";
import type { ModelRef } from "../state/editor-state.ts";
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";
import { contentHash } from "./content-hash.ts";
import type { ProjectContent, StoredModel } from "./project.ts";

const PREFIX = "sha256/";

export interface PackedProject {
  readonly name: string;
  readonly design: string;
  readonly model: StoredModel;
  readonly targets: readonly {
    readonly material: number;
    readonly size: number | null;
    readonly gutter: number | null;
  }[];
  readonly layers: number;
  /** By name. Bytes are made when asked for: most are stored already. */
  readonly blobs: ReadonlyMap<string, { readonly size: number; readonly bytes: () => Uint8Array }>;
  /** Of text and blobs, bytes. */
  readonly size: number;
}

interface KnownBlob {
  readonly hash: string;
  readonly size: number;
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
  async pack({ name, design, model, targets }: ProjectContent): Promise<PackedProject> {
    const blobs = new Map<string, { size: number; bytes: () => Uint8Array }>();
    const pictures = new Map<string, KnownBlob>();
    const assets: Record<string, DesignAsset> = {};
    for (const [key, asset] of Object.entries(design.assets)) {
      if (!asset.uri.startsWith("data:")) {
        assets[key] = asset;
        continue;
      }
      const blob = this.#pictures.get(asset.uri) ?? pictures.get(asset.uri) ?? (await hashed(asset.uri, key));
      pictures.set(asset.uri, blob);
      blobs.set(blob.hash, { size: blob.size, bytes: () => decodeDataUri(asset.uri, key) });
      assets[key] = { ...asset, uri: PREFIX + blob.hash };
    }
    this.#pictures = pictures;
    const stored = await this.#packModel(model, blobs);
    const text = readableText({ ...design, assets }, name, this.#strings);
    const size = [...blobs.values()].reduce((sum, blob) => sum + blob.size, text.length);
    const list = [...targets].map(([material, settings]) => ({ material, ...settings }));
    return { name, design: text, model: stored, targets: list, layers: design.layers.length, blobs, size };
  }

  async #packModel(
    { source, title, demoId }: ModelRef,
    blobs: Map<string, { size: number; bytes: () => Uint8Array }>,
  ): Promise<StoredModel> {
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

function readableText(design: Design, name: string, strings: Strings): string {
  const refusal = strings.storage.unwritable(name);
  try {
    const text = serialiseDesign(design);
    if (parseDesign(text, name).layers.length === design.layers.length) return text;
  } catch (thrown) {
    throw new ToldError("bad-design", refusal, { subject: name, cause: thrown });
  }
  throw new ToldError("bad-design", refusal, { subject: name });
}

async function hashed(uri: string, key: string): Promise<KnownBlob> {
  const bytes = decodeDataUri(uri, key);
  return { hash: await contentHash(bytes), size: bytes.length };
}

/**
 * The design with its pictures inside again.
 *
 * @throws TexelcastError "bad-design" for text that is no design, "missing-file" for a picture that is not there.
 */
export function unpackDesign(
  text: string,
  name: string,
  bytesOf: (hash: string) => Uint8Array | undefined,
  strings: Strings,
): Design {
  const design = parseDesign(text, name);
  const assets: Record<string, DesignAsset> = {};
  for (const [key, asset] of Object.entries(design.assets)) {
    if (!asset.uri.startsWith(PREFIX)) {
      assets[key] = asset;
      continue;
    }
    const bytes = present(bytesOf(asset.uri.slice(PREFIX.length)), name, key, strings);
    assets[key] = { ...asset, uri: encodeDataUri(asset.type, bytes) };
  }
  return { ...design, assets };
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
