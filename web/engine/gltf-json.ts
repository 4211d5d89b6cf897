/**
 * glTF's JSON read with care: a file may hold anything, so every look into it says what it expects and fails with a
 * "bad-container" error that names the JSON path.
 */
import { TexelcastError } from "../core/texelcast-error.ts";

export type JsonValue = null | boolean | number | string | JsonValue[] | JsonObject;
/** Parsed JSON. `JSON.parse` makes even "__proto__" a plain own property, so nothing here reaches a prototype. */
export interface JsonObject {
  [key: string]: JsonValue | undefined;
}

/** Deeper JSON would overflow the stack of whoever walks it next, and no real model comes near. */
const MAX_DEPTH = 512;

/** What to do about a file that cannot be used. */
export const REPAIR = "Export the model again, or check the file with the glTF Validator.";

/** @param problem the end of the sentence “… is not a sound glTF file: …”; `value` is cut short. */
export function badContainer(name: string, problem: string, field?: string, value?: unknown): TexelcastError {
  return new TexelcastError("bad-container", `“${name}” is not a sound glTF file: ${problem}.`, {
    subject: name,
    ...(field !== undefined && { field }),
    ...(value !== undefined && { value: shorten(value) }),
    hint: REPAIR,
  });
}

/** A file's value as errors give it. */
export function shorten(value: unknown): string {
  const text = typeof value === "string" ? value : (JSON.stringify(value) ?? String(value));
  return text.length > 80 ? `${text.slice(0, 77)}…` : text;
}

/** Parses a model's JSON; `name` is the file that errors name. */
export function parseGltfJson(text: string, name: string): JsonObject {
  if (nestingDepth(text) > MAX_DEPTH) throw badContainer(name, `its JSON is nested deeper than ${MAX_DEPTH} levels`);
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch (cause) {
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw badContainer(name, `its JSON cannot be parsed (${shorten(reason)})`);
  }
  if (!isObject(json)) throw badContainer(name, "its JSON is not an object");
  const version = isObject(json.asset) ? json.asset.version : undefined;
  if (typeof version !== "string") throw badContainer(name, "it does not say its version", "asset.version", version);
  if (!version.startsWith("2.")) {
    throw new TexelcastError("bad-container", `“${name}” is glTF “${shorten(version)}”; only glTF 2.0 can be read.`, {
      subject: name,
      field: "asset.version",
      value: shorten(version),
      hint: "Export the model as glTF 2.0.",
    });
  }
  return json;
}

/** Brackets open at once, at most; those inside strings do not count. */
function nestingDepth(text: string): number {
  let depth = 0;
  let deepest = 0;
  let inString = false;
  for (let i = 0; i < text.length; i++) {
    const character = text.charCodeAt(i);
    if (inString) {
      if (character === 0x5c) i++;
      else if (character === 0x22) inString = false;
    } else if (character === 0x22) inString = true;
    else if (character === 0x5b || character === 0x7b) deepest = Math.max(deepest, ++depth);
    else if (character === 0x5d || character === 0x7d) depth--;
  }
  return deepest;
}

/** Neither null nor a list. */
export function isObject(value: unknown): value is JsonObject {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** A top-level list of objects ("buffers", "materials", …): empty when absent. The objects are the JSON's own. */
export function listOf(json: JsonObject, key: string, name: string): JsonObject[] {
  const list = json[key];
  if (list === undefined) return [];
  if (!Array.isArray(list)) throw badContainer(name, `“${key}” is not a list`, key, list);
  if (CHECKED.has(list)) return list as JsonObject[];
  for (const [i, item] of list.entries()) {
    if (!isObject(item)) throw badContainer(name, `“${key}[${i}]” is not an object`, `${key}[${i}]`, item);
  }
  CHECKED.add(list);
  return list as JsonObject[];
}

/** Lists are asked for item by item: to check all of a list each time would take very many materials minutes. */
const CHECKED = new WeakSet<object>();

/** A list for writing: made when absent. */
export function listForWriting(json: JsonObject, key: string, name: string): JsonObject[] {
  const list = listOf(json, key, name);
  json[key] ??= list;
  return list;
}

/** A member that is an object, or undefined when it is absent or of another type. */
export function objectAt(parent: JsonObject | undefined, key: string): JsonObject | undefined {
  const value = parent?.[key];
  return isObject(value) ? value : undefined;
}

/** A whole number from 0, or undefined when it is absent or of another type. */
export function indexAt(parent: JsonObject | undefined, key: string): number | undefined {
  const value = parent?.[key];
  return typeof value === "number" && Number.isSafeInteger(value) && value >= 0 ? value : undefined;
}

/** A string, or undefined when it is absent or of another type. */
export function textAt(parent: JsonObject | undefined, key: string): string | undefined {
  const value = parent?.[key];
  return typeof value === "string" ? value : undefined;
}

/** A length or offset in bytes at `path`; absent gives `fallback`, anything but a whole number from 0 is an error. */
export function bytesAt(parent: JsonObject, key: string, path: string, name: string, fallback?: number): number {
  const value = parent[key] === undefined && fallback !== undefined ? fallback : indexAt(parent, key);
  if (value === undefined) {
    throw badContainer(name, `“${path}.${key}” is not a number of bytes`, `${path}.${key}`, parent[key] ?? "(absent)");
  }
  return value;
}

/** Names in "extensionsUsed". */
export function extensionsUsed(json: JsonObject): readonly string[] {
  const used = json.extensionsUsed;
  return Array.isArray(used) ? used.filter((item) => typeof item === "string") : [];
}
