/** A model that a page gives where others give its address: its bytes, or those with a name and the files beside it. */
import { ToldError } from "../../editor/strings/told-error.ts";
import type { ModelSource } from "../../engine/engine-api.ts";
import type { Words } from "../words/words.ts";

/** In signs that every language reads. */
const MAY_BE = '"mug.glb", URL, Uint8Array, ArrayBuffer, Blob, { name, bytes, resources: Map }';
/** Of what has none; a model's form is told by its bytes. */
const NO_NAME = "src";

/** Rejects with "bad-argument", naming the field, what stands there and what may. */
export async function givenModel(src: unknown, { errors }: Words): Promise<ModelSource> {
  const refuse = (field: string, value: unknown): never => {
    const found = typeof value === "object" && !Array.isArray(value) ? "object" : String(value).slice(0, 80);
    throw new ToldError("bad-argument", errors.badOption(field), { field, value: found, hint: MAY_BE });
  };
  const bare = await bytesOf(src);
  if (bare) return { name: kindOf(src) === "File" ? (src as File).name : NO_NAME, bytes: bare };
  if (typeof src !== "object" || src === null || !("bytes" in src)) return refuse("src", src);
  const { name = NO_NAME, bytes: given, resources } = src as { name?: unknown; bytes: unknown; resources?: unknown };
  const bytes = await bytesOf(given);
  if (typeof name !== "string") return refuse("src.name", name);
  if (!bytes) return refuse("src.bytes", given);
  if (resources === undefined || resources === null) return { name, bytes };
  if (kindOf(resources) !== "Map") return refuse("src.resources", resources);
  return { name, bytes, resources: resources as NonNullable<ModelSource["resources"]> };
}

async function bytesOf(given: unknown): Promise<Uint8Array | null> {
  if (kindOf(given) === "Uint8Array") return given as Uint8Array;
  if (ArrayBuffer.isView(given)) return new Uint8Array(given.buffer, given.byteOffset, given.byteLength);
  if (kindOf(given) === "ArrayBuffer") return new Uint8Array(given as ArrayBuffer);
  return /^(Blob|File)$/.test(kindOf(given)) ? new Uint8Array(await (given as Blob).arrayBuffer()) : null;
}

/** By its tag: another window's are none of this one's. */
const kindOf = (value: unknown): string => Object.prototype.toString.call(value).slice(8, -1);
