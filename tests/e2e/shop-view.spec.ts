/** In the shop's mode, too, nobody comes through the wall of a product by looking closely. */
import { expect, type Locator, type Page, test } from "@playwright/test";
import type { PlanarProjector } from "../../web/editor/document/index.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];

async function openMug(page: Page, mode: string): Promise<Locator> {
  await page.goto(
    `element.html?mode=${mode}&loading=eager&locale=en&src=demo/mug.glb&size=64&camera-orbit=0deg 90deg auto`,
  );
  const editor = page.locator("texelcast-editor");
  await editor.evaluate(async (element: Editor) => await element.start());
  return editor;
}

/** How far in front of the mug's axis the surface in the middle of the view is, metres; behind it is its inside. */
const seenInFront = (editor: Locator): Promise<number> =>
  editor.evaluate(async (element: Editor) => {
    const id = await element.addDecal("demo/decals/smiley.png", { width: 0.001 });
    const { design } = await element.exportDesign();
    const { projector } = design.layers.find((layer) => layer.id === id) as { projector: PlanarProjector };
    element.removeLayer(id);
    return projector.position[2];
  });

for (const mode of ["shop", "full"]) {
  test(`neither a wheel nor the plus key leads through the wall of the product in the ${mode} mode`, async ({
    page,
  }) => {
    const editor = await openMug(page, mode);
    expect(await seenInFront(editor)).toBeGreaterThan(0);
    const view = editor.getByRole("application").first();
    const box = await view.boundingBox();
    if (!box) throw new Error("The view has no place on the page.");
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    for (let turn = 0; turn < 40; turn++) await page.mouse.wheel(0, -300);
    expect(await seenInFront(editor)).toBeGreaterThan(0);
    await view.focus();
    await page.keyboard.press("0");
    for (let step = 0; step < 60; step++) await page.keyboard.press("+");
    expect(await seenInFront(editor)).toBeGreaterThan(0);
  });
}
