/** Models made accessor by accessor, for forms of geometry that `buildModel` does not know. */
import { writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";

const TYPES: Readonly<Record<number, string>> = { 1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4" };

type Numbers = Float32Array | Uint8Array | Int16Array | Uint16Array | Uint32Array;

const componentType = (values: Numbers): number => {
  if (values instanceof Float32Array) return 5126;
  if (values instanceof Uint32Array) return 5125;
  if (values instanceof Uint16Array) return 5123;
  return values instanceof Int16Array ? 5122 : 5121;
};

const bytesOf = ({ buffer, byteOffset, byteLength }: Numbers): Uint8Array =>
  new Uint8Array(buffer, byteOffset, byteLength);

export class GltfSketch {
  readonly #pieces: Uint8Array[] = [];
  readonly #views: JsonObject[] = [];
  readonly #accessors: JsonObject[] = [];
  #length = 0;

  /** A buffer view of these bytes. */
  view(bytes: Uint8Array, about: JsonObject = {}): number {
    this.#views.push({ buffer: 0, byteOffset: this.#length, byteLength: bytes.length, ...about });
    this.#pieces.push(bytes, new Uint8Array((4 - (bytes.length % 4)) % 4));
    this.#length += 4 * Math.ceil(bytes.length / 4);
    return this.#views.length - 1;
  }

  /** A buffer view of some of the bytes that an accessor's own view has. */
  viewOn(accessor: number, offset: number, byteLength: number): number {
    const { byteOffset } = this.#views[this.#accessors[accessor]?.bufferView as number] ?? {};
    return this.#views.push({ buffer: 0, byteOffset: (byteOffset as number) + offset, byteLength }) - 1;
  }

  /** An accessor of whatever the JSON says. */
  accessor(json: JsonObject): number {
    return this.#accessors.push(json) - 1;
  }

  /** Elements of `width` numbers, side by side but for what fills each up to four bytes. */
  values(values: Numbers, width: number, more: JsonObject = {}): number {
    const size = width * values.BYTES_PER_ELEMENT;
    const stride = width === 1 ? size : 4 * Math.ceil(size / 4);
    const bytes = new Uint8Array((values.length / width) * stride);
    for (let i = 0; i * width < values.length; i++) {
      bytes.set(bytesOf(values.subarray(i * width, (i + 1) * width)), i * stride);
    }
    const bufferView = this.view(bytes, stride === size ? {} : { byteStride: stride });
    const count = values.length / width;
    return this.accessor({
      bufferView,
      componentType: componentType(values),
      count,
      type: TYPES[width] ?? "",
      ...more,
    });
  }

  /** Places, with their bounds. */
  places(values: readonly number[], more: JsonObject = {}): number {
    return this.values(Float32Array.from(values), 3, { ...boundsOf(values), ...more });
  }

  /** What a sparse accessor puts in place of some of its elements. */
  sparse(indices: readonly number[], values: Float32Array): JsonObject {
    return {
      count: indices.length,
      indices: { bufferView: this.view(Uint8Array.from(indices)), componentType: 5121 },
      values: { bufferView: this.view(bytesOf(values)) },
    };
  }

  /** The file. `more` goes over a scene of one node with mesh 0. */
  glb(more: JsonObject): Uint8Array {
    const binary = new Uint8Array(this.#length);
    let at = 0;
    for (const piece of this.#pieces) {
      binary.set(piece, at);
      at += piece.length;
    }
    const json: JsonObject = {
      asset: { version: "2.0" },
      scene: 0,
      scenes: [{ nodes: [0] }],
      nodes: [{ mesh: 0 }],
      accessors: this.#accessors,
      bufferViews: this.#views,
      buffers: [{ byteLength: this.#length }],
      ...more,
    };
    return writeGlb(structuredClone(json), binary);
  }
}

/** `min` and `max` of places. */
export function boundsOf(values: readonly number[]): { min: number[]; max: number[] } {
  const along = (axis: number): number[] => values.filter((_, i) => i % 3 === axis).map(Math.fround);
  const axes = [0, 1, 2].map(along);
  return { min: axes.map((all) => Math.min(...all)), max: axes.map((all) => Math.max(...all)) };
}
