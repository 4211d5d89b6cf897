/**
 * Makes a model self-contained: all buffers become one BIN chunk, and pictures become parts of it. Compressed geometry
 * stays compressed. A GLB that is self-contained already keeps its JSON and BIN as they are.
 */
import { type GltfContainer, padded, parseJson } from "./gltf-container.ts";
import {
  badContainer,
  bytesAt,
  indexAt,
  type JsonObject,
  listForWriting,
  listOf,
  objectAt,
  textAt,
} from "./gltf-json.ts";
import { resolveUri } from "./gltf-resources.ts";
import { mediaTypeOf } from "./picture-header.ts";

export interface PackedGltf {
  /** Free to change. */
  readonly json: JsonObject;
  /** The bytes of buffer 0; null when the model has none. */
  readonly binary: Uint8Array | null;
}

/** Both names under which meshopt compression is found; KHR is the ratified one. */
export const MESHOPT_EXTENSIONS = ["EXT_meshopt_compression", "KHR_meshopt_compression"] as const;

/** Every accessor component (8 bytes at most) stays aligned when a buffer moves by a multiple of this. */
const BUFFER_ALIGNMENT = 8;

/** Throws "missing-file" for side files not given and "bad-container" for lengths that do not fit. */
export function packGltf(container: GltfContainer): PackedGltf {
  const json = parseJson(container);
  const { name } = container;
  const buffers = listOf(json, "buffers", name);
  const sources = buffers.map((buffer, i) => readBuffer(container, buffer, i));
  checkBufferViews(json, sources, name);

  const images = listOf(json, "images", name);
  const selfContained =
    sources.every((source) => source === null || source === container.binary) &&
    images.every((image) => image.uri === undefined);
  if (selfContained) return { json, binary: sources[0] ?? null };

  const parts = new PartList();
  const offsets = sources.map((source) => (source === null ? null : parts.add(source)));
  // Buffers without data of their own (meshopt's fallbacks) cannot go into the BIN; they keep an entry behind it.
  const fallbacks = buffers.filter((_, i) => sources[i] === null);
  for (const place of bufferPlaces(json, name)) {
    const index = indexAt(place, "buffer") ?? 0;
    const offset = offsets[index] ?? null;
    const buffer = buffers[index];
    if (offset === null && buffer !== undefined) place.buffer = 1 + fallbacks.indexOf(buffer);
    else {
      place.buffer = 0;
      place.byteOffset = (offset ?? 0) + (indexAt(place, "byteOffset") ?? 0);
    }
  }
  for (const [i, image] of images.entries()) packImage(container, json, parts, image, i);

  const binary = parts.join();
  const { uri: _, ...rest } = buffers.find((__, i) => sources[i] !== null) ?? {};
  if (binary.length > 0) json.buffers = [{ ...rest, byteLength: binary.length }, ...fallbacks];
  return { json, binary: binary.length > 0 ? binary : null };
}

/** Everything that points into a buffer: buffer views, and what their meshopt extension says of the compressed bytes. */
export function bufferPlaces(json: JsonObject, name: string): JsonObject[] {
  return listOf(json, "bufferViews", name).flatMap((view) => {
    const compressed = MESHOPT_EXTENSIONS.map((extension) => objectAt(objectAt(view, "extensions"), extension));
    return [view, ...compressed.filter((place) => place !== undefined)];
  });
}

/** A buffer's bytes, at least `byteLength`; null for a meshopt fallback, which has none. */
function readBuffer(container: GltfContainer, buffer: JsonObject, index: number): Uint8Array | null {
  const { name } = container;
  const path = `buffers[${index}]`;
  const byteLength = bytesAt(buffer, "byteLength", path, name);
  const uri = textAt(buffer, "uri");
  if (uri === undefined && MESHOPT_EXTENSIONS.some((key) => objectAt(objectAt(buffer, "extensions"), key)?.fallback)) {
    return null;
  }
  const inFile = index === 0 && container.isBinary ? container.binary : null;
  const bytes = uri === undefined ? inFile : resolveUri(uri, `${path}.uri`, name, container.resources).bytes;
  if (bytes === null) throw badContainer(name, `“${path}” has no data`, path);
  if (bytes.length < byteLength) {
    const problem = `“${path}” should have ${byteLength} bytes but has ${bytes.length}`;
    throw badContainer(name, problem, `${path}.byteLength`, byteLength);
  }
  return bytes;
}

function checkBufferViews(json: JsonObject, sources: readonly (Uint8Array | null)[], name: string): void {
  const buffers = listOf(json, "buffers", name);
  for (const [i, view] of listOf(json, "bufferViews", name).entries()) {
    const path = `bufferViews[${i}]`;
    const compressed = MESHOPT_EXTENSIONS.map((key) => objectAt(objectAt(view, "extensions"), key));
    for (const place of [view, ...compressed]) {
      if (place === undefined) continue;
      const index = indexAt(place, "buffer");
      const buffer = index === undefined ? undefined : buffers[index];
      if (index === undefined || buffer === undefined) {
        throw badContainer(
          name,
          `“${path}” names no buffer of the model`,
          `${path}.buffer`,
          place.buffer ?? "(absent)",
        );
      }
      const end = bytesAt(place, "byteOffset", path, name, 0) + bytesAt(place, "byteLength", path, name);
      const room = bytesAt(buffer, "byteLength", `buffers[${index}]`, name);
      if (end > room || (place !== view && sources[index] === null)) {
        const problem = `“${path}” reaches to byte ${end} of buffers[${index}], which has ${room}`;
        throw badContainer(name, problem, `${path}.byteLength`, place.byteLength);
      }
    }
  }
}

function packImage(
  container: GltfContainer,
  json: JsonObject,
  parts: PartList,
  image: JsonObject,
  index: number,
): void {
  const uri = textAt(image, "uri");
  if (uri === undefined) return;
  const { bytes, mediaType } = resolveUri(uri, `images[${index}].uri`, container.name, container.resources);
  const views = listForWriting(json, "bufferViews", container.name);
  image.bufferView = views.length;
  views.push({ buffer: 0, byteOffset: parts.add(bytes), byteLength: bytes.length });
  const type = mediaTypeOf(bytes) ?? textAt(image, "mimeType") ?? mediaType;
  if (type !== "") image.mimeType = type;
  delete image.uri;
}

/** Pieces of a BIN to be, each at an aligned offset. */
class PartList {
  readonly #parts: { readonly offset: number; readonly bytes: Uint8Array }[] = [];
  #length = 0;

  /** Returns the offset at which the bytes will lie. */
  add(bytes: Uint8Array): number {
    const offset = padded(this.#length, BUFFER_ALIGNMENT);
    this.#parts.push({ offset, bytes });
    this.#length = offset + bytes.length;
    return offset;
  }

  join(): Uint8Array {
    const joined = new Uint8Array(this.#length);
    for (const { offset, bytes } of this.#parts) joined.set(bytes, offset);
    return joined;
  }
}
