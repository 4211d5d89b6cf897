import { strToU8, zipSync } from "fflate";
import { afterEach, describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { chosenModel } from "../../web/engine/chosen-model.ts";
import type { ModelSource } from "../../web/engine/engine-api.ts";
import { readContainer, writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { inVariant } from "../../web/engine/variant-look.ts";
import { decal } from "../support/layers.ts";
import { buildModel, plane } from "../support/model-builder.ts";
import { allTexels, at, endHosts, LOGO, SIZE, startHost } from "../support/painted-plane.ts";
import { solidPng } from "../support/png-file.ts";
import { glbWithVariants, primitivesOf } from "../support/variant-model.ts";

afterEach(endHosts);

const NIGHT = (material: number): JsonObject => ({ material, variants: [1] });

interface Square {
  readonly material?: number;
  /** That "night" shows. */
  readonly night?: number;
}

/** Squares of materials M0 to M4, two side by side in space and in the texture. */
function model(squares: readonly Square[], used = ["KHR_materials_variants"]): ModelSource {
  const built = buildModel({
    meshes: squares.map(({ material }) => ({ ...plane(1, 0), ...(material !== undefined && { material }) })),
    materials: [0, 1, 2, 3, 4].map((index) => ({ name: `M${index}` })),
  });
  for (const [i, primitive] of primitivesOf(built.json).entries()) {
    if (squares[i]?.material === undefined) delete primitive.material;
  }
  const mappings = squares.map(({ night }) => (night === undefined ? undefined : [NIGHT(night)]));
  const bytes = glbWithVariants(built, ["day", "night"], mappings);
  const { json, binary } = readContainer({ name: "model.glb", bytes });
  return { name: "model.glb", bytes: writeGlb({ ...json, extensionsUsed: [...used] }, binary) };
}

/** Of each square the number and the name of its material. */
function shown(source: ModelSource): (readonly [unknown, unknown])[] {
  const { json } = readContainer(source);
  const materials = json.materials as JsonObject[];
  return primitivesOf(json).map(({ material }) => [material, materials[material as number]?.name]);
}

describe("a model in the look of a variant", () => {
  it("has its materials under the numbers that they had", () => {
    const source = model([{ material: 0, night: 3 }, { material: 1 }]);
    expect(shown(inVariant(source, "night"))).toEqual([
      [0, "M3"],
      [1, "M1"],
    ]);
    expect(shown(inVariant(source, "day")), "what a variant does not name stays").toEqual([
      [0, "M0"],
      [1, "M1"],
    ]);
  });

  it("takes two materials that change places from the file, and not one from the other", () => {
    const swapped = inVariant(
      model([
        { material: 0, night: 1 },
        { material: 1, night: 0 },
      ]),
      "night",
    );
    expect(shown(swapped)).toEqual([
      [0, "M1"],
      [1, "M0"],
    ]);
  });

  it("keeps two materials apart that the variant makes one", () => {
    const joined = inVariant(
      model([
        { material: 0, night: 2 },
        { material: 1, night: 2 },
      ]),
      "night",
    );
    expect(shown(joined)).toEqual([
      [0, "M2"],
      [1, "M2"],
    ]);
  });

  it("gives the first part its number where the variant parts a material, and the others new ones", () => {
    const parted = model([
      { material: 0, night: 3 },
      { material: 0, night: 4 },
      { material: 0 },
      { material: 0, night: 4 },
    ]);
    expect(shown(inVariant(parted, "night"))).toEqual([
      [0, "M3"],
      [5, "M4"],
      [6, "M0"],
      [5, "M4"],
    ]);
  });

  it("keeps the number of the material that glTF implies", () => {
    const source = model([{ night: 2 }, { material: 1, night: 4 }, { material: 1 }]);
    expect(shown(inVariant(source, "night"))).toEqual([
      [5, "M2"],
      [1, "M4"],
      [6, "M1"],
    ]);
    expect(shown(inVariant(source, "day"))[0]).toEqual([5, undefined]);
  });

  it("is a model without variants, whatever else it uses", () => {
    const plain = readContainer(inVariant(model([{ material: 0, night: 3 }]), "night")).json;
    expect(JSON.stringify(plain)).not.toContain("KHR_materials_variants");
    expect(plain).not.toHaveProperty("extensionsUsed");
    const both = model([{ material: 0, night: 3 }], ["KHR_materials_unlit", "KHR_materials_variants"]);
    expect(readContainer(inVariant(both, "night")).json.extensionsUsed).toEqual(["KHR_materials_unlit"]);
  });

  it("says by name which variants there are where it is asked for another, and where there are none", () => {
    const refusal = (source: ModelSource, variant: string): TexelcastError => {
      try {
        inVariant(source, variant);
      } catch (thrown) {
        if (thrown instanceof TexelcastError) return thrown;
      }
      throw new Error("It was not refused.");
    };
    expect(refusal(model([{ material: 0 }]), "dusk")).toMatchObject({
      code: "bad-model",
      reason: "which-variant",
      subject: "model.glb",
      field: "variant",
      value: "dusk",
      message: "“model.glb” has no variant “dusk”, but “day”, “night”.",
      hint: "Name one of them.",
    });
    const { json, binary } = buildModel({ meshes: [plane(1, 0)] });
    const plain = { name: "plain.glb", bytes: glbWithVariants({ json, binary }, [], []) };
    expect(refusal(plain, "dusk")).toMatchObject({
      message: "“plain.glb” has no variant “dusk”.",
      hint: "Leave out “#variant=dusk”: the model has one look.",
    });
  });

  it.each([
    ["of its own", { material: 7, night: 1 }],
    ["that the variant names", { material: 0, night: 7 }],
  ])("is refused by the engine as before where a material %s is not there", async (_whose, square) => {
    const source = model([square]);
    const message =
      "“model.glb” is not a sound glTF file: “meshes[0].primitives[0].material” must be the number of one of the 5 materials, from 0 on, and is 7.";
    await expect(startHost().loadModel({ ...source, name: "model.glb#variant=night" })).rejects.toThrow(message);
  });
});

describe("an address that ends with a variant", () => {
  it("means the model in that look, called without it", async () => {
    const source = model([{ material: 0, night: 3 }]);
    const chosen = await chosenModel({ ...source, name: "cups/model #2.glb#variant=night" });
    expect(chosen.name).toBe("cups/model #2.glb");
    expect(shown(chosen)).toEqual([[0, "M3"]]);
    expect(await chosenModel({ ...source, name: "model #2.glb" })).toMatchObject({ name: "model #2.glb" });
  });

  it("may lead into an archive, and to a model of several files", async () => {
    const { json, binary } = readContainer(model([{ material: 0, night: 3 }]));
    json.buffers = [{ byteLength: binary?.length ?? 0, uri: "scene.bin" }];
    const bytes = zipSync({ "a/scene.gltf": strToU8(JSON.stringify(json)), "a/scene.bin": binary as Uint8Array });
    const chosen = await chosenModel({ name: "pack.zip#variant=night", bytes });
    expect(chosen.name).toBe("pack.zip#a/scene.gltf");
    expect(shown(chosen)).toEqual([[0, "M3"]]);
    expect([...(chosen.resources?.keys() ?? [])]).toEqual(["scene.bin"]);
    const info = await startHost().loadModel({ name: "pack.zip#a/scene.gltf#variant=night", bytes });
    expect(info.materials[0]?.name).toBe("M3");
  });

  it("is painted by the same design, as a model is that has the variant's picture and no other", async () => {
    const RED = [200, 0, 0, 255] as const;
    const BLUE = [0, 0, 200, 255] as const;
    const squareOf = (...colors: (typeof RED | typeof BLUE)[]) =>
      buildModel({
        meshes: [{ ...plane(1, 0), material: 0 }],
        materials: colors.map((_, index) => ({ pbrMetallicRoughness: { baseColorTexture: { index } } })),
        textures: colors.map((_, source) => ({ source })),
        images: colors.map((color) => ({ bytes: solidPng(SIZE, SIZE, [...color]), mimeType: "image/png" })),
      });
    const painted = async (name: string, bytes: Uint8Array): Promise<Uint8Array> => {
      const engine = startHost();
      await engine.loadModel({ name, bytes });
      await engine.setAsset("logo", { name: "logo.png", bytes: LOGO });
      await engine.openTarget({ material: 0 });
      engine.setLayers([decal("a", "logo", at(0, 0))], 1);
      await engine.idle();
      return await allTexels(engine);
    };
    const both = glbWithVariants(squareOf(RED, BLUE), ["red", "blue"], [[{ material: 1, variants: [1] }]]);
    const { json, binary } = squareOf(BLUE);
    const blue = await painted("square.glb#variant=blue", both);
    expect(blue).toEqual(await painted("blue.glb", writeGlb(json, binary)));
    expect([...blue.subarray(0, 4)]).toEqual([...BLUE]);
    expect(blue).not.toEqual(await painted("square.glb#variant=red", both));
  });
});
