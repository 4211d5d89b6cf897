/** What of a compressed model stays as it is in the file, and what its geometry is given in its stead. */
import { beforeAll, describe, expect, it } from "vitest";
import { Accessors } from "../../web/engine/accessors.ts";
import { readContainer, writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { loadModelFile } from "../../web/engine/model-loader.ts";
import { unwrapModel } from "../../web/engine/unwrap/unwrap-model.ts";
import { compressedModels } from "../support/compressed-models.ts";
import { buildGlb, cube, plane } from "../support/model-builder.ts";
import { solidPng } from "../support/png-file.ts";
import { faultsOf } from "../support/unwrapped-models.ts";

const COMPRESSIONS = ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];

const plain = buildGlb({
  meshes: [cube(0), plane(3, 0)],
  materials: [{ name: "skin", pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
  textures: [{ source: 0 }],
  images: [{ bytes: solidPng(4, 4, [1, 2, 3, 255]), mimeType: "image/png" }],
});

/** Members that @gltf-transform has no class for, wherever a file may have them. */
function putOddMembers(json: JsonObject): void {
  const first = (key: string): JsonObject => (json[key] as [JsonObject])[0];
  json.extensionsUsed = [...((json.extensionsUsed as string[] | undefined) ?? []), "VRM", "ACME_parts"];
  json.extensions = { VRM: { humanoid: { humanBones: [{ bone: "head", node: 0 }] }, firstPerson: { mesh: 0 } } };
  json.ACME_top = { accessor: 1, list: [1, { two: 2 }] };
  json.extras = { about: "the file" };
  (json.asset as JsonObject).extras = { by: "a person" };
  Object.assign(first("scenes"), { extras: { sky: true }, extensions: { ACME_parts: { sun: 0 } } });
  Object.assign(first("nodes"), { name: "", extensions: { ACME_parts: { id: 9 } } });
  Object.assign(first("materials"), { extensions: { ACME_parts: { worn: 0.25 } } });
  Object.assign(first("images"), { extras: { drawnBy: "hand" } });
  Object.assign(first("textures"), { extensions: { ACME_parts: { image: 0 } }, ACME_odd: null });
  Object.assign(first("accessors"), { name: "places", extras: [1, 2], extensions: { ACME_parts: { unit: "m" } } });
  Object.assign(first("bufferViews"), { name: "a view", extras: { kept: 1 } });
  Object.assign(first("buffers"), { name: "all bytes" });
  const mesh = first("meshes") as unknown as { primitives: [JsonObject, JsonObject]; extras: JsonObject };
  mesh.extras = { targetNames: ["smile"] };
  const [primitive] = mesh.primitives;
  primitive.extras = { part: "face" };
  primitive.extensions = { ...(primitive.extensions as JsonObject), ACME_parts: { seam: [1, 2] } };
}

const compressed: Record<string, Uint8Array> = {};

beforeAll(async () => {
  for (const [form, bytes] of Object.entries(await compressedModels(plain))) {
    const { json, binary } = readContainer({ name: "x", bytes });
    const copy = structuredClone(json);
    putOddMembers(copy);
    compressed[form] = writeGlb(copy, binary);
  }
});

/** Without what compression says, and what says where bytes lie; lists as long as in `of`, which has no more than the file. */
function withoutCompression(json: JsonObject, of: JsonObject): JsonObject {
  const copy = structuredClone(json);
  copy.bufferViews = (copy.bufferViews as JsonObject[]).slice(0, (of.bufferViews as JsonObject[]).length);
  copy.buffers = (copy.buffers as JsonObject[]).slice(0, 1);
  const visit = (value: unknown): void => {
    if (typeof value !== "object" || value === null) return;
    const holder = value as JsonObject;
    const extensions = holder.extensions as JsonObject | undefined;
    for (const key of COMPRESSIONS) delete extensions?.[key];
    if (extensions !== undefined && Object.keys(extensions).length === 0) delete holder.extensions;
    Object.values(holder).forEach(visit);
  };
  visit(copy);
  for (const view of copy.bufferViews as JsonObject[]) {
    for (const key of ["buffer", "byteOffset", "byteLength", "target"]) delete view[key];
  }
  for (const buffer of copy.buffers as JsonObject[]) delete buffer.byteLength;
  for (const accessor of copy.accessors as JsonObject[]) {
    for (const key of ["bufferView", "byteOffset", "min", "max"]) delete accessor[key];
  }
  for (const key of ["extensionsUsed", "extensionsRequired"]) {
    const rest = ((copy[key] as string[] | undefined) ?? []).filter((name) => !COMPRESSIONS.includes(name));
    if (rest.length > 0) copy[key] = rest;
    else delete copy[key];
  }
  return copy;
}

const jsonOf = (bytes: Uint8Array): JsonObject => readContainer({ name: "x", bytes }).json;
const decoded = async (bytes: Uint8Array): Promise<Uint8Array> =>
  (await loadModelFile({ name: "packed.glb", bytes })).glb;

describe("a compressed model that is decoded", () => {
  it.each(["draco", "meshopt"])("by %s keeps every member of its JSON that is not about compression", async (form) => {
    const before = jsonOf(compressed[form] as Uint8Array);
    const after = jsonOf(await decoded(compressed[form] as Uint8Array));
    expect(withoutCompression(after, before)).toEqual(withoutCompression(before, before));
    expect(JSON.stringify(after)).not.toMatch(/compression/);
    expect(after.buffers).toHaveLength(1);
  });

  it.each(["draco", "meshopt"])("by %s is sound glTF, and holds its compressed bytes no more", async (form) => {
    const glb = await decoded(compressed[form] as Uint8Array);
    expect(await faultsOf(glb)).toEqual(await faultsOf(withOdd(plain)));
    // Draco makes vertices anew; nothing but them may be more than in the model as it was before.
    expect(glb.length).toBeLessThan(withOdd(plain).length + 1200);
  });

  it.each(["draco", "meshopt"])("by %s has what it had of unknown extensions when it is unwrapped", async (form) => {
    const source = { name: "packed.glb", bytes: compressed[form] as Uint8Array };
    const { json } = readContainer({ name: "x", bytes: (await unwrapModel(source, { materials: [0], size: 64 })).glb });
    expect(json).toMatchObject({
      ...{ extensionsUsed: ["VRM", "ACME_parts"], extras: { about: "the file" } },
      extensions: jsonOf(source.bytes).extensions,
      ACME_top: { accessor: 1, list: [1, { two: 2 }] },
      nodes: [{ extensions: { ACME_parts: { id: 9 } } }],
      meshes: [{ extras: { targetNames: ["smile"] }, primitives: [{ extras: { part: "face" } }, {}] }],
    });
  });

  it("says the least and the greatest that its numbers have, where its file says others", async () => {
    const { json, binary } = readContainer({ name: "x", bytes: compressed.draco as Uint8Array });
    const copy = structuredClone(json);
    for (const accessor of copy.accessors as JsonObject[]) {
      if (accessor.min !== undefined) Object.assign(accessor, { min: [-9, -9, -9], max: [-9, 9, 9] });
    }
    const glb = await decoded(writeGlb(copy, binary));
    expect((await faultsOf(glb)).filter((fault) => /M(IN|AX)_MISMATCH/.test(fault))).toEqual([]);
  });

  it("has its indices in the kind of numbers that its file says, and wider ones where they do not fit", async () => {
    for (const [componentType, expected] of [
      [5121, 5121],
      [5125, 5125],
    ]) {
      const { json, binary } = readContainer({ name: "x", bytes: compressed.draco as Uint8Array });
      const copy = structuredClone(json);
      const [{ primitives }] = copy.meshes as unknown as [{ primitives: [{ indices: number }] }];
      const index = primitives[0].indices;
      Object.assign((copy.accessors as JsonObject[])[index] as JsonObject, { componentType });
      const out = readContainer({ name: "x", bytes: await decoded(writeGlb(copy, binary)) });
      expect(((out.json.accessors as JsonObject[])[index] as JsonObject).componentType).toBe(expected);
      const numbers = new Accessors(structuredClone(out.json), out.binary, "x").readNumbers(index);
      expect([numbers.length, Math.max(...numbers)]).toEqual([36, 23]);
    }
  });

  it("by Draco has each part's own numbers, where its file names the same accessors for several of them", async () => {
    const { json, binary } = readContainer({ name: "x", bytes: compressed.draco as Uint8Array });
    const copy = structuredClone(json);
    const [{ primitives }] = copy.meshes as unknown as [{ primitives: [Primitive, Primitive] }];
    const own = await Promise.all([0, 1].map((part) => placesOf(writeGlb(json, binary), part)));
    // As Adobe Dimension writes them: what Draco holds, loaders find without the accessors.
    Object.assign(primitives[1], { attributes: primitives[0].attributes, indices: primitives[0].indices });
    const bytes = writeGlb(copy, binary);
    expect(await Promise.all([0, 1].map((part) => placesOf(bytes, part)))).toEqual(own);
    expect(own.map(({ length }) => length)).toEqual([72, 12]);
  });

  it("has no more than its file where nothing in it is compressed", async () => {
    const json = {
      asset: { version: "2.0" },
      extensionsUsed: ["KHR_draco_mesh_compression"],
      scenes: [{ name: "bare" }],
    };
    expect(jsonOf(await decoded(writeGlb(json, null)))).toEqual({ asset: json.asset, scenes: json.scenes });
  });

  it("is refused by the buffer view that has no bytes, where only compressed ones may have none", async () => {
    const { json, binary } = readContainer({ name: "x", bytes: compressed.meshopt as Uint8Array });
    const copy = structuredClone(json);
    const views = copy.bufferViews as JsonObject[];
    const packed = views.findIndex((view) => JSON.stringify(view).includes("meshopt"));
    delete (views[packed] as JsonObject).extensions;
    await expect(decoded(writeGlb(copy, binary))).rejects.toMatchObject({
      ...{ code: "bad-container", subject: "packed.glb", field: `bufferViews[${packed}].buffer`, value: "1" },
    });
  });
});

interface Primitive {
  readonly attributes: { readonly POSITION: number };
  readonly indices: number;
}

/** Of the vertices of one of a model's parts. */
async function placesOf(bytes: Uint8Array, part: number): Promise<number[]> {
  const { json, binary } = readContainer({ name: "x", bytes: await decoded(bytes) });
  const [{ primitives }] = json.meshes as unknown as [{ primitives: Primitive[] }];
  const reader = new Accessors(structuredClone(json), binary, "x");
  return [...reader.readNumbers((primitives[part] as Primitive).attributes.POSITION)];
}

function withOdd(glb: Uint8Array): Uint8Array {
  const { json, binary } = readContainer({ name: "x", bytes: glb });
  const copy = structuredClone(json);
  putOddMembers(copy);
  return writeGlb(copy, binary);
}
