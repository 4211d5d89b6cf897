/** A model whose parts share texture, unwrapped from the texture's panel. */
import { createHash } from "node:crypto";
import { createEngineHost } from "../../web/engine/engine-host.ts";
import { unwrapModel } from "../../web/engine/unwrap/unwrap-model.ts";
import { buildGlb } from "../support/model-builder.ts";
import { expect, test } from "./support/editor-page.ts";

/** Two squares side by side, each on the whole texture. */
function twins(): Buffer {
  const square = (x: number) => ({
    positions: [x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0],
    uvs: [0, 1, 1, 1, 1, 0, 0, 0],
    indices: [0, 1, 2, 0, 2, 3],
    material: 0,
  });
  return Buffer.from(buildGlb({ meshes: [square(0), square(1.5)], materials: [{ name: "Paint" }] }));
}

/** SHA-256 of the same model, unwrapped here. */
async function hashInNode(): Promise<string> {
  const { glb } = await unwrapModel({ name: "twins.glb", bytes: twins() }, { materials: [0], size: 1024 });
  const engine = createEngineHost();
  try {
    await engine.loadModel({ name: "twins.glb", bytes: glb });
    return createHash("sha256")
      .update(await engine.exportGlb([]))
      .digest("hex");
  } finally {
    engine.dispose();
  }
}

test("parts that share texture get their own at a press, and undo brings the old model back", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([{ name: "twins.glb", mimeType: "model/gltf-binary", buffer: twins() }]);
  const settings = page.locator("tc-target-settings");
  const button = settings.getByRole("button", { name: "Give each part its own texture" });
  await expect(settings.locator(".warning")).toBeVisible();
  await button.click();
  await expect(button).toBeHidden({ timeout: 30_000 });
  await editor.idle();
  await expect(settings.locator(".warning")).toBeHidden();
  await expect(settings.locator("dd").last()).toHaveText("0.0 %");
  const inPage = await page.evaluate(async () => Array.from(await window.texelcast.engine.exportGlb([])));
  expect(createHash("sha256").update(Uint8Array.from(inPage)).digest("hex"), "the bytes of Node").toBe(
    await hashInNode(),
  );
  await page.keyboard.press("Control+z");
  await expect(button).toBeVisible();
  await expect(settings.locator(".warning")).toBeVisible();
});
