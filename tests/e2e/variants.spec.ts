/** A model whose materials have variants: another one is shown, with what was painted. */
import { buildModel, plane } from "../support/model-builder.ts";
import { glbWithVariants } from "../support/variant-model.ts";
import { expect, type TestFile, test } from "./support/editor-page.ts";
import { file } from "./support/test-files.ts";

/** A square in red, which is green or blue as variants. */
function square(): TestFile {
  const colors = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const model = buildModel({
    meshes: [plane(1, 0)],
    materials: colors.map((color, i) => ({
      name: ["Red", "Green", "Blue"][i],
      pbrMetallicRoughness: { baseColorFactor: [...color, 1] },
    })),
  });
  const mappings = [
    { material: 1, variants: [0] },
    { material: 2, variants: [1] },
  ];
  return file("square.glb", glbWithVariants(model, ["Meadow", "Lake"], [mappings]));
}

test("a variant is chosen beside the texture, takes the decals along, and undo brings the one before back", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([square()]);
  await editor.addDemoDecal("flower");
  const red = { hash: await editor.settledHash(), design: await editor.design() };
  const variant = page.locator("tc-target-settings").getByLabel("Variant");
  await expect(variant.locator("option")).toHaveText(["As in the file", "Meadow", "Lake"]);
  await expect(variant).toHaveValue("");
  await variant.selectOption("Lake");
  await expect(page.locator("tc-target-settings #material")).toHaveValue("2");
  await editor.idle();
  await expect(variant).toHaveValue("1");
  const blue = await editor.settledHash();
  expect(blue).not.toBe(red.hash);
  expect((await editor.design()).layers.map((layer) => "material" in layer && layer.material)).toEqual([2]);

  await variant.selectOption("As in the file");
  await expect(page.locator("tc-target-settings #material")).toHaveValue("0");
  expect({ hash: await editor.settledHash(), design: await editor.design() }).toEqual(red);

  await page.keyboard.press("Escape");
  await page.keyboard.press("Control+z");
  await expect(variant).toHaveValue("1");
  expect(await editor.settledHash()).toBe(blue);

  await page.evaluate(() => window.texelcast.kept());
  await page.reload();
  await editor.idle();
  await expect(variant, "the project is the same one, and keeps the variant").toHaveValue("1");
  await expect(page.locator("tc-top-bar .projects")).toContainText(/^(?!.*square 2)/);
  expect(await editor.settledHash()).toBe(blue);
});

test("a model without variants has none to choose", async ({ editor, page }) => {
  await editor.open();
  await expect(page.locator("tc-target-settings").getByLabel("Variant")).toHaveCount(0);
});
