/** What the file written still holds of the old geometry. */
import { describe, expect, it } from "vitest";
import { readContainer } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { unwrapModel } from "../../web/engine/unwrap/unwrap-model.ts";
import { GltfSketch } from "../support/gltf-sketch.ts";
import { documentOf, faultsOf, surfaces } from "../support/unwrapped-models.ts";

const SIDE = 24;
/** A square of many vertices, without texture coordinates. */
const places = Array.from({ length: SIDE * SIDE }, (_, i) => [
  (i % SIDE) / SIDE,
  Math.floor(i / SIDE) / SIDE,
  0,
]).flat();
const triangles = Array.from({ length: (SIDE - 1) * (SIDE - 1) }, (_, i) => {
  const at = (i % (SIDE - 1)) + SIDE * Math.floor(i / (SIDE - 1));
  return [at, at + 1, at + SIDE + 1, at, at + SIDE + 1, at + SIDE];
}).flat();

/** The square, and behind it the keys of an animation; `more` goes over the file. */
function grid(more: (model: GltfSketch, primitive: JsonObject) => JsonObject = () => ({})): Uint8Array {
  const model = new GltfSketch();
  const primitive = {
    attributes: {
      POSITION: model.places(places),
      TEXCOORD_0: model.values(Float32Array.from(places.filter((_, i) => i % 3 < 2)), 2),
    },
    indices: model.values(Uint16Array.from(triangles), 1),
    material: 0,
  };
  const input = model.values(Float32Array.of(0, 1), 1, { min: [0], max: [1] });
  const output = model.values(Float32Array.of(0, 0, 0, 1, 2, 3), 3);
  return model.glb({
    meshes: [{ primitives: [primitive] }],
    materials: [{}],
    animations: [
      { channels: [{ sampler: 0, target: { node: 0, path: "translation" } }], samplers: [{ input, output }] },
    ],
    ...more(model, primitive),
  });
}

const unwrapped = async (glb: Uint8Array): Promise<Uint8Array> =>
  (await unwrapModel({ name: "grid.glb", bytes: glb }, { materials: [0], size: 64 })).glb;

/** Bytes of geometry and keys: all of the BIN but the picture. */
function geometryBytes(glb: Uint8Array): number {
  const { json, binary } = readContainer({ name: "grid.glb", bytes: glb });
  const [image] = (json.images ?? []) as { bufferView: number }[];
  const view = ((json.bufferViews ?? []) as { byteLength: number }[])[image?.bufferView ?? -1];
  return (binary?.length ?? 0) - (view?.byteLength ?? 0);
}

const keysOf = async (glb: Uint8Array): Promise<number[][]> =>
  (await documentOf(glb))
    .getRoot()
    .listAnimations()
    .flatMap((animation) => animation.listSamplers())
    .flatMap((sampler) => [sampler.getInput(), sampler.getOutput()])
    .map((accessor) => Array.from(accessor?.getArray() ?? []));

describe("the old geometry of an unwrapped model", () => {
  it("goes where nothing refers to it any more, and what lies behind it stays whole", async () => {
    const glb = grid();
    const written = await unwrapped(glb);
    const { json } = readContainer({ name: "grid.glb", bytes: written });
    // Another set of coordinates came with it.
    expect(geometryBytes(written)).toBeLessThan(geometryBytes(glb) + 8 * SIDE * SIDE + 64);
    expect(json.accessors).toHaveLength(6);
    expect(await keysOf(written)).toEqual([
      [0, 1],
      [0, 0, 0, 1, 2, 3],
    ]);
    expect(await faultsOf(written)).toEqual([]);
    expect(surfaces(await documentOf(written))[0]).toMatchObject(surfaces(await documentOf(glb))[0] ?? {});
  });

  it("stays where another material's triangles have it, too", async () => {
    const glb = grid((_, primitive) => ({
      meshes: [{ primitives: [primitive, { ...primitive, material: 1 }] }],
      materials: [{}, {}],
    }));
    const written = await unwrapped(glb);
    expect(await faultsOf(written)).toEqual([]);
    expect(surfaces(await documentOf(written))[1]).toEqual(surfaces(await documentOf(glb))[1]);
  });

  it("stays as far as another view lies on the same bytes", async () => {
    const glb = grid((model, primitive) => {
      const { POSITION } = primitive.attributes as { POSITION: number };
      // A mesh whose vertices are some of those.
      const some = model.accessor({
        bufferView: model.viewOn(POSITION, 12 * SIDE, 12 * 3),
        componentType: 5126,
        count: 3,
        type: "VEC3",
        min: [0, 1 / SIDE, 0].map(Math.fround),
        max: [2 / SIDE, 1 / SIDE, 0].map(Math.fround),
      });
      return {
        meshes: [{ primitives: [primitive, { attributes: { POSITION: some }, mode: 0, material: 1 }] }],
        materials: [{}, {}],
      };
    });
    const written = await unwrapped(glb);
    expect(await faultsOf(written)).toEqual([]);
    expect(geometryBytes(written)).toBeLessThan(geometryBytes(glb) + 8 * SIDE * SIDE + 128);
    expect(await keysOf(written)).toEqual(await keysOf(glb));
    expect(surfaces(await documentOf(written))[1]).toEqual(surfaces(await documentOf(glb))[1]);
  });

  it("stays where an extension that is not known may refer to it", async () => {
    const glb = grid(() => ({
      extensions: { EXT_weights_of_paper: { bufferView: 0, accessor: 1 } },
      extensionsUsed: ["EXT_weights_of_paper"],
    }));
    const written = await unwrapped(glb);
    const { json, binary } = readContainer({ name: "grid.glb", bytes: written });
    const before = readContainer({ name: "grid.glb", bytes: glb });
    expect((json.accessors as JsonObject[]).slice(0, 5)).toEqual(before.json.accessors);
    expect((json.bufferViews as JsonObject[]).slice(0, 5)).toEqual(before.json.bufferViews);
    expect(binary?.subarray(0, before.binary?.length)).toEqual(before.binary);
  });
});
