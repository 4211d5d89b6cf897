/**
 * The outer shell of a model: a GLB's chunks or a `.gltf` text with its side files. Every length is checked against the
 * bytes that are there before it is used. Follows glTF 2.0, 4 (GLB) and 2.8 (URIs).
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import { viewOf } from "./byte-view.ts";
import type { ModelSource } from "./engine-api.ts";
import { parseExact, stringifyExact } from "./exact-numbers.ts";
import { badContainer, type JsonObject, listOf, parseGltfJson, textAt } from "./gltf-json.ts";
import { isDataUri } from "./gltf-resources.ts";

const GLB_MAGIC = 0x46546c67;
const CHUNK_JSON = 0x4e4f534a;
const CHUNK_BIN = 0x004e4942;

export interface GlbChunk {
  readonly type: number;
  readonly bytes: Uint8Array;
}

export interface GltfContainer {
  readonly name: string;
  /** The JSON as the file has it; `parseJson` gives a copy to change. */
  readonly jsonText: string;
  /** Parsed; shared, not to be changed. */
  readonly json: JsonObject;
  /** The BIN chunk, null without one. A view of the source's bytes. */
  readonly binary: Uint8Array | null;
  /** Chunks of other types, in order: glTF asks readers to ignore and keep them. */
  readonly extraChunks: readonly GlbChunk[];
  readonly isBinary: boolean;
  readonly resources: ReadonlyMap<string, Uint8Array>;
}

/** Reads a model's shell. Throws "bad-container" naming the file and what is wrong with it. */
export function readContainer(source: ModelSource): GltfContainer {
  const { name, bytes } = source;
  const resources = source.resources ?? new Map<string, Uint8Array>();
  const isGlb = bytes.length >= 4 && viewOf(bytes).getUint32(0, true) === GLB_MAGIC;
  if (isGlb) return { name, resources, isBinary: true, ...readGlb(bytes, name) };
  const start = bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf ? 3 : 0;
  if (firstCharacter(bytes, start) !== "{") throw notGltf(bytes, name);
  const jsonText = textOf(bytes.subarray(start));
  return {
    name,
    resources,
    isBinary: false,
    jsonText,
    json: parseGltfJson(jsonText, name),
    binary: null,
    extraChunks: [],
  };
}

/** A fresh copy of the container's JSON, free to change; numbers that JavaScript cannot hold are marked (exact-numbers.ts). */
export function parseJson(container: GltfContainer): JsonObject {
  return parseExact(container.jsonText);
}

function readGlb(bytes: Uint8Array, name: string): Pick<GltfContainer, "jsonText" | "json" | "binary" | "extraChunks"> {
  const view = viewOf(bytes);
  if (bytes.length < 12) throw badContainer(name, "it ends inside its header");
  const version = view.getUint32(4, true);
  if (version !== 2) {
    throw badContainer(name, `its container has version ${version}, only version 2 can be read`, "version", version);
  }
  const total = view.getUint32(8, true);
  if (total > bytes.length) {
    throw badContainer(
      name,
      `it says it has ${total} bytes but has ${bytes.length}: it was cut short`,
      "length",
      total,
    );
  }
  const chunks: GlbChunk[] = [];
  for (let at = 12; at + 8 <= total; ) {
    const length = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    if (length > total - at - 8) {
      const problem = `its chunk ${chunks.length} says it has ${length} bytes but ${total - at - 8} are left`;
      throw badContainer(name, problem, `chunks[${chunks.length}].length`, length);
    }
    chunks.push({ type, bytes: bytes.subarray(at + 8, at + 8 + length) });
    at += 8 + length;
  }
  const [first, second] = chunks;
  if (first === undefined || first.type !== CHUNK_JSON) throw badContainer(name, "its first chunk is not JSON");
  const jsonText = textOf(first.bytes);
  const hasBinary = second?.type === CHUNK_BIN;
  return {
    jsonText,
    json: parseGltfJson(jsonText, name),
    binary: hasBinary ? second.bytes : null,
    extraChunks: chunks.slice(hasBinary ? 2 : 1),
  };
}

/** A GLB out of its parts; chunks are padded to 4 bytes as glTF 2.0, 4.4 asks. */
export function writeGlb(
  json: JsonObject,
  binary: Uint8Array | null,
  extraChunks: readonly GlbChunk[] = [],
): Uint8Array<ArrayBuffer> {
  const chunks: { type: number; bytes: Uint8Array; padding: number }[] = [];
  chunks.push({ type: CHUNK_JSON, bytes: new TextEncoder().encode(stringifyExact(json)), padding: 0x20 });
  if (binary !== null && binary.length > 0) chunks.push({ type: CHUNK_BIN, bytes: binary, padding: 0 });
  for (const chunk of extraChunks) chunks.push({ ...chunk, padding: 0 });

  const total = chunks.reduce((sum, chunk) => sum + 8 + padded(chunk.bytes.length), 12);
  if (total > 0xffffffff) {
    throw new TexelcastError("out-of-budget", "The model would be larger than the 4 GiB that a GLB file can hold.", {
      value: String(total),
      hint: "Choose smaller textures.",
    });
  }
  const glb = new Uint8Array(total);
  const view = viewOf(glb);
  view.setUint32(0, GLB_MAGIC, true);
  view.setUint32(4, 2, true);
  view.setUint32(8, total, true);
  let at = 12;
  for (const { type, bytes, padding } of chunks) {
    const length = padded(bytes.length);
    view.setUint32(at, length, true);
    view.setUint32(at + 4, type, true);
    glb.set(bytes, at + 8);
    glb.fill(padding, at + 8 + bytes.length, at + 8 + length);
    at += 8 + length;
  }
  return glb;
}

/** The least multiple of `alignment` bytes, usually GLB's four, that holds `byteCount`. */
export function padded(byteCount: number, alignment = 4): number {
  return Math.ceil(byteCount / alignment) * alignment;
}

/**
 * The side files that a model's file names (buffers and images with a relative address), as written in the file, each
 * once: what to give as `ModelSource.resources`, under the same keys. Throws "bad-container" for what is not glTF.
 */
export function listSideFiles(source: Pick<ModelSource, "name" | "bytes">): string[] {
  const { json, name } = readContainer(source);
  const uris = new Set<string>();
  for (const item of [...listOf(json, "buffers", name), ...listOf(json, "images", name)]) {
    const uri = textAt(item, "uri");
    if (uri !== undefined && !isDataUri(uri)) uris.add(uri);
  }
  return [...uris];
}

/** Names in another encoding than glTF's UTF-8, as some exporters write them, lose the letters that cannot be told; the rest is of use. */
const textOf = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);

function firstCharacter(bytes: Uint8Array, start: number): string {
  let at = start;
  while (at < bytes.length && " \t\r\n".includes(String.fromCharCode(bytes[at] ?? 0))) at++;
  return String.fromCharCode(bytes[at] ?? 0);
}

/** How files begin that people drop by mistake. */
const OTHER_FORMATS: readonly (readonly [start: string, what: string])[] = [
  ["\x89PNG", "a PNG picture"],
  ["\xff\xd8\xff", "a JPEG picture"],
  ["PK\x03\x04", "a ZIP archive"],
  ["Kaydara FBX", "an FBX model"],
  ["BLENDER", "a Blender file"],
  ["ply\n", "a PLY model"],
  ["version https://git-lfs", "a Git LFS pointer, not the file itself"],
  ["<", "an HTML or XML page"],
];

function notGltf(bytes: Uint8Array, name: string): TexelcastError {
  const start = String.fromCharCode(...bytes.subarray(0, 32));
  const known = OTHER_FORMATS.find(([begin]) => start.startsWith(begin));
  let what = "it begins neither as a GLB (“glTF”) nor as JSON (“{”)";
  if (bytes.length === 0) what = "it is empty";
  else if (known !== undefined) what = `it seems to be ${known[1]}`;
  return new TexelcastError("bad-container", `“${name}” is not a glTF model: ${what}.`, {
    subject: name,
    hint: "Choose a .glb file, or a .gltf file with its side files.",
  });
}
