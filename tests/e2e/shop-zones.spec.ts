/** Where a shop's product is printed in a polygon of its texture or in a box around a part of it, what a customer adds begins in it. */
import { expect, type Locator, type Page, test } from "@playwright/test";
import { shopZones } from "../../scripts/demo/shop/zones.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];
type Product = "mug" | "skateboard";

async function openProduct(page: Page, product: Product, zones: object = shopZones()[product]): Promise<Locator> {
  await page.goto(`element.html?mode=shop&loading=eager&locale=en&src=demo/${product}.glb`);
  const editor = page.locator("texelcast-editor");
  await editor.evaluate(async (element: Editor, zones) => {
    element.zones = zones;
    await element.start();
  }, zones);
  return editor;
}

/** Of what is printed of each layer, the shares that lie outside of all zones, and in a margin. */
const strayed = (editor: Locator): Promise<(readonly number[])[] | undefined> =>
  editor.evaluate(async (element: Editor) =>
    (await element.validate())?.layers.map(({ outsideZones, inSafeMargin }) => [outsideZones, inSafeMargin] as const),
  );

for (const product of ["mug", "skateboard"] as const) {
  test(`a picture and words that are added to the ${product} begin wholly inside its print zone`, async ({ page }) => {
    const editor = await openProduct(page, product);
    await editor.evaluate(async (element: Editor) => {
      await element.addDecal("demo/decals/smiley.png");
      await element.addText("Made for you");
    });
    expect(await strayed(editor)).toEqual([
      [0, 0],
      [0, 0],
    ]);
  });
}

/** On the mug's wall, in metres; the camera begins before the first, and does not see the last. */
const BOXES = {
  "before the customer": { position: [0, 0.05, 0.045], rotation: [0, 0, 0, 1], size: [0.05, 0.04, 0.03] },
  "that stands aslant": { position: [0, 0.05, 0.045], rotation: [0, 0, 0.258819, 0.965926], size: [0.05, 0.02, 0.03] },
  "behind the product": { position: [0, 0.05, -0.045], rotation: [0, 1, 0, 0], size: [0.04, 0.04, 0.03] },
};

for (const [where, shape] of Object.entries(BOXES)) {
  test(`a picture and words begin wholly inside a print zone that is a box ${where}`, async ({ page }) => {
    const zone = { id: "front", name: "Front", material: 0, safe: 1, shape: { kind: "box", ...shape } };
    const editor = await openProduct(page, "mug", { texelcastZones: 1, zones: [zone] });
    const widths = await editor.evaluate(async (element: Editor) => {
      await element.addDecal("demo/decals/smiley.png");
      await element.addText("Made for you");
      const { design } = await element.exportDesign();
      return design.layers.map((layer) =>
        "projector" in layer && layer.projector.kind === "planar" ? layer.projector.size[0] : 0,
      );
    });
    expect(await strayed(editor)).toEqual([
      [0, 0],
      [0, 0],
    ]);
    // Large enough to be seen.
    for (const width of widths) expect(width).toBeGreaterThan(0.008);
  });
}
