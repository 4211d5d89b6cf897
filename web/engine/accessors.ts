/**
 * A model's accessors, read for changing a mesh: as numbers, and as the bytes of single elements, so that what is only
 * moved (joints, weights, morph targets, quantised places) comes out as it went in. glTF 2.0, 3.6.2.
 */
import { COMPONENT_BYTES, SHAPES } from "./accessor-shapes.ts";
import { dropReplaced } from "./drop-replaced.ts";
import { padded } from "./gltf-container.ts";
import { badContainer, indexAt, type JsonObject, listForWriting, listOf, objectAt, textAt } from "./gltf-json.ts";
import { GrowingBinary } from "./growing-binary.ts";

const ALIGNMENT = 4;
export const ARRAY_BUFFER = 34962;
export const ELEMENT_ARRAY_BUFFER = 34963;
export const FLOAT = 5126;
export const UNSIGNED_INT = 5125;
const UNSIGNED_SHORT = 5123;

/** Elements side by side, without gaps between them. */
export interface Elements {
  readonly count: number;
  readonly elementBytes: number;
  readonly bytes: Uint8Array;
}

/**
 * Reads accessors of a self-contained, uncompressed model, and writes new ones behind its bytes. Their numbers hold until it is
 * finished.
 */
export class Accessors {
  readonly #json: JsonObject;
  readonly #binary: GrowingBinary;
  readonly #name: string;
  readonly #replaced = new Set<number>();

  /** `json` is changed in place; `binary` is only read. `name` is the file that errors name. */
  constructor(json: JsonObject, binary: Uint8Array | null, name: string) {
    this.#json = json;
    this.#binary = new GrowingBinary(binary);
    this.#name = name;
  }

  /** The accessor's own JSON. Throws "bad-container" where there is none. */
  at(index: number): JsonObject {
    const accessor = listOf(this.#json, "accessors", this.#name)[index];
    if (accessor === undefined) throw this.#fault(index, "is not there");
    return accessor;
  }

  /**
   * All elements of an accessor, sparse ones filled in. Throws "bad-container" for lengths that do not fit, and for another
   * number than that of the vertices, where it is given: no room is made for what a file only claims to have.
   */
  read(index: number, vertexCount?: number): Elements {
    const accessor = this.at(index);
    const count = indexAt(accessor, "count") ?? 0;
    if (vertexCount !== undefined && count !== vertexCount) {
      throw badContainer(
        this.#name,
        `“accessors[${index}]” has ${count} elements for ${vertexCount} vertices`,
        `accessors[${index}].count`,
        accessor.count,
      );
    }
    const { columns, columnBytes } = this.#shape(index, accessor);
    const elementBytes = columns * columnBytes;
    const bytes = new Uint8Array(count * elementBytes);
    if (accessor.bufferView !== undefined) {
      this.#gather(index, accessor, indexAt(accessor, "byteOffset") ?? 0, count, elementBytes, bytes);
    }
    const sparse = objectAt(accessor, "sparse");
    if (sparse !== undefined) this.#fillSparse(index, sparse, elementBytes, bytes);
    return { count, elementBytes, bytes };
  }

  /** The same as numbers; normalised integers become the fractions that they stand for. */
  readNumbers(index: number, vertexCount?: number): Float64Array {
    const accessor = this.at(index);
    const { bytes } = this.read(index, vertexCount);
    const type = accessor.componentType as number;
    const size = COMPONENT_BYTES[type] ?? 1;
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const numbers = new Float64Array(bytes.length / size);
    for (let i = 0; i < numbers.length; i++) {
      const value = componentAt(view, i * size, type);
      numbers[i] = accessor.normalized === true ? fractionOf(value, type) : value;
    }
    return numbers;
  }

  /** Says that one is written anew: it goes in the end, unless somebody else names it. */
  replace(index: number): void {
    this.#replaced.add(index);
  }

  /** The accessor anew with some of its elements; what else it says (type, name) it keeps. Returns its index. */
  addLike(index: number, elements: Elements): number {
    const { bufferView: _, byteOffset: __, sparse: ___, ...kept } = this.at(index);
    if (kept.min !== undefined || kept.max !== undefined) Object.assign(kept, boundsOf(elements, kept));
    // glTF has every element of an attribute begin at a multiple of four bytes.
    const stride = padded(elements.elementBytes, ALIGNMENT);
    const bytes = new Uint8Array(elements.count * stride);
    for (let i = 0; i < elements.count; i++) {
      bytes.set(elements.bytes.subarray(i * elements.elementBytes, (i + 1) * elements.elementBytes), i * stride);
    }
    const view = this.#addView(bytes, { byteStride: stride, target: ARRAY_BUFFER });
    return this.#push({ ...kept, bufferView: view, count: elements.count });
  }

  /** An accessor of texture coordinates, two numbers each. */
  addUvs(uvs: Float32Array): number {
    const bytes = new Uint8Array(uvs.length * 4);
    const view = new DataView(bytes.buffer);
    for (const [i, value] of uvs.entries()) view.setFloat32(i * 4, value, true);
    const bufferView = this.#addView(bytes, { byteStride: 8, target: ARRAY_BUFFER });
    return this.#push({ bufferView, componentType: FLOAT, count: uvs.length / 2, type: "VEC2" });
  }

  /** An accessor of indices; the value that restarts a strip stays unused, as glTF asks. */
  addIndices(indices: Uint32Array, vertexCount: number): number {
    const wide = vertexCount > 0xffff;
    const size = wide ? 4 : 2;
    const bytes = new Uint8Array(indices.length * size);
    const view = new DataView(bytes.buffer);
    for (const [i, value] of indices.entries()) {
      if (wide) view.setUint32(i * size, value, true);
      else view.setUint16(i * size, value, true);
    }
    const bufferView = this.#addView(bytes, { target: ELEMENT_ARRAY_BUFFER });
    const componentType = wide ? UNSIGNED_INT : UNSIGNED_SHORT;
    return this.#push({ bufferView, componentType, count: indices.length, type: "SCALAR" });
  }

  /** The BIN with all that was added, and without what was replaced; "buffers" says its length. */
  finish(): Uint8Array {
    return dropReplaced(this.#json, this.#binary.finish(this.#json, this.#name), this.#replaced, this.#name);
  }

  #push(accessor: JsonObject): number {
    return listForWriting(this.#json, "accessors", this.#name).push(accessor) - 1;
  }

  #addView(bytes: Uint8Array, about: JsonObject): number {
    const byteOffset = this.#binary.append(bytes, ALIGNMENT);
    const views = listForWriting(this.#json, "bufferViews", this.#name);
    return views.push({ buffer: 0, byteOffset, byteLength: bytes.length, ...about }) - 1;
  }

  #shape(index: number, accessor: JsonObject): { readonly columns: number; readonly columnBytes: number } {
    const [columns, rows] = SHAPES[textAt(accessor, "type") ?? ""] ?? [0, 0];
    const component = COMPONENT_BYTES[accessor.componentType as number];
    if (columns === 0 || component === undefined) throw this.#fault(index, "has no known type");
    const columnBytes = rows * component;
    return { columns, columnBytes: columns > 1 ? padded(columnBytes, ALIGNMENT) : columnBytes };
  }

  /** `count` elements of the place's buffer view, side by side, into `target`. */
  #gather(
    index: number,
    place: JsonObject,
    offset: number,
    count: number,
    elementBytes: number,
    target: Uint8Array,
  ): void {
    const view = listOf(this.#json, "bufferViews", this.#name)[indexAt(place, "bufferView") ?? -1];
    if (view === undefined) throw this.#fault(index, "names no buffer view of the model");
    const stride = indexAt(view, "byteStride") ?? elementBytes;
    const start = (indexAt(view, "byteOffset") ?? 0) + offset;
    const end = (indexAt(view, "byteOffset") ?? 0) + (indexAt(view, "byteLength") ?? 0);
    if (count > 0 && (start + (count - 1) * stride + elementBytes > end || end > this.#binary.old.length)) {
      throw this.#fault(index, "reaches beyond its buffer view");
    }
    for (let i = 0; i < count; i++) {
      const from = start + i * stride;
      target.set(this.#binary.old.subarray(from, from + elementBytes), i * elementBytes);
    }
  }

  #fillSparse(index: number, sparse: JsonObject, elementBytes: number, bytes: Uint8Array): void {
    const count = indexAt(sparse, "count") ?? 0;
    const indices = objectAt(sparse, "indices") ?? {};
    const type = indices.componentType as number;
    const size = COMPONENT_BYTES[type] ?? 1;
    const places = new Uint8Array(count * size);
    this.#gather(index, indices, indexAt(indices, "byteOffset") ?? 0, count, size, places);
    const values = objectAt(sparse, "values") ?? {};
    const elements = new Uint8Array(count * elementBytes);
    this.#gather(index, values, indexAt(values, "byteOffset") ?? 0, count, elementBytes, elements);
    const view = new DataView(places.buffer);
    for (let i = 0; i < count; i++) {
      const place = componentAt(view, i * size, type) * elementBytes;
      if (place + elementBytes > bytes.length) throw this.#fault(index, "has a sparse element beyond its end");
      bytes.set(elements.subarray(i * elementBytes, (i + 1) * elementBytes), place);
    }
  }

  #fault(index: number, what: string): Error {
    const accessor = listOf(this.#json, "accessors", this.#name)[index] ?? "(absent)";
    return badContainer(this.#name, `“accessors[${index}]” ${what}`, `accessors[${index}]`, accessor);
  }
}

/** The least and the greatest of each component, as glTF 2.0, 3.6.2.5 asks of places: what was left out has no say. */
export function boundsOf(
  { count, elementBytes, bytes }: Elements,
  accessor: JsonObject,
): { readonly min: number[]; readonly max: number[] } {
  const type = accessor.componentType as number;
  const size = COMPONENT_BYTES[type] ?? 1;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const min = new Array<number>(elementBytes / size).fill(Number.POSITIVE_INFINITY);
  const max = new Array<number>(elementBytes / size).fill(Number.NEGATIVE_INFINITY);
  for (let i = 0; i < count * min.length; i++) {
    const [value, component] = [componentAt(view, i * size, type), i % min.length];
    min[component] = Math.min(min[component] as number, value);
    max[component] = Math.max(max[component] as number, value);
  }
  return { min, max };
}

function componentAt(view: DataView, offset: number, type: number): number {
  if (type === 5120) return view.getInt8(offset);
  if (type === 5121) return view.getUint8(offset);
  if (type === 5122) return view.getInt16(offset, true);
  if (type === 5123) return view.getUint16(offset, true);
  if (type === 5125) return view.getUint32(offset, true);
  return view.getFloat32(offset, true);
}

function fractionOf(value: number, type: number): number {
  if (type === 5120) return Math.max(value / 0x7f, -1);
  if (type === 5121) return value / 0xff;
  if (type === 5122) return Math.max(value / 0x7fff, -1);
  if (type === 5123) return value / 0xffff;
  return value;
}
