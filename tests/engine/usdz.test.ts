import { afterEach, describe, expect, it, vi } from "vitest";
import { writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { decodePicture, readPictureHeader } from "../../web/engine/picture-decoder.ts";
import { writeUsdz } from "../../web/engine/usdz/write-usdz.ts";
import { avifFile, avifModel } from "../support/avif-file.ts";
import { GltfSketch } from "../support/gltf-sketch.ts";
import { softPicture } from "../support/ktx2-file.ts";
import { decal } from "../support/layers.ts";
import { buildGlb, buildModel, cube, type ModelParts, plane } from "../support/model-builder.ts";
import { at, endHosts, paintablePlane, startHost, texturedPlane } from "../support/painted-plane.ts";
import { haveSharedModels, noteSkipped, SHARED_MODELS, sharedModel } from "../support/shared-models.ts";
import { STORED, turnedPictures } from "../support/turned-pictures.ts";
import { layerOf, seenByThree, storedFiles } from "../support/usdz-files.ts";

afterEach(() => {
  endHosts();
  vi.unstubAllGlobals();
});

/** What a shader of the layer says, by its name. */
const shader = (layer: string, name: string): string =>
  new RegExp(`def Shader "${name}"\\s*{([^}]*)}`).exec(layer)?.[1] ?? "";
const ofMaterial = async (material: JsonObject, more: Partial<ModelParts> = {}): Promise<string> =>
  layerOf(await writeUsdz(buildGlb({ ...texturedPlane, materials: [material], ...more }), "plane.glb"));

/** A bar from 0 to 2 along y, of three places: bound to two joints, a morph target half on, in a node that is turned elsewhere. */
function bentBar(): Uint8Array {
  const model = new GltfSketch();
  const positions = [0, 0, 0, 0.2, 1, 0, 0, 2, 0, 0.4, 2, 0.1];
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const down = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1];
  const attributes = {
    POSITION: model.places(positions),
    TEXCOORD_0: model.values(Float32Array.from([0, 0, 1, 0, 0, 1, 1, 1]), 2),
    JOINTS_0: model.values(Uint8Array.from([0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]), 4),
    // The second is bound half and half, to weights that do not add up to 1.
    WEIGHTS_0: model.values(Float32Array.from([1, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]), 4),
  };
  const targets = [{ POSITION: model.places([0, -1, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0]) }];
  const indices = model.values(Uint8Array.from([0, 1, 2, 1, 3, 2]), 1);
  const [sin, cos] = [0.3826834, 0.9238795];
  return model.glb({
    meshes: [{ weights: [0.5], primitives: [{ attributes, indices, targets }] }],
    nodes: [
      { mesh: 0, skin: 0, translation: [7, 7, 7] },
      { children: [2], translation: [1, 0, 0], scale: [2, 2, 2] },
      { translation: [0, 1, 0], rotation: [0, 0, sin, cos] },
    ],
    scenes: [{ nodes: [0, 1] }],
    skins: [{ joints: [1, 2], inverseBindMatrices: model.values(Float32Array.from([...identity, ...down]), 16) }],
  });
}

describe("a model as USDZ", () => {
  it("is a package of stored files, the layer first, each at a multiple of 64 bytes", async () => {
    const files = storedFiles(await writeUsdz(buildGlb(texturedPlane), "plane.glb"));
    expect(files.map(({ path }) => path)).toEqual(["model.usda", "textures/0.png"]);
    expect(files.map(({ method }) => method)).toEqual([0, 0]);
    expect(files.map(({ offset }) => offset % 64)).toEqual([0, 0]);
  });

  it("has the painted texture, texel by texel that of the PNG, and the same bytes each time", async () => {
    const { engine } = await paintablePlane();
    engine.setLayers([decal("a", "logo", at(0.1, 0))], 1);
    const usdz = await engine.exportUsdz();
    const png = await engine.exportPng(0);
    expect(storedFiles(usdz)[1]?.bytes).toEqual(png);
    expect(png).not.toEqual(texturedPlane.images[0]?.bytes);
    expect(await engine.exportUsdz()).toEqual(usdz);
  });

  it("leaves the model's own picture where the material is not asked for", async () => {
    const { engine } = await paintablePlane();
    engine.setLayers([decal("a", "logo", at(0.1, 0))], 1);
    expect(storedFiles(await engine.exportUsdz([]))[1]?.bytes).toEqual(texturedPlane.images[0]?.bytes);
  });

  it("lies where the core has it: skinned, morphed and scaled", async () => {
    const bytes = bentBar();
    const { boundsMin, boundsMax, triangles } = await startHost().loadModel({ name: "bar.glb", bytes });
    const [mesh] = seenByThree(await writeUsdz(bytes, "bar.glb"));
    mesh?.geometry.computeBoundingBox();
    const { min, max } = mesh?.geometry.boundingBox ?? {};
    expect(triangles).toBe(2);
    for (const axis of [0, 1, 2] as const) {
      expect(min?.getComponent(axis)).toBeCloseTo(boundsMin[axis], 5);
      expect(max?.getComponent(axis)).toBeCloseTo(boundsMax[axis], 5);
    }
  });

  it("shows the outside of a mirrored mesh, with normals outward", async () => {
    const glb = buildGlb({ meshes: [cube(0)], materials: [{}], more: { nodes: [{ mesh: 0, scale: [-2, 1, 1] }] } });
    const [mesh] = seenByThree(await writeUsdz(glb, "cube.glb"));
    const { position, normal } = mesh?.geometry.attributes ?? {};
    const index = mesh?.geometry.index ?? { count: position?.count ?? 0, getX: (i: number): number => i };
    expect(index.count).toBe(36);
    for (let i = 0; i < index.count; i += 3) {
      const [a = [], b = [], c = []] = [0, 1, 2].map((corner) => {
        const vertex = index.getX(i + corner);
        return [0, 1, 2].map((axis) => position?.getComponent(vertex, axis) ?? 0);
      });
      const side = (to: number[], axis: number): number => (to[axis] ?? 0) - (a[axis] ?? 0);
      const part = (one: number, other: number): number =>
        side(b, one) * side(c, other) - side(b, other) * side(c, one);
      const outward = (of: readonly number[]): number => of.reduce((sum, each, axis) => sum + each * (a[axis] ?? 0), 0);
      expect(outward([part(1, 2), part(2, 0), part(0, 1)])).toBeGreaterThan(0);
      expect(outward([0, 1, 2].map((axis) => normal?.getComponent(index.getX(i), axis) ?? 0))).toBeGreaterThan(0);
    }
  });

  it("has flat faces where the file has no normals", async () => {
    const { normals: _, ...bare } = plane(1, 0);
    const glb = buildGlb({
      meshes: [{ ...bare, positions: [-1, -1, 0, 1, -1, 0, 1, 1, 1, -1, 1, 0] }],
      materials: [{}],
    });
    const [mesh] = seenByThree(await writeUsdz(glb, "bent.glb"));
    const { normal } = mesh?.geometry.attributes ?? {};
    const normals = Array.from({ length: 6 }, (_, i) =>
      [0, 1, 2].map((axis) => normal?.getComponent(i, axis).toFixed(4)),
    );
    expect(new Set(normals.slice(0, 3).map(String)).size).toBe(1);
    expect(new Set(normals.slice(3).map(String)).size).toBe(1);
    expect(normals[0]).not.toEqual(normals[3]);
  });

  it("counts v from the bottom, after the texture's own transform", async () => {
    const transform = { offset: [0.25, 0.5], scale: [0.5, 0.25] };
    const info = { index: 0, extensions: { KHR_texture_transform: transform } };
    const layer = await ofMaterial({ pbrMetallicRoughness: { baseColorTexture: info } });
    // The plane's own: (0, 1), (1, 1), (1, 0), (0, 0).
    expect(layer).toContain("primvars:st = [(0.25, 0.25), (0.75, 0.25), (0.75, 0.5), (0.25, 0.5)]");
  });

  it("has pictures that its viewers cannot read as PNG", async () => {
    const soft = softPicture(64, 32);
    const usdz = await writeUsdz(avifModel(await avifFile(soft)), "a.glb");
    const picture = storedFiles(usdz)[1];
    expect(picture?.path).toBe("textures/0.png");
    expect(picture?.bytes.subarray(1, 4)).toEqual(Uint8Array.from(Buffer.from("PNG")));
    expect((await decodePicture(picture?.bytes ?? new Uint8Array(), "0.png")).rgba).toEqual(soft.rgba);
  });

  it("has pictures that EXIF would turn as they are stored", async () => {
    for (const picture of await turnedPictures()) {
      const usdz = await writeUsdz(buildGlb({ ...texturedPlane, images: [picture] }), "plane.glb");
      const packed = storedFiles(usdz)[1]?.bytes ?? new Uint8Array();
      expect(await readPictureHeader(packed, "packed")).toMatchObject({ ...STORED, orientation: 1 });
      const { rgba } = await decodePicture(picture.bytes, "given");
      expect((await decodePicture(packed, "packed", { asSeen: true })).rgba).toEqual(rgba);
    }
  });

  it("names a picture that has to be written anew and cannot be read", async () => {
    const broken = avifModel((await avifFile(softPicture(64, 32))).slice(0, 300));
    const refused = { code: "bad-picture", subject: "broken.glb, paint" };
    await expect(writeUsdz(broken, "broken.glb")).rejects.toMatchObject(refused);
  });

  it("refuses texture coordinates that only claim to be there, by their accessor", async () => {
    const { json, binary } = buildModel({
      ...texturedPlane,
      materials: [{ normalTexture: { index: 0, texCoord: 1 } }],
    });
    const [mesh] = json.meshes as [{ primitives: [{ attributes: JsonObject }] }];
    const accessors = json.accessors as JsonObject[];
    mesh.primitives[0].attributes.TEXCOORD_1 =
      accessors.push({ componentType: 5126, type: "VEC2", count: 2 ** 31 - 1 }) - 1;
    await expect(writeUsdz(writeGlb(json, binary), "plane.glb")).rejects.toMatchObject({
      code: "bad-container",
      field: "accessors[4].count",
    });
  });

  it("has no picture for a texture without bytes, and the colour alone", async () => {
    const layer = await ofMaterial(
      { pbrMetallicRoughness: { baseColorFactor: [0.5, 0.25, 1, 1], baseColorTexture: { index: 3 } } },
      { textures: [], images: [] },
    );
    expect(layer).toContain("color3f inputs:diffuseColor = (0.5, 0.25, 1)");
    expect(layer).not.toContain("UsdUVTexture");
  });
});

describe("a material in USDZ", () => {
  const base = { baseColorTexture: { index: 0 } };

  it("multiplies its picture by its colour, and says how the picture repeats", async () => {
    const layer = await ofMaterial(
      { doubleSided: true, pbrMetallicRoughness: { ...base, baseColorFactor: [0.5, 1, 0.25, 0.75] } },
      { textures: [{ source: 0, sampler: 0 }], samplers: [{ wrapS: 33071, wrapT: 33648 }] },
    );
    const picture = shader(layer, "base");
    expect(picture).toContain("asset inputs:file = @textures/0.png@");
    expect(picture).toContain('inputs:sourceColorSpace = "sRGB"');
    expect(picture).toContain("float4 inputs:scale = (0.5, 1, 0.25, 0.75)");
    expect(picture).toContain('inputs:wrapS = "clamp"');
    expect(picture).toContain('inputs:wrapT = "mirror"');
    expect(layer).toContain("uniform bool doubleSided = 1");
  });

  it("is see-through as glTF's alpha mode says, and else opaque whatever its picture's alpha", async () => {
    const opacity = (layer: string): string[] => layer.split("\n").filter((line) => line.includes("inputs:opacity"));
    const alpha = "</Model/Materials/Material_0/base.outputs:a>";
    const of = async (more: JsonObject): Promise<string[]> =>
      opacity(await ofMaterial({ pbrMetallicRoughness: base, ...more })).map((line) => line.trim());
    expect(await of({})).toEqual([]);
    expect(await of({ alphaMode: "BLEND" })).toEqual([`float inputs:opacity.connect = ${alpha}`]);
    expect(await of({ alphaMode: "MASK", alphaCutoff: 0.25 })).toEqual([
      `float inputs:opacity.connect = ${alpha}`,
      "float inputs:opacityThreshold = 0.25",
    ]);
    const clear = { KHR_materials_transmission: { transmissionFactor: 0.75 } };
    expect(await of({ extensions: clear })).toEqual(["float inputs:opacity = 0.25"]);
  });

  it("has bumps, shade, metal, coat and light of its own from their channels", async () => {
    const texture = { index: 0 };
    const layer = await ofMaterial({
      pbrMetallicRoughness: { metallicFactor: 0.5, roughnessFactor: 0.25, metallicRoughnessTexture: texture },
      normalTexture: { ...texture, scale: 0.5 },
      occlusionTexture: { ...texture, strength: 0.75 },
      emissiveTexture: texture,
      emissiveFactor: [1, 0.5, 0],
      extensions: {
        KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatRoughnessFactor: 0.5, clearcoatTexture: texture },
        KHR_materials_emissive_strength: { emissiveStrength: 2 },
        KHR_materials_ior: { ior: 1.4 },
      },
    });
    const at = "</Model/Materials/Material_0";
    for (const input of [
      `float inputs:roughness.connect = ${at}/surface.outputs:g>`,
      `float inputs:metallic.connect = ${at}/surface.outputs:b>`,
      `normal3f inputs:normal.connect = ${at}/normal.outputs:rgb>`,
      `float inputs:occlusion.connect = ${at}/occlusion.outputs:r>`,
      `color3f inputs:emissiveColor.connect = ${at}/emission.outputs:rgb>`,
      `float inputs:clearcoat.connect = ${at}/coat.outputs:r>`,
      "float inputs:clearcoatRoughness = 0.5",
      "float inputs:ior = 1.4",
    ]) {
      expect(layer).toContain(input);
    }
    expect(shader(layer, "surface")).toContain("float4 inputs:scale = (1, 0.25, 0.5, 1)");
    expect(shader(layer, "normal")).toContain("float4 inputs:scale = (1, 1, 2, 1)");
    expect(shader(layer, "normal")).toContain("float4 inputs:bias = (-0.5, -0.5, -1, 0)");
    expect(shader(layer, "normal")).toContain('inputs:sourceColorSpace = "raw"');
    expect(shader(layer, "occlusion")).toContain("float4 inputs:bias = (0.25, 0.25, 0.25, 0)");
    expect(shader(layer, "emission")).toContain("float4 inputs:scale = (2, 1, 0, 1)");
  });

  it("shines with its picture alone where it is unlit", async () => {
    const layer = await ofMaterial({ pbrMetallicRoughness: base, extensions: { KHR_materials_unlit: {} } });
    expect(layer).toContain("color3f inputs:diffuseColor = (0, 0, 0)");
    expect(layer).toContain("color3f inputs:emissiveColor.connect = </Model/Materials/Material_0/base.outputs:rgb>");
  });
});

noteSkipped("the shared models lie in USDZ where the core has them");
describe.runIf(haveSharedModels)("of the shared models", () => {
  it.each(SHARED_MODELS)("%s lies where the core has it, with all of its triangles", async (file) => {
    const source = sharedModel(file);
    const { glb, boundsMin, boundsMax, triangles } = await startHost().loadModel(source);
    const meshes = seenByThree(await writeUsdz(glb, file));
    const least = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
    const most = least.map((value) => -value);
    let corners = 0;
    for (const { geometry } of meshes) {
      geometry.computeBoundingBox();
      corners += geometry.index?.count ?? geometry.attributes.position?.count ?? 0;
      for (const axis of [0, 1, 2]) {
        least[axis] = Math.min(least[axis] ?? 0, geometry.boundingBox?.min.getComponent(axis) ?? 0);
        most[axis] = Math.max(most[axis] ?? 0, geometry.boundingBox?.max.getComponent(axis) ?? 0);
      }
    }
    expect(corners / 3).toBe(triangles);
    const size = Math.hypot(...boundsMax.map((value, axis) => value - (boundsMin[axis] ?? 0)));
    for (const axis of [0, 1, 2] as const) {
      expect(Math.abs((least[axis] ?? 0) - boundsMin[axis]) / size).toBeLessThan(1e-6);
      expect(Math.abs((most[axis] ?? 0) - boundsMax[axis]) / size).toBeLessThan(1e-6);
    }
  });
});
