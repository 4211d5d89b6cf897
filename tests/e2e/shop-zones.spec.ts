/** Where a shop's product is printed in a polygon of its texture, what a customer adds begins in it. */
import { expect, type Locator, type Page, test } from "@playwright/test";
import { shopZones } from "../../scripts/demo/shop/zones.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];
type Product = "mug" | "skateboard";

async function openProduct(page: Page, product: Product): Promise<Locator> {
  await page.goto(`element.html?mode=shop&loading=eager&locale=en&src=demo/${product}.glb`);
  const editor = page.locator("texelcast-editor");
  await editor.evaluate(async (element: Editor, zones) => {
    element.zones = zones;
    await element.start();
  }, shopZones()[product]);
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
