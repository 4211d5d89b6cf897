/**
 * Puts unpacked geometry into the file's own JSON, in place of what compression said of it. All else stays as it was, also
 * every index: what compression held is where it was named, and what needs a place of its own gets one behind all others.
 */
import type { TypedArray } from "@gltf-transform/core";
import { SHAPES } from "./accessor-shapes.ts";
import { Accessors, ARRAY_BUFFER, boundsOf, ELEMENT_ARRAY_BUFFER } from "./accessors.ts";
import { bytesIn, cutsOf, moveViews, type Span, spanOf, withoutCuts } from "./cut-bytes.ts";
import { stringifyExact } from "./exact-numbers.ts";
import { forgetExtension } from "./extension-names.ts";
import { padded } from "./gltf-container.ts";
import { badContainer, indexAt, isObject, type JsonObject, listOf, objectAt, textAt } from "./gltf-json.ts";
import { MESHOPT_EXTENSIONS } from "./gltf-packer.ts";
import { allPrimitives } from "./gltf-primitives.ts";
import { COMPRESSION, DRACO } from "./model-extensions.ts";
import { dracoOf, meshoptOf, type UnpackedGeometry } from "./unpack-geometry.ts";

/** Every number, of 8 bytes at most, lies at a multiple of its size. */
const ALIGNMENT = 8;
/** glTF has every element of an attribute begin at a multiple of these. */
const ELEMENT_ALIGNMENT = 4;
const TRIANGLE_STRIP = 5;

/** Kinds of indices, narrow ones first; the greatest number of each restarts a strip, and is none. */
const INDEX_KINDS = [
  { type: 5121, kind: Uint8Array, end: 0xff },
  { type: 5123, kind: Uint16Array, end: 0xffff },
  { type: 5125, kind: Uint32Array, end: 0xffffffff },
] as const;

/**
 * The BIN that belongs to `json`, which is changed in place; `binary` is only read. `name` is the file that errors name. Throws
 * "bad-container" for a buffer view without bytes, and for accessors that do not fit them.
 */
export function graftGeometry(
  json: JsonObject,
  binary: Uint8Array,
  unpacked: UnpackedGeometry,
  name: string,
): Uint8Array {
  const views = listOf(json, "bufferViews", name);
  checkBytes(views, unpacked, name);
  const indices = new Set<unknown>();
  const held = new Set<number>();
  for (const primitive of allPrimitives(json, name)) {
    const view = indexAt(dracoOf(primitive), "bufferView");
    if (view === undefined) continue;
    held.add(view);
    indices.add(primitive.indices);
    // Draco's triangles are unpacked one by one, those of strips as well.
    if (primitive.mode === TRIANGLE_STRIP) delete primitive.mode;
    forgetIn(primitive, [DRACO]);
  }
  for (const index of viewsInUse(json, unpacked, name)) held.delete(index);
  const gone: Span[] = [...held].map((index) => spanOf(views[index] ?? {}));
  for (const index of unpacked.views.keys()) {
    const view = views[index] as JsonObject;
    gone.push(spanOf(meshoptOf(view)?.place ?? {}));
    if (view.buffer === 0) gone.push(spanOf(view));
    forgetIn(view, MESHOPT_EXTENSIONS);
  }
  const kept = views.filter((_, index) => !held.has(index) && !unpacked.views.has(index)).map(spanOf);
  // Buffers behind the first are meshopt's, of which nothing is left.
  const buffers = listOf(json, "buffers", name);
  if (buffers.length > 1) json.buffers = buffers.slice(0, 1);
  const [buffer] = buffers;
  if (buffer !== undefined) forgetIn(buffer, MESHOPT_EXTENSIONS);

  const cuts = cutsOf(joined(gone), kept);
  moveViews(json, cuts, name);
  const added: { readonly byteOffset: number; readonly bytes: Uint8Array }[] = [];
  const oldLength = binary.length - bytesIn(cuts);
  let length = oldLength;
  const add = (bytes: Uint8Array): { buffer: number; byteOffset: number; byteLength: number } => {
    const byteOffset = padded(length, ALIGNMENT);
    added.push({ byteOffset, bytes });
    length = byteOffset + bytes.length;
    return { buffer: 0, byteOffset, byteLength: bytes.length };
  };
  for (const [index, bytes] of unpacked.views) {
    Object.assign(views[index] as JsonObject, add(bytes));
  }
  const accessors = listOf(json, "accessors", name);
  const free = [...held];
  for (const [index, values] of unpacked.accessors) {
    const accessor = accessors[index] as JsonObject;
    const { bytes, ...about } = indices.has(index)
      ? indexBytes(accessor, values)
      : attributeBytes(accessor, values, index);
    const bufferView = free.shift() ?? views.push({}) - 1;
    Object.assign(views[bufferView] as JsonObject, add(bytes), about);
    accessor.bufferView = bufferView;
    delete accessor.byteOffset;
  }
  for (const extension of COMPRESSION) forgetExtension(json, extension);
  // Made once, with all in it: models are large, and this is one of their copies.
  const grown = withoutCuts(binary, cuts, length - oldLength);
  for (const { byteOffset, bytes } of added) grown.set(bytes, byteOffset);
  if (buffer !== undefined && added.length > 0) buffer.byteLength = length;
  correctBounds(json, grown, unpacked, name);
  return grown;
}

/** Only what is compressed may lie in a buffer without bytes. */
function checkBytes(views: readonly JsonObject[], unpacked: UnpackedGeometry, name: string): void {
  for (const [index, view] of views.entries()) {
    if (view.buffer === 0 || unpacked.views.has(index)) continue;
    const problem = `“bufferViews[${index}]” is not compressed, and lies in “buffers[${view.buffer}]”, which has no data`;
    throw badContainer(name, problem, `bufferViews[${index}].buffer`, view.buffer);
  }
}

/** Of Draco's, those whose bytes something else shows: they stay. */
function viewsInUse(json: JsonObject, unpacked: UnpackedGeometry, name: string): number[] {
  const accessors = listOf(json, "accessors", name).flatMap((accessor, index) => {
    const sparse = objectAt(accessor, "sparse");
    const parts = [objectAt(sparse, "indices"), objectAt(sparse, "values")];
    return unpacked.accessors.has(index) ? parts : [accessor, ...parts];
  });
  const inUse = [...accessors, ...listOf(json, "images", name)].map((holder) => indexAt(holder, "bufferView"));
  return [...inUse.filter((index) => index !== undefined), ...unpacked.views.keys()];
}

/** What is between two of them is no more than what aligns the second. */
function joined(spans: readonly Span[]): Span[] {
  const all: Span[] = [];
  for (const span of spans.toSorted((a, b) => a.start - b.start)) {
    const last = all.at(-1);
    if (last === undefined || span.start > padded(last.end, ALIGNMENT)) all.push(span);
    else all[all.length - 1] = { start: last.start, end: Math.max(last.end, span.end) };
  }
  return all;
}

/** In the kind of numbers that the file says, or in a wider one if they do not fit. */
function indexBytes(accessor: JsonObject, values: TypedArray): { bytes: Uint8Array; target: number } {
  const most = values.reduce((greatest: number, value: number) => Math.max(greatest, value), 0);
  const first = INDEX_KINDS.findIndex(({ type }) => type === accessor.componentType);
  const fitting = INDEX_KINDS.find(({ end }, i) => i >= first && most < end) ?? INDEX_KINDS[2];
  accessor.componentType = fitting.type;
  accessor.count = values.length;
  return {
    bytes: bytesOf(values instanceof fitting.kind ? values : fitting.kind.from(values)),
    target: ELEMENT_ARRAY_BUFFER,
  };
}

function attributeBytes(
  accessor: JsonObject,
  values: TypedArray,
  index: number,
): { bytes: Uint8Array; target: number; byteStride?: number } {
  const [columns, rows] = SHAPES[textAt(accessor, "type") ?? ""] ?? [0, 0];
  const count = values.length / (columns * rows);
  if (!Number.isSafeInteger(count)) throw new Error(`Draco holds no ${accessor.type} for accessors[${index}].`);
  accessor.count = count;
  const tight = bytesOf(values);
  const elementBytes = tight.length / count;
  const byteStride = padded(elementBytes, ELEMENT_ALIGNMENT);
  if (byteStride === elementBytes) return { bytes: tight, target: ARRAY_BUFFER };
  const bytes = new Uint8Array(count * byteStride);
  for (let i = 0; i < count; i++) bytes.set(tight.subarray(i * elementBytes, (i + 1) * elementBytes), i * byteStride);
  return { bytes, target: ARRAY_BUFFER, byteStride };
}

const bytesOf = (values: TypedArray): Uint8Array => new Uint8Array(values.buffer, values.byteOffset, values.byteLength);

/** Compression moves numbers a little, and what a file says of the least and the greatest is often of those before it. */
function correctBounds(json: JsonObject, binary: Uint8Array, unpacked: UnpackedGeometry, name: string): void {
  const reader = new Accessors(json, binary, name);
  for (const [index, accessor] of listOf(json, "accessors", name).entries()) {
    if (accessor.min === undefined && accessor.max === undefined) continue;
    const sparse = objectAt(accessor, "sparse");
    const places = [accessor, objectAt(sparse, "indices"), objectAt(sparse, "values")];
    const isUnpacked =
      unpacked.accessors.has(index) || places.some((place) => unpacked.views.has(indexAt(place, "bufferView") ?? -1));
    if (!isUnpacked) continue;
    const found = boundsOf(reader.read(index), accessor);
    for (const key of ["min", "max"] as const) {
      if (accessor[key] !== undefined && !isSame(accessor[key], found[key])) accessor[key] = found[key];
    }
  }
}

/** As the numbers of a file are, of single precision; what is found may not be a number. */
function isSame(said: JsonObject[string], found: readonly number[]): boolean {
  if (!Array.isArray(said) || said.length !== found.length || !found.every(Number.isFinite)) return true;
  const numbers = JSON.parse(stringifyExact({ said })).said as unknown[];
  return numbers.every((value, i) => value === found[i] || Math.fround(Number(value)) === found[i]);
}

function forgetIn(holder: JsonObject, names: readonly string[]): void {
  const { extensions } = holder;
  if (!isObject(extensions)) return;
  for (const key of names) delete extensions[key];
  if (Object.keys(extensions).length === 0) delete holder.extensions;
}
