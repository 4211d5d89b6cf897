/** Models unwrapped anew: what of them must stay, and what must be so afterwards. */
import type { Primitive } from "@gltf-transform/core";
import { describe, expect, it } from "vitest";
import type { ModelSource, Picture } from "../../web/engine/engine-api.ts";
import { writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { loadModelFile } from "../../web/engine/model-loader.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { encodePng } from "../../web/engine/png-encoder.ts";
import { resampleTexture } from "../../web/engine/unwrap/texture-resampler.ts";
import { unwrapModel } from "../../web/engine/unwrap/unwrap-model.ts";
import { compressedModels } from "../support/compressed-models.ts";
import { buildGlb, buildModel, type ModelParts } from "../support/model-builder.ts";
import { haveSharedModels, noteSkipped, sharedModel } from "../support/shared-models.ts";
import { corners, documentOf, faultsOf, lookDifference, overlapOf, primitivesOf } from "../support/unwrapped-models.ts";

const SIZE = 256;

/** A square of two triangles on the whole texture, beside others at `x`. */
const square = (x: number) => ({
  positions: [x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0],
  normals: [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1],
  uvs: [0, 1, 1, 1, 1, 0, 0, 0],
  indices: [0, 1, 2, 0, 2, 3],
  material: 0,
});

async function motley(side: number): Promise<Uint8Array> {
  const rgba = Uint8Array.from({ length: side * side * 4 }, (_, i) =>
    i % 4 === 3 ? 255 : (((i >> 2) % side) * 29 + i * 7) % 251,
  );
  return await encodePng({ width: side, height: side, rgba });
}

async function squares(more: Partial<ModelParts> = {}): Promise<ModelSource> {
  const parts: ModelParts = {
    meshes: [square(0), square(2)],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0 }],
    images: [{ bytes: await motley(16), mimeType: "image/png" }],
    ...more,
  };
  return { name: "squares.glb", bytes: buildGlb(parts) };
}

describe("a model that is unwrapped", () => {
  it("gives two meshes with one material texels of their own on one texture", async () => {
    const source = await squares();
    expect((await overlapOf(source.bytes, SIZE)).overlapping, "before").toBeGreaterThan(1000);
    const { glb, materials } = await unwrapModel(source, { materials: [0], size: SIZE });
    const { covered, overlapping } = await overlapOf(glb, SIZE);
    expect(overlapping).toBe(0);
    expect(covered / SIZE ** 2).toBeGreaterThan(0.3);
    expect(materials).toMatchObject([{ material: 0, triangles: 4, withoutPlace: 0, texCoord: 1 }]);
  });

  it("looks as before, and keeps its former coordinates beside the new ones", async () => {
    const source = await squares();
    const { glb } = await unwrapModel(source, { materials: [0], size: SIZE });
    expect(await lookDifference(source.bytes, glb)).toBeLessThan(2);
    const [before, after] = [await documentOf(source.bytes), await documentOf(glb)];
    for (const [i, primitive] of primitivesOf(before).entries()) {
      for (const semantic of ["POSITION", "NORMAL", "TEXCOORD_0"]) {
        expect(corners(primitivesOf(after)[i] as Primitive, semantic)).toEqual(corners(primitive, semantic));
      }
    }
    expect(await faultsOf(glb)).toEqual([]);
  });

  it("says the bounds of the vertices that it has: one that no triangle names is left out, with its place", async () => {
    const far = { ...square(0), positions: [...square(0).positions, 9, 9, 9] };
    const withFifth = { ...far, normals: [...square(0).normals, 0, 0, 1], uvs: [...square(0).uvs, 0, 0] };
    const { glb } = await unwrapModel(await squares({ meshes: [withFifth] }), { materials: [0], size: SIZE });
    expect(await faultsOf(glb)).toEqual([]);
  });

  it("is refused where an attribute has not as many elements as there are vertices, however many it claims", async () => {
    for (const count of [3, 2 ** 31]) {
      const { json, binary } = buildModel({ meshes: [square(0)], materials: [{}] });
      const accessors = json.accessors as JsonObject[];
      accessors.push({ componentType: 5126, type: "SCALAR", count });
      const [primitive] = (json.meshes as { primitives: { attributes: JsonObject }[] }[])[0]?.primitives ?? [];
      if (primitive) primitive.attributes._WEAR = accessors.length - 1;
      const work = unwrapModel({ name: "worn.glb", bytes: writeGlb(json, binary) }, { materials: [0], size: SIZE });
      await expect(work).rejects.toMatchObject({
        ...{ code: "bad-container", subject: "worn.glb", field: `accessors[${accessors.length - 1}].count` },
        value: String(count),
      });
    }
  });

  it("comes out as the same bytes twice", async () => {
    const source = await squares();
    const [first, second] = [
      await unwrapModel(source, { materials: [0], size: SIZE }),
      await unwrapModel(source, { materials: [0], size: SIZE }),
    ];
    expect(Buffer.compare(first.glb, second.glb)).toBe(0);
  });

  it("is not turned by what KHR_texture_transform said of the former coordinates", async () => {
    const transform = { offset: [0.25, 0.5], rotation: 0.5, scale: [2, 3] };
    const texture = { index: 0, extensions: { KHR_texture_transform: transform } };
    const source = await squares({
      materials: [{ pbrMetallicRoughness: { baseColorTexture: texture } }],
      more: { extensionsUsed: ["KHR_texture_transform"] },
    });
    const { glb } = await unwrapModel(source, { materials: [0], size: SIZE });
    const { json } = (await loadModelFile({ name: "unwrapped.glb", bytes: glb })).packed;
    expect(json.materials).toMatchObject([{ pbrMetallicRoughness: { baseColorTexture: { texCoord: 1 } } }]);
    expect(JSON.stringify(json.materials)).not.toContain("KHR_texture_transform");
    expect((await overlapOf(glb, SIZE)).overlapping).toBe(0);
  });

  it("gets coordinates where it has none, and its colour as a texture, so that paint on it keeps its own colours", async () => {
    const { uvs: _, ...bare } = square(0);
    const source = await squares({
      meshes: [bare],
      materials: [{ pbrMetallicRoughness: { baseColorFactor: [1, 0.5, 0.002, 0.25] } }],
      textures: [],
      images: [],
    });
    const { glb, materials } = await unwrapModel(source, { materials: [0], size: SIZE });
    expect(materials[0]?.texCoord).toBe(0);
    const document = await documentOf(glb);
    const [material] = document.getRoot().listMaterials();
    expect(material?.getBaseColorFactor()).toEqual([1, 1, 1, 1]);
    const picture = await decodePicture(material?.getBaseColorTexture()?.getImage() ?? new Uint8Array(), "plain");
    expect([picture.width, picture.height]).toEqual([SIZE, SIZE]);
    // As sRGB: 0.5 is 187.5 by the curve, 0.002 lies on its straight part.
    const colors = Array.from({ length: 4 }, (_, c) => new Set(picture.rgba.filter((_, i) => i % 4 === c)));
    expect(colors).toEqual([new Set([255]), new Set([188]), new Set([7]), new Set([64])]);
    expect((await overlapOf(glb, SIZE)).covered).toBeGreaterThan(1000);
  });

  it("gets coordinates of use where those that it has are no numbers, or far out of range", async () => {
    for (const broken of [Number.NaN, Number.POSITIVE_INFINITY, -3e38]) {
      const bad = { ...square(0), uvs: [broken, 1, 1, 1, 1, 0, 0, broken] };
      const source = await squares({ meshes: [bad, square(2)] });
      const { glb } = await unwrapModel(source, { materials: [0], size: SIZE });
      const { covered, overlapping, info } = await overlapOf(glb, SIZE);
      expect([info?.refusal, overlapping, covered > 1000]).toEqual([null, 0, true]);
      const [material] = (await documentOf(glb)).getRoot().listMaterials();
      const { rgba } = await decodePicture(material?.getBaseColorTexture()?.getImage() ?? new Uint8Array(), "new");
      const least = rgba.filter((_, i) => i % 4 === 3).reduce((low, alpha) => Math.min(low, alpha), 255);
      expect(least, "what shows its place shows the picture, and no hole").toBe(255);
    }
  });

  it("is read through Draco and meshopt", async () => {
    const compressed = await compressedModels((await squares()).bytes);
    for (const bytes of [compressed.draco, compressed.meshopt]) {
      const { glb } = await unwrapModel({ name: "squares.glb", bytes }, { materials: [0], size: SIZE });
      expect((await overlapOf(glb, SIZE)).overlapping).toBe(0);
    }
  });

  it("keeps triangles without area, as points of the texture", async () => {
    const flat = { ...square(0), indices: [0, 1, 2, 0, 2, 3, 1, 1, 2] };
    const { glb, materials } = await unwrapModel(await squares({ meshes: [flat] }), { materials: [0], size: SIZE });
    expect(materials).toMatchObject([{ triangles: 3, withoutPlace: 1 }]);
    expect(
      corners(primitivesOf(await documentOf(glb))[0] as Primitive, "TEXCOORD_1")
        .flat()
        .every(Number.isFinite),
    ).toBe(true);
    expect((await overlapOf(glb, SIZE)).overlapping).toBe(0);
  });

  it("names a material that is not there", async () => {
    const work = unwrapModel(await squares(), { materials: [7], size: SIZE });
    await expect(work).rejects.toMatchObject({ code: "no-material", subject: "squares.glb", value: "7" });
  });
});

describe("a picture laid on other coordinates", () => {
  const picture: Picture = {
    width: 2,
    height: 1,
    rgba: Uint8Array.of(0, 0, 0, 255, 200, 0, 0, 255),
  };
  /** The middle of a triangle whose corners all lie at `u` of the old picture. */
  const redAt = (u: number, wrap: "repeat" | "mirror" | "clamp"): number => {
    const from = Float64Array.of(u, 0.5, u, 0.5, u, 0.5);
    const to = Float32Array.of(0, 0, 8, 0, 0, 8);
    return resampleTexture({ picture, wrap: [wrap, wrap], nearest: false }, [{ from, to }], 8)[0] as number;
  };

  it("goes on beyond its edge as its sampler says", () => {
    expect([redAt(1.25, "repeat"), redAt(1.25, "mirror"), redAt(1.25, "clamp")]).toEqual([0, 200, 200]);
    expect([redAt(-0.25, "repeat"), redAt(-0.25, "mirror"), redAt(-0.25, "clamp")]).toEqual([200, 0, 0]);
  });

  it("gives texels outside of all triangles the colour of the nearest one", () => {
    const from = Float64Array.of(0.75, 0.5, 0.75, 0.5, 0.75, 0.5);
    const to = Float32Array.of(0, 0, 2, 0, 0, 2);
    const rgba = resampleTexture({ picture, wrap: ["clamp", "clamp"], nearest: false }, [{ from, to }], 32);
    expect(new Set(rgba.filter((_, i) => i % 4 === 0))).toEqual(new Set([200]));
  });
});

noteSkipped("a character whose parts share a palette is unwrapped");
describe.runIf(haveSharedModels)("the Knight of KayKit, most of whose texels are shared", () => {
  it("shares none afterwards, looks as before, and moves as before", async () => {
    const source = sharedModel("Knight.glb");
    const { glb } = await unwrapModel(source, { materials: [0], size: 1024 });
    expect((await overlapOf(glb, SIZE)).overlapping).toBe(0);
    expect(await lookDifference(source.bytes, glb)).toBeLessThan(2);
    const [before, after] = [await documentOf(source.bytes), await documentOf(glb)];
    for (const [i, primitive] of primitivesOf(before).entries()) {
      for (const semantic of primitive.listSemantics()) {
        expect(corners(primitivesOf(after)[i] as Primitive, semantic)).toEqual(corners(primitive, semantic));
      }
    }
    expect([after.getRoot().listAnimations().length, after.getRoot().listSkins().length]).toEqual([
      before.getRoot().listAnimations().length,
      before.getRoot().listSkins().length,
    ]);
    expect(await faultsOf(glb)).toEqual(await faultsOf(source.bytes));
  });
});
