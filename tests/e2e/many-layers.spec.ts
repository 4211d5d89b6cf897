import {
  manyLayers,
  manyLayersHash,
  manyLayersModel,
  manyLayersPictures,
  manyLayersSize,
} from "../support/many-layers.ts";
import { expect, test } from "./support/editor-page.ts";

test("many layers give the one hash in the browser that Node and native code give", async ({ editor, page }) => {
  await editor.open();
  const base64 = (bytes: Uint8Array): string => Buffer.from(bytes).toString("base64");
  const hash = await page.evaluate(
    async ({ model, pictures, layers, size }) => {
      const bytes = (text: string): Uint8Array => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      const { engine } = window.texelcast;
      await engine.loadModel({ name: "many-layers.glb", bytes: bytes(model) });
      for (const { key, png } of pictures) await engine.setAsset(key, { name: `${key}.png`, bytes: bytes(png) });
      await engine.openTarget({ material: 0, width: size, height: size, base: [1, 1, 1, 1] });
      engine.setLayers(layers, 1_000_000);
      await engine.idle();
      return engine.hash(0);
    },
    {
      model: base64(manyLayersModel()),
      pictures: manyLayersPictures().map(({ key, bytes }) => ({ key, png: base64(bytes) })),
      layers: manyLayers(),
      size: manyLayersSize,
    },
  );
  expect(hash).toBe(manyLayersHash);
});
