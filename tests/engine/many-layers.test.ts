import { expect, test } from "vitest";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import {
  manyLayers,
  manyLayersHash,
  manyLayersModel,
  manyLayersPictures,
  manyLayersSize,
} from "../support/many-layers.ts";

test("many layers give the one hash in Node that native code gives", async () => {
  const engine = createEngineHost();
  await engine.loadModel({ name: "many-layers.glb", bytes: manyLayersModel() });
  for (const { key, bytes } of manyLayersPictures()) await engine.setAsset(key, { name: `${key}.png`, bytes });
  await engine.openTarget({
    material: 0,
    width: manyLayersSize,
    height: manyLayersSize,
    base: [1, 1, 1, 1],
  });
  engine.setLayers(manyLayers(), 1);
  await engine.idle();
  expect(await engine.hash(0)).toBe(manyLayersHash);
  engine.dispose();
});
