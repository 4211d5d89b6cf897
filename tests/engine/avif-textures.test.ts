import { afterEach, describe, expect, it } from "vitest";
import type { Picture } from "../../web/engine/engine-api.ts";
import { readContainer } from "../../web/engine/gltf-container.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { avifFile, avifModel } from "../support/avif-file.ts";
import { softPicture } from "../support/ktx2-file.ts";
import { endHosts, startHost } from "../support/painted-plane.ts";
import { solidPng } from "../support/png-file.ts";

afterEach(endHosts);

const SOFT: Picture = softPicture(64, 32);
const AVIF = "EXT_texture_avif";

describe("a model with AVIF textures alone", () => {
  it("is painted on what they show, at their size", async () => {
    const engine = startHost();
    const info = await engine.loadModel({ name: "a.glb", bytes: avifModel(await avifFile(SOFT)) });
    expect(info.materials[0]).toMatchObject({ textureSize: [64, 32], refusal: null });
    await engine.openTarget({ material: 0 });
    expect((await decodePicture(await engine.exportPng(0), "painted")).rgba).toEqual(SOFT.rgba);
  });

  it("is shown with them as they came, and written with the painted one as PNG", async () => {
    const [paint, other] = [await avifFile(SOFT), await avifFile(softPicture(8, 8))];
    const bytes = avifModel(paint, {
      materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } }, normalTexture: { index: 1 } }],
      textures: [{ extensions: { [AVIF]: { source: 0 } } }, { extensions: { [AVIF]: { source: 1 } } }],
      images: [
        { bytes: paint, mimeType: "image/avif" },
        { bytes: other, mimeType: "image/avif" },
      ],
    });
    const engine = startHost();
    const { glb } = await engine.loadModel({ name: "a.glb", bytes });
    expect(readContainer({ name: "shown", bytes: glb }).json.textures).toEqual([
      { extensions: { [AVIF]: { source: 0 } } },
      { extensions: { [AVIF]: { source: 1 } } },
    ]);
    await engine.openTarget({ material: 0 });
    const { json } = readContainer({ name: "written", bytes: await engine.exportGlb() });
    expect(json.textures).toEqual([{ source: 0 }, { extensions: { [AVIF]: { source: 1 } } }]);
    expect(json.extensionsRequired).toEqual([AVIF]);
  });

  it("may be looked at where one is damaged, and says so by its name when it is to be painted", async () => {
    const engine = startHost();
    const bytes = avifModel((await avifFile(SOFT)).slice(0, 300));
    const info = await engine.loadModel({ name: "broken.glb", bytes });
    expect(info.materials[0]?.textureSize).toBeNull();
    await expect(engine.openTarget({ material: 0 })).rejects.toMatchObject({
      code: "bad-picture",
      subject: "broken.glb, paint",
    });
  });
});

describe("a texture that offers a plain picture beside AVIF", () => {
  it("is read from the plain one, which needs no large decoder", async () => {
    const engine = startHost();
    const bytes = avifModel(await avifFile(SOFT), {
      textures: [{ source: 1, extensions: { [AVIF]: { source: 0 } } }],
      images: [
        { bytes: await avifFile(SOFT), mimeType: "image/avif" },
        { bytes: solidPng(4, 4, [10, 200, 30, 255]), mimeType: "image/png" },
      ],
    });
    await engine.loadModel({ name: "both.glb", bytes });
    await engine.openTarget({ material: 0 });
    const painted = await decodePicture(await engine.exportPng(0), "painted");
    expect([painted.width, ...painted.rgba.subarray(0, 4)]).toEqual([4, 10, 200, 30, 255]);
  });
});

describe("AVIF bytes given as a target's ground or as a decal", () => {
  it("are as large as they say, and a decal is as they show it", async () => {
    const engine = startHost();
    await engine.loadModel({ name: "a.glb", bytes: avifModel(await avifFile(SOFT)) });
    const base = { name: "ground.avif", bytes: await avifFile(softPicture(16, 8)) };
    expect(await engine.openTarget({ material: 0, base })).toMatchObject({ width: 16, height: 8 });
    expect(await engine.setAsset("logo", { name: "logo.avif", bytes: await avifFile(SOFT) })).toEqual({
      width: 64,
      height: 32,
    });
    const broken = engine.setAsset("logo", { name: "logo.avif", bytes: (await avifFile(SOFT)).slice(0, 99) });
    await expect(broken).rejects.toMatchObject({ code: "bad-picture", subject: "logo.avif" });
  });
});
