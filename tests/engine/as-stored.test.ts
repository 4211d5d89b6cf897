import { afterEach, beforeAll, describe, expect, it } from "vitest";
import { readContainer } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { imageBytes } from "../../web/engine/model-textures.ts";
import { decodePicture, readPictureHeader } from "../../web/engine/picture-decoder.ts";
import { buildGlb, plane } from "../support/model-builder.ts";
import { endHosts, startHost } from "../support/painted-plane.ts";
import { QUARTER_TURN, STORED, type TurnedPicture, turnedPictures } from "../support/turned-pictures.ts";

afterEach(endHosts);

let pictures: readonly TurnedPicture[];
beforeAll(async () => {
  pictures = await turnedPictures();
});

/** A plane of one material; its base colour is the first picture, what else there is are its normals and its light. */
function glbOf(images: readonly TurnedPicture[]): Uint8Array {
  const material: JsonObject = {
    pbrMetallicRoughness: { baseColorTexture: { index: 0 } },
    ...(images.length > 1 && { normalTexture: { index: 1 } }),
    ...(images.length > 2 && { emissiveTexture: { index: 2 } }),
  };
  return buildGlb({
    meshes: [plane(1, 0)],
    materials: [material],
    textures: images.map((_, source) => ({ source })),
    images,
  });
}

function pictureIn(glb: Uint8Array, index: number): Uint8Array {
  const { json, binary } = readContainer({ name: "shown.glb", bytes: glb });
  return imageBytes(json, binary, index, "shown.glb")?.bytes ?? new Uint8Array();
}

describe("the GLB that the engine gives to viewers", () => {
  it("has no picture that a browser would turn, whichever its format, and every pixel as it was", async () => {
    expect(pictures.map(({ mimeType }) => mimeType)).toEqual(["image/png", "image/jpeg", "image/webp"]);
    for (const picture of pictures) {
      expect((await readPictureHeader(picture.bytes, "given")).orientation).toBe(QUARTER_TURN);
      const info = await startHost().loadModel({ name: "crate.glb", bytes: glbOf([picture]) });
      const shown = pictureIn(info.glb, 0);
      expect(await readPictureHeader(shown, "shown")).toMatchObject({ ...STORED, orientation: 1 });
      expect(shown).toHaveLength(picture.bytes.length);
      const { rgba } = await decodePicture(picture.bytes, "given");
      expect((await decodePicture(shown, "shown", { asSeen: true })).rgba).toEqual(rgba);
      expect(info.materials[0]?.textureSize).toEqual([STORED.width, STORED.height]);
    }
  });

  it("has a material's other pictures as they are stored, too", async () => {
    const info = await startHost().loadModel({ name: "crate.glb", bytes: glbOf(pictures) });
    for (const index of pictures.keys()) {
      expect((await readPictureHeader(pictureIn(info.glb, index), "shown")).orientation).toBe(1);
    }
  });

  it("has them so beside one that ends too early", async () => {
    for (const { mimeType, bytes } of pictures) {
      for (const length of [14, 25, 40]) {
        const images = [...pictures.slice(0, 1), { mimeType, bytes: bytes.slice(0, length) }];
        const info = await startHost().loadModel({ name: "crate.glb", bytes: glbOf(images) });
        expect((await readPictureHeader(pictureIn(info.glb, 0), "shown")).orientation).toBe(1);
      }
    }
  });

  it("is the file's own where nothing would be turned", async () => {
    const upright = glbOf(await turnedPictures(1));
    expect((await startHost().loadModel({ name: "crate.glb", bytes: upright })).glb).toEqual(upright);
  });

  it("leaves the user's file as it was, and what is exported of it", async () => {
    const [picture] = pictures as [TurnedPicture];
    const bytes = glbOf([picture]);
    const before = bytes.slice();
    const engine = startHost();
    await engine.loadModel({ name: "crate.glb", bytes });
    expect(bytes).toEqual(before);
    expect(pictureIn(await engine.exportGlb(), 0)).toEqual(picture.bytes);
  });
});
