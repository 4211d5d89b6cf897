import { createEngineHost } from "../../web/engine/engine-host.ts";
import { readContainer } from "../../web/engine/gltf-container.ts";
import { imageBytes } from "../../web/engine/model-textures.ts";
import { buildGlb, plane } from "../support/model-builder.ts";
import { QUARTER_TURN, STORED, type TurnedPicture, turnedPictures } from "../support/turned-pictures.ts";
import { expect, test } from "./support/editor-page.ts";

const glbOf = (picture: TurnedPicture): Uint8Array =>
  buildGlb({
    meshes: [plane(1, 0)],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0 }],
    images: [picture],
  });

test("a texture that its EXIF would turn is shown by the browser as the engine lays it", async ({ page }) => {
  const decodedWidth = (bytes: Uint8Array, type: string): Promise<number> =>
    page.evaluate(
      async ([given, of]) => (await createImageBitmap(new Blob([Uint8Array.from(given)], { type: of }))).width,
      [[...bytes], type] as const,
    );
  const turned: string[] = [];
  for (const picture of await turnedPictures(QUARTER_TURN)) {
    const { mimeType, bytes } = picture;
    if ((await decodedWidth(bytes, mimeType)) === STORED.height) turned.push(mimeType);
    const engine = createEngineHost();
    const { glb } = await engine.loadModel({ name: "crate.glb", bytes: glbOf(picture) });
    engine.dispose();
    const { json, binary } = readContainer({ name: "crate.glb", bytes: glb });
    const shown = imageBytes(json, binary, 0, "crate.glb")?.bytes ?? new Uint8Array();
    expect(await decodedWidth(shown, mimeType), mimeType).toBe(STORED.width);
  }
  expect(turned, "what this browser turns by itself").toContain("image/jpeg");
});
