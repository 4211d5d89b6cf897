/** Forms that geometry has in files: whatever the form, an unwrapped model has the same surface, the same look and no shared texel. */
import type { Document, Material } from "@gltf-transform/core";
import type { MappingList } from "@gltf-transform/extensions";
import { describe, expect, it } from "vitest";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { encodePng } from "../../web/engine/png-encoder.ts";
import { unwrapModel } from "../../web/engine/unwrap/unwrap-model.ts";
import { boundsOf, GltfSketch } from "../support/gltf-sketch.ts";
import { buildGlb, cube, sphere } from "../support/model-builder.ts";
import {
  corners,
  documentOf,
  faultsOf,
  lookDifference,
  overlapOf,
  primitivesOf,
  surfaces,
} from "../support/unwrapped-models.ts";

const SIZE = 256;
const PICTURE = 16;

/** A strip of paper, folded in the middle, whose halves lie on the same part of the texture. */
const FOLDED = {
  positions: [0, 0, 0, 0, 1, 0, 1, 0, 0.5, 1, 1, 0.5, 2, 0, 0, 2, 1, 0],
  normals: [-0.6, 0, 0.8, -0.6, 0, 0.8, 0, 0, 1, 0, 0, 1, 0.6, 0, 0.8, 0.6, 0, 0.8],
  uvs: [0.1, 0.9, 0.1, 0.1, 0.9, 0.9, 0.9, 0.1, 0.1, 0.9, 0.1, 0.1],
  /** Of single triangles. */
  indices: [0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5],
};
const { positions, normals, uvs, indices } = FOLDED;
const VERTICES = positions.length / 3;

const floats = (values: readonly number[]): Float32Array => Float32Array.from(values);

/** What each sketch begins with. */
function sketch() {
  const model = new GltfSketch();
  const attributes = (): JsonObject => ({
    POSITION: model.places(positions),
    NORMAL: model.values(floats(normals), 3),
    TEXCOORD_0: model.values(floats(uvs), 2),
  });
  const listed = (): number => model.values(Uint16Array.from(indices), 1);
  return { model, attributes, listed };
}

/** The file, with one material and its picture. `more` goes over the rest. */
async function painted(
  model: GltfSketch,
  primitives: readonly JsonObject[],
  more: JsonObject = {},
): Promise<Uint8Array> {
  const rgba = Uint8Array.from({ length: PICTURE * PICTURE * 4 }, (_, i) =>
    i % 4 === 3 ? 255 : (((i >> 2) % PICTURE) * 29 + i * 7) % 251,
  );
  const png = await encodePng({ width: PICTURE, height: PICTURE, rgba });
  return model.glb({
    meshes: [{ primitives: primitives.map((primitive) => ({ material: 0, ...primitive })) }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } }, doubleSided: true }],
    textures: [{ source: 0 }],
    images: [{ bufferView: model.view(png), mimeType: "image/png" }],
    ...more,
  });
}

/** Unwraps it and checks what holds for every model. Returns the file as it is read afterwards. */
async function unwrapped(glb: Uint8Array) {
  expect(await faultsOf(glb), "the model itself").toEqual([]);
  const before = await overlapOf(glb, SIZE);
  const { glb: written, materials } = await unwrapModel(
    { name: "form.glb", bytes: glb },
    { materials: [0], size: SIZE },
  );
  const after = await overlapOf(written, SIZE);
  const [old, document] = [await documentOf(glb), await documentOf(written)];
  expect(after.overlapping, "shared texels").toBe(0);
  expect(after.covered / SIZE ** 2).toBeGreaterThan(0.2);
  expect(await faultsOf(written)).toEqual([]);
  const { triangles, boundsMin, boundsMax } = before.info ?? {};
  expect(after.info, "as the core poses it").toMatchObject({ triangles, boundsMin, boundsMax });
  expect(materials[0]?.triangles).toBe(triangles);
  for (const [i, surface] of surfaces(old).entries()) expect(surfaces(document)[i]).toMatchObject(surface);
  expect(await lookDifference(glb, written)).toBeLessThan(2);
  return { old, document };
}

/** Which way round the triangles go on the new texture, v being down: -1 for the way in which they are listed. */
function turns(document: Document): Set<number> {
  const [primitive] = primitivesOf(document);
  const uvs = primitive ? corners(primitive, "TEXCOORD_1") : [];
  const at = (corner: number, axis: number): number => uvs[corner]?.[axis] ?? 0;
  const area = (_: unknown, i: number): number => {
    const along = (corner: number, axis: number): number => at(3 * i + corner, axis) - at(3 * i, axis);
    return along(1, 0) * along(2, 1) - along(2, 0) * along(1, 1);
  };
  return new Set(Array.from({ length: uvs.length / 3 }, area).map(Math.sign));
}

describe("a model that is unwrapped keeps its surface and its look", () => {
  it("where it has morph targets, one of them sparse, and their weights", async () => {
    const { model, attributes, listed } = sketch();
    const lifted = positions.map((_, i) => (i % 3 === 1 ? 0.25 : i / 100));
    const targets = [
      { POSITION: model.places(lifted), NORMAL: model.values(floats(normals.map((value) => value / -4)), 3) },
      {
        POSITION: model.accessor({
          ...{ componentType: 5126, count: VERTICES, type: "VEC3", min: [0, 0, 0], max: [0.5, 0.5, 0.5] },
          sparse: model.sparse([2, 3], floats([0, 0, 0.5, 0.5, 0.5, 0])),
        }),
      },
      {
        POSITION: model.accessor({
          componentType: 5126,
          count: VERTICES,
          type: "VEC3",
          min: [0, 0, 0],
          max: [0, 0, 0],
        }),
      },
    ];
    const primitive = { attributes: attributes(), indices: listed(), targets };
    const meshes = [{ primitives: [{ material: 0, ...primitive }], weights: [0.5, 0.25, 1] }];
    const nodes = [{ mesh: 0, weights: [0.25, 0.75, 0] }];
    const { document } = await unwrapped(await painted(model, [primitive], { meshes, nodes }));
    const [mesh] = document.getRoot().listMeshes();
    expect(mesh?.getWeights()).toEqual([0.5, 0.25, 1]);
    expect(document.getRoot().listNodes()[0]?.getWeights()).toEqual([0.25, 0.75, 0]);
    expect(primitivesOf(document)[0]?.listTargets()).toHaveLength(3);
  });

  it("where its places and coordinates are sparse, over others and over nothing", async () => {
    const { model, listed } = sketch();
    const moved = positions.map((value, i) => (i < 6 ? value - 1 : value));
    const primitive = {
      attributes: {
        POSITION: model.places(positions, {
          ...boundsOf(moved),
          sparse: model.sparse([0, 1], floats(moved.slice(0, 6))),
        }),
        TEXCOORD_0: model.accessor({
          ...{ componentType: 5126, count: VERTICES, type: "VEC2" },
          sparse: model.sparse([0, 1, 2, 3, 5], floats([...uvs.slice(0, 8), ...uvs.slice(10)])),
        }),
      },
      indices: listed(),
    };
    await unwrapped(await painted(model, [primitive]));
  });

  it("where its triangles come as strips, with indices and without, and as a fan", async () => {
    const { model, attributes } = sketch();
    const order = Array.from({ length: VERTICES }, (_, i) => i);
    const fan = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1.2, 0, -1, 1, 0].map((value, i) => (i % 3 === 2 ? 2 : value));
    const flat = fan.flatMap((value, i) => (i % 3 === 2 ? [] : [0.5 + value / 4]));
    await unwrapped(
      await painted(model, [
        { attributes: attributes(), mode: 5, indices: model.values(Uint16Array.from([1, 0, 3, 2, 5, 4]), 1) },
        {
          attributes: {
            POSITION: model.places(positions.map((value, i) => (i % 3 === 1 ? value + 3 : value))),
            TEXCOORD_0: model.values(floats(uvs), 2),
          },
          mode: 5,
        },
        {
          attributes: { POSITION: model.places(fan), TEXCOORD_0: model.values(floats(flat), 2) },
          mode: 6,
          indices: model.values(Uint16Array.from(order.slice(0, 5)), 1),
        },
      ]),
    );
  });

  it("where all attributes of a vertex lie together, in one buffer view", async () => {
    const { model, listed } = sketch();
    const stride = 40;
    const bytes = new Uint8Array(VERTICES * stride);
    const view = new DataView(bytes.buffer);
    for (let i = 0; i < VERTICES; i++) {
      const row = [
        ...positions.slice(3 * i, 3 * i + 3),
        ...normals.slice(3 * i, 3 * i + 3),
        ...uvs.slice(2 * i, 2 * i + 2),
      ];
      for (const [k, value] of row.entries()) view.setFloat32(i * stride + 4 * k, value, true);
      // A colour in bytes, and two bytes of the exporter's own.
      bytes.set([40 * i, 255 - 40 * i, 128, 255, i, 2 * i], i * stride + 32);
    }
    const bufferView = model.view(bytes, { byteStride: stride });
    const at = (byteOffset: number, type: string, more: JsonObject = {}): number =>
      model.accessor({ bufferView, byteOffset, componentType: 5126, count: VERTICES, type, ...more });
    const attributes = {
      POSITION: at(0, "VEC3", boundsOf(positions)),
      NORMAL: at(12, "VEC3"),
      TEXCOORD_0: at(24, "VEC2"),
      COLOR_0: at(32, "VEC4", { componentType: 5121, normalized: true }),
      _OWN: at(36, "VEC2", { componentType: 5121 }),
    };
    await unwrapped(await painted(model, [{ attributes, indices: listed() }]));
  });

  it("where its indices are bytes, words or double words, or where there are none", async () => {
    for (const list of [Uint8Array.from(indices), Uint16Array.from(indices), Uint32Array.from(indices)]) {
      const { model, attributes } = sketch();
      await unwrapped(await painted(model, [{ attributes: attributes(), indices: model.values(list, 1) }]));
    }
    const { model } = sketch();
    const each = (values: readonly number[], width: number): number[] =>
      indices.flatMap((vertex) => values.slice(width * vertex, width * (vertex + 1)));
    const attributes = {
      POSITION: model.places(each(positions, 3)),
      NORMAL: model.values(floats(each(normals, 3)), 3),
      TEXCOORD_0: model.values(floats(each(uvs, 2)), 2),
    };
    await unwrapped(await painted(model, [{ attributes }]));
  });

  it("where five joints and more move a vertex, by two sets of them", async () => {
    const { model, attributes, listed } = sketch();
    const joints = 6;
    const sets = (set: number): JsonObject => ({
      [`JOINTS_${set}`]: model.values(
        (set === 0 ? Uint8Array : Uint16Array).from(
          Array.from({ length: 4 * VERTICES }, (_, i) => (set === 0 ? i % 4 : i % 4 < 2 ? 4 + (i % 2) : 0)),
        ),
        4,
      ),
      [`WEIGHTS_${set}`]:
        set === 0
          ? model.values(Uint8Array.from(Array.from({ length: VERTICES }, () => [60, 50, 40, 30]).flat()), 4, {
              normalized: true,
            })
          : model.values(Uint8Array.from(Array.from({ length: VERTICES }, () => [50, 25, 0, 0]).flat()), 4, {
              normalized: true,
            }),
    });
    const inverse = Array.from({ length: joints }, () => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]).flat();
    const skins = [{ joints: [1, 2, 3, 4, 5, 6], inverseBindMatrices: model.values(floats(inverse), 16) }];
    const bones = Array.from({ length: joints }, (_, i) => ({
      translation: [i / 10, 0, i / 20],
      ...(i === 0 && { children: [2, 3, 4, 5, 6] }),
    }));
    const primitive = { attributes: { ...attributes(), ...sets(0), ...sets(1) }, indices: listed() };
    const glb = await painted(model, [primitive], {
      nodes: [{ mesh: 0, skin: 0 }, ...bones],
      scenes: [{ nodes: [0, 1] }],
      skins,
    });
    const { document } = await unwrapped(glb);
    expect(document.getRoot().listSkins()).toHaveLength(1);
    expect(primitivesOf(document)[0]?.listSemantics()).toEqual(
      expect.arrayContaining(["JOINTS_0", "WEIGHTS_0", "JOINTS_1", "WEIGHTS_1"]),
    );
  });

  it("where its node turns it over by a negative scale", async () => {
    const { model, attributes, listed } = sketch();
    const primitive = { attributes: attributes(), indices: listed() };
    await unwrapped(await painted(model, [primitive], { nodes: [{ mesh: 0, scale: [-1, 2, 1] }] }));
  });

  it("where several nodes show one mesh, once for all of them", async () => {
    const { model, attributes, listed } = sketch();
    const glb = await painted(model, [{ attributes: attributes(), indices: listed() }], {
      nodes: [{ mesh: 0 }, { mesh: 0, translation: [0, 3, 0], scale: [0.5, 0.5, 0.5] }],
      scenes: [{ nodes: [0, 1] }],
    });
    const { glb: written } = await unwrapModel({ name: "twice.glb", bytes: glb }, { materials: [0], size: SIZE });
    const [old, document] = [await documentOf(glb), await documentOf(written)];
    expect(await faultsOf(written)).toEqual([]);
    for (const [i, surface] of surfaces(old).entries()) expect(surfaces(document)[i]).toMatchObject(surface);
    expect(await lookDifference(glb, written)).toBeLessThan(2);
    expect(document.getRoot().listMeshes()).toHaveLength(1);
    expect(
      document
        .getRoot()
        .listNodes()
        .map((node) => node.getMesh()),
    ).toEqual(Array(2).fill(document.getRoot().listMeshes()[0]));
  });

  it("where several primitives of one material share their vertices", async () => {
    const { model, attributes } = sketch();
    const shared = attributes();
    const half = (from: number): number => model.values(Uint16Array.from(indices.slice(from, from + 6)), 1);
    await unwrapped(
      await painted(model, [
        { attributes: shared, indices: half(0) },
        { attributes: shared, indices: half(6) },
      ]),
    );
  });

  it("where KHR_texture_transform scales, turns and moves its picture, of another set", async () => {
    const { model, attributes, listed } = sketch();
    const transform = { offset: [0.3, -0.2], rotation: 0.6, scale: [1.5, -0.75], texCoord: 1 };
    const texture = { index: 0, extensions: { KHR_texture_transform: transform } };
    const own = attributes();
    const second = model.values(floats(uvs.map((value) => 1 - value / 2)), 2);
    const glb = await painted(model, [{ attributes: { ...own, TEXCOORD_1: second }, indices: listed() }], {
      materials: [{ pbrMetallicRoughness: { baseColorTexture: texture } }],
      extensionsUsed: ["KHR_texture_transform"],
    });
    await unwrapped(glb);
  });
});

describe("a model of which some primitives name no material", () => {
  it("keeps the number of that one, where another material's points get a copy of it", async () => {
    const { model, attributes, listed } = sketch();
    const glb = await painted(model, [
      { attributes: attributes(), indices: listed() },
      { attributes: attributes(), mode: 0 },
      { attributes: attributes(), indices: listed(), material: undefined },
    ]);
    for (const materials of [[0], [0, 1]]) {
      const { glb: written } = await unwrapModel({ name: "some.glb", bytes: glb }, { materials, size: SIZE });
      expect(await faultsOf(written)).toEqual([]);
      const document = await documentOf(written);
      const listedMaterials = document.getRoot().listMaterials();
      const numbers = primitivesOf(document).map((primitive) =>
        listedMaterials.indexOf(primitive.getMaterial() as Material),
      );
      expect(numbers).toEqual([0, 2, 1]);
      expect(listedMaterials.map((material) => material.getBaseColorTexture() !== null)).toEqual([
        true,
        materials.includes(1),
        true,
      ]);
    }
  });
});

describe("what is shown with the old picture, and is not unwrapped, keeps it", () => {
  it("as points and lines do, and primitives that a variant gives the material", async () => {
    const { model, attributes, listed } = sketch();
    const variants = { mappings: [{ material: 0, variants: [0] }] };
    const glb = await painted(
      model,
      [
        { attributes: attributes(), indices: listed() },
        { attributes: attributes(), mode: 0 },
        { attributes: attributes(), indices: listed(), material: 1, extensions: { KHR_materials_variants: variants } },
      ],
      {
        materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }, {}],
        extensions: { KHR_materials_variants: { variants: [{ name: "worn" }] } },
        extensionsUsed: ["KHR_materials_variants"],
      },
    );
    const { glb: written } = await unwrapModel({ name: "worn.glb", bytes: glb }, { materials: [0], size: SIZE });
    expect(await faultsOf(written)).toEqual([]);
    const old = (await documentOf(glb)).getRoot().listMaterials()[0];
    const [faces, points, worn] = primitivesOf(await documentOf(written));
    const mapped = worn?.getExtension<MappingList>("KHR_materials_variants")?.listMappings()[0]?.getMaterial();
    expect(faces?.getMaterial()?.getBaseColorTextureInfo()?.getTexCoord()).toBe(1);
    for (const material of [points?.getMaterial(), mapped]) {
      expect(material?.getBaseColorTextureInfo()?.getTexCoord()).toBe(0);
      expect(material?.getBaseColorTexture()?.getImage()).toEqual(old?.getBaseColorTexture()?.getImage());
    }
  });
});

describe("a picture that is laid on the texture reads as it does on the model", () => {
  it("because no chart is mirrored", async () => {
    for (const shape of [cube(0), sphere(24, 12, 0)]) {
      const glb = buildGlb({ meshes: [shape], materials: [{}] });
      const { glb: written } = await unwrapModel({ name: "ball.glb", bytes: glb }, { materials: [0], size: SIZE });
      const found = turns(await documentOf(written));
      // At the poles lie triangles without area.
      expect([found.has(-1), found.has(1)]).toEqual([true, false]);
    }
  });

  it("also where a node's negative scale shows the model's triangles the other way round", async () => {
    const glb = buildGlb({ meshes: [cube(0)], materials: [{}], more: { nodes: [{ mesh: 0, scale: [-1, 2, 1] }] } });
    const { glb: written } = await unwrapModel({ name: "cube.glb", bytes: glb }, { materials: [0], size: SIZE });
    expect(turns(await documentOf(written))).toEqual(new Set([1]));
  });
});
