import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { Accessors } from "../../web/engine/accessors.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";

/** glTF 2.0, 3.6.2.2: bytes of a number, how it is written, its fraction where it is normalised (3.11). */
const NUMBERS = [
  { type: 5120, size: 1, put: "setInt8", low: -128, high: 127, fraction: (n: number) => Math.max(n / 127, -1) },
  { type: 5121, size: 1, put: "setUint8", low: 0, high: 255, fraction: (n: number) => n / 255 },
  {
    type: 5122,
    size: 2,
    put: "setInt16",
    low: -32_768,
    high: 32_767,
    fraction: (n: number) => Math.max(n / 32_767, -1),
  },
  { type: 5123, size: 2, put: "setUint16", low: 0, high: 65_535, fraction: (n: number) => n / 65_535 },
  { type: 5125, size: 4, put: "setUint32", low: 0, high: 2 ** 32 - 1, fraction: (n: number) => n },
  { type: 5126, size: 4, put: "setFloat32", low: -1000, high: 1000, fraction: (n: number) => n },
] as const;
type NumberType = (typeof NUMBERS)[number];
const SHAPES = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 } as const;
type Shape = keyof typeof SHAPES;

/** Nothing is said where it is 0. */
const offsetOf = (byteOffset: number): JsonObject => (byteOffset === 0 ? {} : { byteOffset });

/** A buffer that is filled from its front, and the views of it. */
class SketchedBuffer {
  readonly bytes = new Uint8Array(8192).fill(0xa5);
  readonly views: JsonObject[] = [];
  #end = 0;

  /** Elements a stride apart, behind `before` bytes of the view that are something else's. */
  add(elements: readonly (readonly number[])[], { size, put }: NumberType, stride: number, before: number): number {
    const start = this.#end;
    const view = new DataView(this.bytes.buffer);
    for (const [index, element] of elements.entries()) {
      for (const [place, value] of element.entries())
        view[put](start + before + index * stride + place * size, value, true);
    }
    const last =
      elements.length === 0 ? 0 : (elements.length - 1) * stride + (elements[0] as readonly number[]).length * size;
    this.#end = Math.ceil((start + before + last) / 4) * 4 + 8;
    const isTight = stride === (elements[0]?.length ?? 0) * size;
    const described = {
      buffer: 0,
      ...offsetOf(start),
      byteLength: before + last,
      ...(isTight ? {} : { byteStride: stride }),
    };
    return this.views.push(described) - 1;
  }
}

interface Sketch {
  readonly number: NumberType;
  readonly shape: Shape;
  readonly elements: number[][];
  readonly gap: number;
  readonly before: number;
  readonly normalized: boolean;
  /** Places and what stands there instead. */
  readonly sparse: readonly (readonly [number, number[]])[];
  readonly indexType: NumberType;
  readonly isBare: boolean;
}

const arbitrarySketch: fc.Arbitrary<Sketch> = fc
  .record({
    number: fc.constantFrom(...NUMBERS),
    shape: fc.constantFrom(...(Object.keys(SHAPES) as Shape[])),
    indexType: fc.constantFrom(NUMBERS[1], NUMBERS[3], NUMBERS[4]),
    gap: fc.integer({ min: 0, max: 3 }),
    before: fc.integer({ min: 0, max: 3 }),
    normalized: fc.boolean(),
    isBare: fc.boolean(),
    count: fc.integer({ min: 1, max: 12 }),
  })
  .chain((head) => {
    const element = fc.array(
      fc.oneof(
        fc.constantFrom(head.number.low, head.number.high, 0),
        fc.integer({ min: head.number.low, max: head.number.high }),
      ),
      { minLength: SHAPES[head.shape], maxLength: SHAPES[head.shape] },
    );
    return fc.record({
      number: fc.constant(head.number),
      shape: fc.constant(head.shape),
      indexType: fc.constant(head.indexType),
      gap: fc.constant(head.gap),
      before: fc.constant(head.before),
      normalized: fc.constant(head.normalized),
      isBare: fc.constant(head.isBare),
      elements: fc.array(element, { minLength: head.count, maxLength: head.count }),
      sparse: fc
        .uniqueArray(fc.tuple(fc.integer({ min: 0, max: head.count - 1 }), element), { selector: ([place]) => place })
        .map((list) => list.toSorted(([a], [b]) => a - b)),
    });
  });

/** The accessor of a sketch, and the file that has it. */
function fileOf({ number, shape, elements, gap, before, normalized, sparse, indexType, isBare }: Sketch) {
  const buffer = new SketchedBuffer();
  const elementBytes = SHAPES[shape] * number.size;
  const accessor: JsonObject = { componentType: number.type, type: shape, count: elements.length, normalized };
  if (!isBare) {
    accessor.bufferView = buffer.add(elements, number, elementBytes + gap * number.size, before * number.size);
    Object.assign(accessor, offsetOf(before * number.size));
  }
  if (sparse.length > 0) {
    const places = sparse.map(([place]) => [place]);
    const values = sparse.map(([, value]) => value);
    accessor.sparse = {
      count: sparse.length,
      indices: {
        bufferView: buffer.add(places, indexType, indexType.size, before * indexType.size),
        ...offsetOf(before * indexType.size),
        componentType: indexType.type,
      },
      values: {
        bufferView: buffer.add(values, number, elementBytes, gap * number.size),
        ...offsetOf(gap * number.size),
      },
    };
  }
  const json = { buffers: [{ byteLength: 8192 }], bufferViews: buffer.views, accessors: [accessor] } as JsonObject;
  return { json, bytes: buffer.bytes, accessor };
}

/** What the standard says stands in it. */
function meant({ elements, sparse, isBare }: Sketch): number[][] {
  const list = elements.map((element) => (isBare ? element.map(() => 0) : element));
  for (const [place, value] of sparse) list[place] = value;
  return list;
}

const numbersOf = (accessors: Accessors, index: number): number[] => [...accessors.readNumbers(index)];

describe("an accessor", () => {
  it("is read as glTF says: any type, apart or side by side, with sparse elements, over nothing, as fractions", () => {
    fc.assert(
      fc.property(arbitrarySketch, (sketch) => {
        const { json, bytes } = fileOf(sketch);
        const { number, normalized } = sketch;
        const expected = meant(sketch)
          .flat()
          .map((value) => (normalized ? number.fraction(value) : value));
        const read = numbersOf(new Accessors(json, bytes, "m.glb"), 0);
        expect(read.map((value) => value + 0)).toEqual(expected.map((value) => value + 0));
      }),
      { numRuns: 400 },
    );
  });

  it("written anew with some of its elements holds those, says their bounds, and begins each at a multiple of four", () => {
    fc.assert(
      fc.property(arbitrarySketch, fc.array(fc.nat(), { minLength: 1, maxLength: 6 }), (sketch, picks) => {
        const { json, bytes, accessor } = fileOf(sketch);
        Object.assign(accessor, { min: [], max: [], name: "its name", normalized: false });
        const accessors = new Accessors(json, bytes, "m.glb");
        const all = accessors.read(0);
        const places = picks.map((pick) => pick % all.count);
        const chosen = places.flatMap((at) => [
          ...all.bytes.subarray(at * all.elementBytes, (at + 1) * all.elementBytes),
        ]);
        const elements = { ...all, count: places.length, bytes: Uint8Array.from(chosen) };
        const index = accessors.addLike(0, elements);
        const added = accessors.at(index);
        const expected = places.map((at) => meant(sketch)[at] as number[]);
        const columns = (expected[0] as number[]).map((_, column) =>
          expected.map((element) => element[column] as number),
        );
        const finished = accessors.finish();
        expect(numbersOf(new Accessors(json, finished, "m.glb"), index).map((value) => value + 0)).toEqual(
          expected.flat(),
        );
        expect((added.min as number[]).map((value) => value + 0)).toEqual(columns.map((column) => Math.min(...column)));
        expect((added.max as number[]).map((value) => value + 0)).toEqual(columns.map((column) => Math.max(...column)));
        expect(added).toMatchObject({ name: "its name", count: places.length });
        expect(added.sparse).toBeUndefined();
        const { byteStride, byteOffset } = (json.bufferViews as JsonObject[])[added.bufferView as number] as JsonObject;
        expect([(byteStride as number) % 4, (byteOffset as number) % 4]).toEqual([0, 0]);
      }),
      { numRuns: 200 },
    );
  });

  it("of indices takes two bytes each for as many vertices as those can name, and four for more", () => {
    for (const [vertices, type] of [
      [3, 5123],
      [65_535, 5123],
      [65_536, 5125],
    ] as const) {
      const json = { asset: { version: "2.0" } } as JsonObject;
      const accessors = new Accessors(json, null, "m.glb");
      const indices = Uint32Array.of(0, 1, vertices - 1);
      const index = accessors.addIndices(indices, vertices);
      expect(accessors.at(index)).toMatchObject({ componentType: type, count: 3, type: "SCALAR" });
      const finished = accessors.finish();
      expect(numbersOf(new Accessors(json, finished, "m.glb"), index)).toEqual([...indices]);
    }
  });

  it("is refused where its last element reaches a byte beyond its view, or its view a byte beyond the buffer", () => {
    fc.assert(
      fc.property(arbitrarySketch, fc.constantFrom("view", "buffer"), (sketch, what) => {
        const { json, bytes } = fileOf({ ...sketch, isBare: false, sparse: [] });
        const view = (json.bufferViews as JsonObject[])[0] as JsonObject;
        const end = ((view.byteOffset ?? 0) as number) + (view.byteLength as number);
        expect(() => new Accessors(json, bytes.subarray(0, end), "m.glb").read(0)).not.toThrow();
        if (what === "view") view.byteLength = (view.byteLength as number) - 1;
        const short = what === "view" ? bytes : bytes.subarray(0, end - 1);
        expect(() => new Accessors(json, short, "m.glb").read(0)).toThrow(TexelcastError);
      }),
    );
  });

  it("is refused where a sparse element stands beyond its end", () => {
    const number = NUMBERS[5];
    const sketch = (place: number): Sketch => ({
      number,
      shape: "VEC3",
      elements: [[1, 2, 3]],
      gap: 0,
      before: 0,
      normalized: false,
      sparse: [[place, [4, 5, 6]]],
      indexType: NUMBERS[1],
      isBare: false,
    });
    const read = (place: number) => {
      const { json, bytes } = fileOf(sketch(place));
      return numbersOf(new Accessors(json, bytes, "m.glb"), 0);
    };
    expect(read(0)).toEqual([4, 5, 6]);
    expect(() => read(1)).toThrow("sparse element beyond its end");
  });
});
