import { beforeAll, describe, expect, it } from "vitest";
import { Accessors } from "../../web/engine/accessors.ts";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import { readContainer, writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { loadModelFile } from "../../web/engine/model-loader.ts";
import { compressedModels } from "../support/compressed-models.ts";
import { buildGlb, cube, cylinder, plane } from "../support/model-builder.ts";
import { solidPng } from "../support/png-file.ts";
import { haveSharedModels, noteSkipped, sharedModel } from "../support/shared-models.ts";

const PICTURE = solidPng(4, 4, [1, 2, 3, 255]);

/** Three meshes whose materials are used in another order than they are listed, one of them not at all. */
const plain = buildGlb({
  meshes: [cylinder(24, 3), cube(0), plane(3, 1)],
  materials: [{ name: "zero" }, { name: "one" }, { name: "two, unused" }, { name: "three" }].map((material) => ({
    ...material,
    pbrMetallicRoughness: { baseColorTexture: { index: 0 } },
  })),
  textures: [{ source: 0 }],
  images: [{ bytes: PICTURE, mimeType: "image/png" }],
});

let draco: Uint8Array;
let meshopt: Uint8Array;

beforeAll(async () => {
  ({ draco, meshopt } = await compressedModels(plain));
});

/** The same model with one of its JSON's members changed. */
function changed(glb: Uint8Array, change: (json: JsonObject) => void): Uint8Array {
  const { json, binary, extraChunks } = readContainer({ name: "x", bytes: glb });
  const copy = structuredClone(json);
  change(copy);
  return writeGlb(copy, binary, extraChunks);
}

interface CompressedView {
  byteLength: number;
  readonly buffer: number;
  readonly extensions: { readonly EXT_meshopt_compression: JsonObject };
}

function compressedView(json: JsonObject): CompressedView {
  const views = json.bufferViews as unknown as CompressedView[];
  const view = views.find(({ extensions }) => extensions?.EXT_meshopt_compression !== undefined);
  if (view === undefined) throw new Error("the model is not compressed");
  return view;
}

interface DenseGltf {
  readonly meshes: readonly [{ readonly primitives: readonly [unknown, unknown, Primitive] }];
  readonly accessors: readonly JsonObject[];
}

interface Primitive {
  readonly attributes: { readonly TEXCOORD_0: number };
  readonly indices: number;
}

/** The model whose third part has UVs and indices of its own: zeros but for one each, which only `sparse` tells. */
function withSparseParts(glb: Uint8Array): Uint8Array {
  const { json, binary } = readContainer({ name: "x", bytes: glb });
  const copy = structuredClone(json) as unknown as {
    buffers: { byteLength: number }[];
    bufferViews: object[];
    accessors: { count: number }[];
    meshes: { primitives: { attributes: Record<string, number>; indices: number }[] }[];
  };
  const plain = binary ?? new Uint8Array();
  const start = Math.ceil(plain.length / 4) * 4;
  // UV 0 is (1/4, 3/4); index 1 is vertex 2.
  const parts = new Uint8Array([0, 0, 0, 0, 0x00, 0x40, 0x00, 0xc0, 1, 0, 0, 0, 2, 0, 0, 0]);
  const extended = new Uint8Array(start + parts.length);
  extended.set(plain);
  extended.set(parts, start);
  const view = (at: number, byteLength: number): number =>
    copy.bufferViews.push({ buffer: 0, byteOffset: start + at, byteLength }) - 1;
  const sparse = (type: string, count: number, at: number): number =>
    copy.accessors.push({
      componentType: 5123,
      type,
      count,
      normalized: type === "VEC2",
      sparse: {
        count: 1,
        indices: { bufferView: view(at, 1), componentType: 5121 },
        values: { bufferView: view(at + 4, type === "VEC2" ? 4 : 2) },
      },
    } as { count: number }) - 1;
  const primitive = copy.meshes[0]?.primitives[2];
  if (primitive === undefined) throw new Error("the model has no third part");
  const vertices = copy.accessors[primitive.attributes.POSITION ?? 0]?.count ?? 0;
  primitive.attributes.TEXCOORD_0 = sparse("VEC2", vertices, 0);
  primitive.indices = sparse("SCALAR", 3, 8);
  const buffer = copy.buffers[0];
  if (buffer !== undefined) buffer.byteLength = extended.length;
  return writeGlb(copy as unknown as JsonObject, extended);
}

describe("a compressed model", () => {
  it.each([
    ["Draco", () => draco],
    ["meshopt", () => meshopt],
  ])("by %s keeps its materials' order, and bakes as the plain one does", async (_, compressed) => {
    const { json } = readContainer({ name: "x", bytes: compressed() });
    expect(JSON.stringify(json.extensionsRequired)).toMatch(/compression/);
    for (const material of [0, 1, 3]) {
      const expected = await bakeOf({ name: "plain.glb", bytes: plain }, material, 64);
      const found = await bakeOf({ name: "compressed.glb", bytes: compressed() }, material, 64);
      expect(found.names).toEqual(["zero", "one", "two, unused", "three"]);
      expectAlike(found, expected, 3, 0.5);
    }
  });

  it("is refused where it counts more than a file could hold, before any of it is made", async () => {
    const { json, binary } = readContainer({ name: "m.glb", bytes: meshopt });
    const accessors = json.accessors as object[];
    accessors.push({ componentType: 5126, count: 2 ** 27, type: "VEC4" });
    await expect(
      loadModelFile({ name: "zeros.glb", bytes: writeGlb(json, binary ?? new Uint8Array()) }),
    ).rejects.toMatchObject({
      code: "out-of-budget",
      subject: "zeros.glb",
      field: `accessors[${accessors.length - 1}].count`,
      value: String(2 ** 27),
    });
  });

  it("is handed on without its compression, with its pictures as they were", async () => {
    for (const bytes of [draco, meshopt]) {
      const { glb, packed } = await loadModelFile({ name: "m.glb", bytes });
      const { json, binary } = readContainer({ name: "out", bytes: glb });
      expect(JSON.stringify(json)).not.toMatch(/compression/);
      expect(json.buffers).toHaveLength(1);
      expect(Buffer.from(binary ?? []).includes(Buffer.from(PICTURE))).toBe(true);
      expect(JSON.stringify(packed.json)).toMatch(/compression/);
    }
  });

  it("has a scene without nodes as the file has it: an empty list of them is no glTF", async () => {
    for (const model of [draco, meshopt]) {
      const bytes = changed(model, (json) => {
        json.scenes = [...(json.scenes as JsonObject[]), { name: "empty" }];
      });
      const { json } = readContainer({ name: "x", bytes: (await loadModelFile({ name: "m.glb", bytes })).glb });
      expect(json.scenes).toEqual([{ nodes: [0] }, { name: "empty" }]);
    }
  });

  it("is written back still compressed", async () => {
    const engine = createEngineHost();
    for (const [bytes, name] of [
      [draco, "KHR_draco_mesh_compression"],
      [meshopt, "EXT_meshopt_compression"],
    ] as const) {
      await engine.loadModel({ name: "m.glb", bytes });
      await engine.openTarget({ material: 3, width: 32 });
      const { json } = readContainer({ name: "out", bytes: await engine.exportGlb() });
      expect(json.extensionsRequired).toEqual([name]);
      expect(json.meshes).toEqual(readContainer({ name: "in", bytes }).json.meshes);
    }
    engine.dispose();
  });

  it("by KHR_meshopt_compression is read as by its older name", async () => {
    const renamed = changed(meshopt, (json) => {
      const text = JSON.stringify(json).replaceAll("EXT_meshopt_compression", "KHR_meshopt_compression");
      Object.assign(json, JSON.parse(text));
    });
    const { glb } = await loadModelFile({ name: "m.glb", bytes: renamed });
    expect(glb).toEqual((await loadModelFile({ name: "m.glb", bytes: meshopt })).glb);
  });

  it("keeps what is sparse: fractions as integers, and indices that no view holds", async () => {
    const bytes = withSparseParts(meshopt);
    const { json, binary } = readContainer({ name: "x", bytes: (await loadModelFile({ name: "m.glb", bytes })).glb });
    const gltf = json as unknown as DenseGltf;
    const { attributes, indices } = gltf.meshes[0].primitives[2];
    const accessors = new Accessors(structuredClone(json), binary, "x");
    const uvs = new Uint16Array(accessors.read(attributes.TEXCOORD_0).bytes.buffer);
    expect([...uvs]).toEqual([0x4000, 0xc000, 0, 0, 0, 0, 0, 0]);
    expect([...accessors.readNumbers(indices)]).toEqual([0, 2, 0]);
    expect(gltf.accessors[indices]).toMatchObject({ count: 3, componentType: 5123 });
  });

  it("is as plain ones are where it requires an extension: read with one of looks, refused by the name of another", async () => {
    for (const model of [plain, draco, meshopt]) {
      const requiring = (extension: string): Uint8Array =>
        changed(model, (json) => {
          for (const key of ["extensionsUsed", "extensionsRequired"]) {
            json[key] = [...((json[key] as string[] | undefined) ?? []), extension];
          }
        });
      const engine = createEngineHost();
      await expect(engine.loadModel({ name: "m.glb", bytes: requiring("KHR_materials_glow") })).resolves.toMatchObject({
        materials: { length: 4 },
      });
      const attempt = engine.loadModel({ name: "m.glb", bytes: requiring("ACME_curves") });
      await expect(attempt).rejects.toMatchObject({
        ...{ code: "unsupported-model", subject: "m.glb", value: "ACME_curves" },
        field: model === plain ? "extensionsRequired[0]" : "extensionsRequired[1]",
      });
      await expect(attempt).rejects.toThrow(/requires the extension ACME_curves/);
      engine.dispose();
    }
  });

  it("is as plain ones are where it is of a later glTF: read, or refused by the version that it asks for", async () => {
    for (const model of [plain, draco, meshopt]) {
      const engine = createEngineHost();
      const of = (asset: JsonObject): Promise<unknown> =>
        engine.loadModel({ name: "m.glb", bytes: changed(model, (json) => (json.asset = asset)) });
      await expect(of({ version: "2.1" })).resolves.toMatchObject({ materials: { length: 4 } });
      await expect(of({ version: "2.1", minVersion: "2.1" })).rejects.toThrow(/asset\.minVersion is "2\.1"/);
      engine.dispose();
    }
  });

  it("by Draco has the triangles of a strip as they are unpacked: one by one", async () => {
    const strip = changed(draco, (json) => {
      for (const primitive of (json.meshes as unknown as [{ primitives: JsonObject[] }])[0].primitives) {
        primitive.mode = 5;
      }
    });
    const engine = createEngineHost();
    const { triangles } = await engine.loadModel({ name: "list.glb", bytes: draco });
    await expect(engine.loadModel({ name: "strip.glb", bytes: strip })).resolves.toMatchObject({ triangles });
    engine.dispose();
  });

  it("may have a texture without a picture, which says no more than the material's coordinates", async () => {
    const [expected, ...found] = await Promise.all(
      [plain, draco, meshopt].map(async (model) => {
        const bytes = changed(model, (json) => {
          delete (json.textures as [JsonObject])[0].source;
          for (const material of json.materials as JsonObject[]) material.normalTexture = { index: 0 };
        });
        const engine = createEngineHost();
        const { materials } = await engine.loadModel({ name: "bare.glb", bytes });
        engine.dispose();
        return materials.map(({ refusal, textureSize, texCoord }) => ({ refusal, textureSize, texCoord }));
      }),
    );
    expect(expected?.[0]).toEqual({ refusal: null, textureSize: null, texCoord: 0 });
    expect(found).toEqual([expected, expected]);
  });

  it("is refused with a typed error when its data is damaged", async () => {
    for (const bytes of [draco, meshopt]) {
      const start = 28 + new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
      const damaged = bytes.map((byte, i) => (i > start && i % 3 === 0 ? byte ^ 0x5a : byte));
      const attempt = loadModelFile({ name: "broken.glb", bytes: damaged });
      await expect(attempt).rejects.toMatchObject({ code: "bad-model", subject: "broken.glb" });
      await expect(attempt).rejects.toThrow(/compressed geometry of “broken\.glb”/);
    }
  });

  it("is told what is wrong with an accessor that reaches beyond its bytes, and not that it cannot be unpacked", async () => {
    for (const model of [draco, meshopt]) {
      const bytes = changed(model, (json) => {
        // A part that is not packed as the rest is.
        const [views, accessors] = [json.bufferViews, json.accessors] as [JsonObject[], JsonObject[]];
        views.push({ buffer: 0, byteOffset: 0, byteLength: 16 });
        accessors.push({ bufferView: views.length - 1, componentType: 5126, type: "VEC3", count: 1_000_000 });
        const [mesh] = json.meshes as unknown as [{ primitives: JsonObject[] }];
        mesh.primitives.push({ attributes: { POSITION: accessors.length - 1 } });
      });
      await expect(loadModelFile({ name: "beyond.glb", bytes })).rejects.toMatchObject({
        code: "bad-container",
        subject: "beyond.glb",
        field: expect.stringMatching(/^accessors\[\d+\]\.count$/),
        message: expect.stringMatching(/reaches to byte 12000000 of “bufferViews\[\d+\]”, which has 16/),
      });
    }
  });

  it("is refused where a part's numbers end early, and not read without them", async () => {
    for (const left of [4, -(2 ** 20)]) {
      const bytes = changed(meshopt, (json) => {
        const [{ primitives }] = json.meshes as unknown as [{ primitives: [{ indices: number }] }];
        const accessor = (json.accessors as JsonObject[])[primitives[0].indices] as JsonObject;
        const view = (json.bufferViews as JsonObject[])[accessor.bufferView as number] as JsonObject;
        accessor.byteOffset = (view.byteLength as number) - left;
      });
      await expect(loadModelFile({ name: "short.glb", bytes })).rejects.toMatchObject({
        code: "bad-container",
        subject: "short.glb",
        field: expect.stringMatching(/^accessors\[\d+\]\.count$/),
      });
    }
  });

  it("is refused for a type of numbers that only JavaScript's objects have", async () => {
    for (const model of [draco, meshopt]) {
      for (const type of ["__proto__", "constructor"]) {
        const bytes = changed(model, (json) => {
          for (const accessor of json.accessors as JsonObject[]) accessor.type = type;
        });
        await expect(loadModelFile({ name: "m.glb", bytes })).rejects.toMatchObject({
          code: "bad-container",
          field: "accessors[0].type",
          value: type,
        });
      }
    }
  });

  it("stands where the plain one does, bit by bit, also by a matrix that is no move, turn and size", async () => {
    const askew = [1, 0.3, 0, 0, 0.5, -1, 0, 0, 0, 0.2, 1, 0, 5, 6, 7, 1];
    const [expected, ...found] = await Promise.all(
      [plain, draco, meshopt].map(async (model) => {
        const bytes = changed(model, (json) => {
          const [node] = json.nodes as [JsonObject];
          for (const key of ["translation", "rotation", "scale"]) delete node[key];
          node.matrix = askew;
        });
        const { json } = readContainer({ name: "x", bytes: (await loadModelFile({ name: "m.glb", bytes })).glb });
        const [{ matrix, translation, rotation, scale }] = json.nodes as [JsonObject];
        return { matrix, translation, rotation, scale };
      }),
    );
    expect(expected).toEqual({ matrix: askew });
    expect(found).toEqual([expected, expected]);
  });

  it.each<[string, (place: JsonObject) => void, string]>([
    ["a count that does not fit its view", (place) => (place.count = 7), "bad-container"],
    ["a stride of zero", (place) => (place.byteStride = 0), "bad-container"],
    ["a count that is no number", (place) => (place.count = "many"), "bad-container"],
    ["a filter that nobody knows", (place) => (place.filter = "SMOOTH"), "bad-container"],
    ["a filter for elements of another length", (place) => (place.filter = "QUATERNION"), "bad-container"],
    ["a mode that nobody knows", (place) => (place.mode = "QUADS"), "bad-container"],
  ])("is refused for %s before anything is unpacked", async (_, change, code) => {
    const bytes = changed(meshopt, (json) => {
      change(compressedView(json).extensions.EXT_meshopt_compression);
    });
    await expect(loadModelFile({ name: "m.glb", bytes })).rejects.toMatchObject({ code });
  });

  it("is refused when it would unpack to gigabytes", async () => {
    const bytes = changed(meshopt, (json) => {
      const view = compressedView(json);
      view.byteLength = 2 ** 31;
      Object.assign(view.extensions.EXT_meshopt_compression, { count: 2 ** 29, byteStride: 4 });
      (json.buffers as JsonObject[])[view.buffer] = {
        byteLength: 2 ** 31,
        extensions: { EXT_meshopt_compression: { fallback: true } },
      };
    });
    await expect(loadModelFile({ name: "m.glb", bytes })).rejects.toMatchObject({ code: "out-of-budget" });
  });
});

noteSkipped("Avocado's three encodings bake alike");
describe.runIf(haveSharedModels)("Avocado", () => {
  // Their exporter rounded positions, normals (Draco: to 8 bits) and texture coordinates, which shift texels over the
  // surface: half of all texels lie within 8 and 2 steps, these bounds hold for the worst.
  it.each([
    ["AvocadoDraco/Avocado.gltf", 32, 6.5],
    ["AvocadoQuantized/Avocado.gltf", 9, 1.5],
  ])("bakes in %s as it does plain", async (path, steps, degrees) => {
    const expected = await bakeOf(sharedModel("Avocado/Avocado.gltf"), 0, 512);
    expectAlike(await bakeOf(sharedModel(path), 0, 512), expected, steps, degrees);
  });
});

interface Bake {
  readonly names: readonly string[];
  readonly diagonal: number;
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly coverage: Uint8Array;
}

async function bakeOf(source: Parameters<typeof loadModelFile>[0], material: number, size: number): Promise<Bake> {
  const engine = createEngineHost();
  try {
    const { materials, boundsMin, boundsMax } = await engine.loadModel(source);
    await engine.openTarget({ material, width: size, height: size, base: [1, 1, 1, 1] });
    return {
      names: materials.map(({ name }) => name),
      diagonal: Math.hypot(...boundsMax.map((max, axis) => max - (boundsMin[axis] ?? 0))),
      positions: await engine.readMapRows(material, "positions", 0, size),
      normals: await engine.readMapRows(material, "normals", 0, size),
      coverage: await engine.readMapRows(material, "coverage", 0, size),
    };
  } finally {
    engine.dispose();
  }
}

/** Positions within `steps` times the accuracy of a bake (2^-15 of the diagonal), for texels that both cover. */
function expectAlike(found: Bake, expected: Bake, steps: number, degrees: number): void {
  let both = 0;
  let either = 0;
  let farthest = 0;
  let leastCosine = 1;
  for (let texel = 0; texel < expected.coverage.length; texel++) {
    const a = expected.coverage[texel] === 1;
    const b = found.coverage[texel] === 1;
    if (a || b) either++;
    if (!a || !b) continue;
    both++;
    let cosine = 0;
    for (let i = texel * 3; i < texel * 3 + 3; i++) {
      farthest = Math.max(farthest, Math.abs((found.positions[i] ?? 0) - (expected.positions[i] ?? 0)));
      cosine += (found.normals[i] ?? 0) * (expected.normals[i] ?? 0);
    }
    leastCosine = Math.min(leastCosine, cosine);
  }
  expect(both / either).toBeGreaterThan(0.995);
  expect(farthest).toBeLessThan(expected.diagonal * steps * 2 ** -15);
  expect(leastCosine).toBeGreaterThan(Math.cos((degrees * Math.PI) / 180));
}
