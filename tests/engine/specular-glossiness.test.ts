import { afterEach, describe, expect, it } from "vitest";
import { readContainer } from "../../web/engine/gltf-container.ts";
import { type JsonObject, listOf } from "../../web/engine/gltf-json.ts";
import { loadModelFile } from "../../web/engine/model-loader.ts";
import { writeModel } from "../../web/engine/model-writer.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { buildGlb, plane } from "../support/model-builder.ts";
import { allTexels, CHART, endHosts, SIZE, startHost } from "../support/painted-plane.ts";
import { paintPng, solidPng } from "../support/png-file.ts";

afterEach(endHosts);

const EXTENSION = "KHR_materials_pbrSpecularGlossiness";
const SHINE = solidPng(1, 1, [10, 20, 30, 40]);

/** A square of which the colour stands in the extension alone, as Sketchfab wrote it for years. */
function shinySquare(extension: JsonObject, rest: JsonObject = {}): Uint8Array {
  return buildGlb({
    meshes: [plane(1, 0)],
    materials: [{ name: "paint", ...rest, extensions: { [EXTENSION]: extension } }],
    textures: [{ source: 0 }, { source: 1 }],
    images: [
      { bytes: CHART, mimeType: "image/png", name: "colour" },
      { bytes: SHINE, mimeType: "image/png", name: "shine" },
    ],
    more: { extensionsUsed: [EXTENSION], extensionsRequired: [EXTENSION] },
  });
}

const DIFFUSE = { diffuseTexture: { index: 0 }, specularGlossinessTexture: { index: 1 } };

function jsonOf(bytes: Uint8Array): JsonObject {
  return readContainer({ name: "written.glb", bytes }).json;
}

describe("a material whose colour is KHR_materials_pbrSpecularGlossiness's", () => {
  it("is painted on its diffuse picture", async () => {
    const engine = startHost();
    await engine.loadModel({ name: "shiny.glb", bytes: shinySquare(DIFFUSE) });
    const target = await engine.openTarget({ material: 0, width: SIZE });
    expect(target).toMatchObject({ width: SIZE, height: SIZE });
    await engine.idle();
    expect(await allTexels(engine)).toEqual((await decodePicture(CHART, "chart.png")).rgba);
  });

  it("has its diffuse colour where it has no picture", async () => {
    const engine = startHost();
    const bytes = shinySquare({ diffuseFactor: [1, 0, 0, 1] });
    await engine.loadModel({ name: "shiny.glb", bytes });
    await engine.openTarget({ material: 0, width: SIZE });
    await engine.idle();
    expect([...(await allTexels(engine)).subarray(0, 4)]).toEqual([255, 0, 0, 255]);
  });

  it("is shown as no metal, as rough as it is not glossy", async () => {
    const bytes = shinySquare({ diffuseTexture: { index: 0 }, glossinessFactor: 0.25 });
    const { glb } = await loadModelFile({ name: "s.glb", bytes });
    const json = jsonOf(glb);
    expect(listOf(json, "materials", "s")).toEqual([
      {
        name: "paint",
        pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0, roughnessFactor: 0.75 },
      },
    ]);
    expect(json.extensionsUsed).toBeUndefined();
    expect(json.extensionsRequired).toBeUndefined();
  });

  it("keeps the colour that it has for viewers without the extension", async () => {
    const pbrMetallicRoughness = { baseColorTexture: { index: 1 }, roughnessFactor: 0.3 };
    const { glb } = await loadModelFile({ name: "s.glb", bytes: shinySquare(DIFFUSE, { pbrMetallicRoughness }) });
    expect(listOf(jsonOf(glb), "materials", "s")).toEqual([{ name: "paint", pbrMetallicRoughness }]);
  });

  it("is written so that viewers with the extension and without it show what was painted", async () => {
    const painted = paintPng(4, 4, (x, y) => [x * 60, y * 60, 9, 255]);
    const original = readContainer({
      name: "s.glb",
      bytes: shinySquare({ ...DIFFUSE, diffuseFactor: [1, 0.5, 1, 1] }),
    });
    const written = writeModel(original, [{ material: 0, png: painted, texCoord: 0, factorBaked: false }]);
    const json = jsonOf(written);
    const [material] = listOf(json, "materials", "s");
    const texture = { index: 0 };
    expect(material).toEqual({
      name: "paint",
      pbrMetallicRoughness: {
        baseColorTexture: texture,
        baseColorFactor: [1, 0.5, 1, 1],
        metallicFactor: 0,
        roughnessFactor: 0.5,
      },
      extensions: {
        [EXTENSION]: {
          diffuseTexture: texture,
          diffuseFactor: [1, 0.5, 1, 1],
          specularGlossinessTexture: { index: 1 },
        },
      },
    });
    // In place of the old picture, which nothing else needs.
    const images = listOf(json, "images", "s");
    expect(images.map(({ name }) => name)).toEqual(["colour", "shine"]);
  });

  it("has what was painted in place of its colour where it had no picture", async () => {
    const painted = paintPng(4, 4, (x, y) => [x * 60, y * 60, 9, 255]);
    const original = readContainer({ name: "s.glb", bytes: shinySquare({ diffuseFactor: [1, 0, 0, 1] }) });
    const bytes = writeModel(original, [{ material: 0, png: painted, texCoord: 0, factorBaked: true }]);
    const [material] = listOf(jsonOf(bytes), "materials", "s");
    expect(material).toMatchObject({
      extensions: { [EXTENSION]: { diffuseTexture: { index: 2 }, diffuseFactor: [1, 1, 1, 1] } },
    });
    const engine = startHost();
    await engine.loadModel({ name: "again.glb", bytes });
    await engine.openTarget({ material: 0 });
    await engine.idle();
    expect(await engine.readTexels(0, 0, 0, 4, 4)).toEqual((await decodePicture(painted, "painted.png")).rgba);
  });
});
