import { expect, test } from "./support/editor-page.ts";
import { readPng } from "./support/read-png.ts";
import { renderedAs } from "./support/rendered.ts";
import { boardPicture, file, ringPicture, squareGlb, squareGltf, twoSquaresGlb } from "./support/test-files.ts";

test("a saved design opens again to the same texels", async ({ editor }) => {
  await editor.open();
  await editor.addDemoDecal("sunburst");
  await editor.setField("spin", "12.5");
  const before = await editor.settledHash();
  const design = await editor.design();
  const { name, bytes } = await editor.saveDesign();
  expect(name).toBe("Mug.design.json");

  await editor.removeAllDecals();
  expect(await editor.hash()).not.toBe(before);
  await editor.openDesign([file(name, bytes)]);
  expect(await editor.settledHash()).toBe(before);
  expect(await editor.design()).toEqual(design);

  await editor.open();
  await editor.openDesign([file(name, bytes)]);
  expect(await editor.settledHash()).toBe(before);
});

test("a design with pictures beside it opens together with them, and says what is missing without", async ({
  editor,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const before = await editor.hash();
  const projector = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [0.5, 0.5, 0.2] };
  const document = {
    format: "texelcast-design",
    version: 1,
    assets: { ring: { type: "image/png", uri: "pictures/ring.png" } },
    layers: [{ type: "decal", asset: "ring", projector }],
  };
  const design = file("ring.design.json", JSON.stringify(document), "application/json");
  await editor.openDesign([design]);
  await expect(editor.notices).toHaveAttribute("data-code", "missing-file");
  await expect(editor.notices).toContainText("pictures/ring.png");
  expect(await editor.settledHash()).toBe(before);
  await editor.openDesign([design, ringPicture()]);
  expect(await editor.settledHash()).not.toBe(before);
  expect((await editor.design()).assets.ring?.uri).toMatch(/^data:image\/png;base64,/);
});

test("the exported PNG holds exactly the texels that are shown", async ({ editor }) => {
  await editor.open();
  await editor.openModel(squareGltf());
  await editor.addDemoDecal("badge");
  const { name, bytes } = await editor.exported("Texture as PNG");
  expect(name).toBe("square-texture.png");
  const { width, height, rgba } = readPng(bytes);
  expect({ width, height }).toEqual(await editor.textureSize());
  expect(rgba.equals(await editor.texels({ x: 0, y: 0, width, height }))).toBe(true);
});

test("the exported GLB opens again with the same texture as its own", async ({ editor, page }) => {
  await editor.open();
  const before = await editor.hash();
  const { name, bytes } = await editor.exported("Model as GLB");
  expect(name).toBe("Mug-painted.glb");
  await editor.openModel([file(name, bytes)]);
  await expect(page.locator("tc-top-bar .models")).toContainText("Mug-painted.glb");
  expect((await editor.design()).layers).toEqual([]);
  expect(await editor.settledHash()).toBe(before);
});

test("the exported USDZ is what the command line makes of the saved project", async ({ editor }) => {
  await editor.open();
  const { name, bytes } = await editor.exported("Model as USDZ");
  expect(name).toBe("Mug-painted.usdz");
  expect(renderedAs("out.usdz", [await editor.savedProject()]).equals(bytes)).toBe(true);
});

test("an exported GLB has the model's own textures where no visible layer paints", async ({ editor }) => {
  await editor.open();
  const model = twoSquaresGlb();
  await editor.openModel([model]);
  expect((await editor.exported("Model as GLB")).bytes.equals(model.buffer)).toBe(true);
  expect((await editor.exported("Texture as PNG")).name, "one of two").toBe("squares-Left.png");
  await editor.addDemoDecal("badge");
  expect((await editor.exported("Model as GLB")).bytes.equals(model.buffer)).toBe(false);
  await editor.row("Travel badge").locator("[data-action=visible]").click();
  expect((await editor.exported("Model as GLB")).bytes.equals(model.buffer)).toBe(true);
});

test("work that was not saved stays with its model, and can be brought along to the next", async ({ editor }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  await editor.addDemoDecal("badge");
  const painted = await editor.settledHash();
  await editor.openModel([squareGlb()]);
  const bare = await editor.settledHash();
  expect(bare).not.toBe(painted);
  await editor.notices.getByRole("button", { name: "Use them here" }).click();
  expect(await editor.settledHash()).toBe(painted);
});

test("leaving asks first only where the newest change is kept nowhere", async ({ editor, page }) => {
  await editor.open();
  const asked: string[] = [];
  page.on("dialog", (dialog) => {
    asked.push(dialog.type());
    void dialog.accept();
  });
  await editor.addDemoDecal("flower");
  await page.evaluate(() => window.texelcast.kept());
  await editor.open();
  expect(asked).toEqual([]);
  await page.evaluate(() => {
    IDBDatabase.prototype.transaction = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
  });
  await editor.addDemoDecal("smiley");
  await page.evaluate(() => window.texelcast.kept());
  await expect(editor.notices).toContainText("space for this page is used up");
  await page.reload();
  expect(asked).toEqual(["beforeunload"]);
});

test("a broken design is refused by the path of its fault, and the work stays", async ({ editor }) => {
  await editor.open();
  const before = await editor.design();
  const broken = { ...before, layers: [{ ...before.layers[0], opacity: 3 }] };
  await editor.openDesign([file("broken.design.json", JSON.stringify(broken))]);
  await expect(editor.notices).toHaveAttribute("data-code", "bad-design");
  await expect(editor.notices).toContainText("layers[0].opacity");
  expect(await editor.design()).toEqual(before);
});

test("a picture that is none is refused by name, and the design stays", async ({ editor, page }) => {
  await editor.open();
  const before = await editor.design();
  const broken = file("broken.png", boardPicture().buffer.subarray(0, 60), "image/png");
  await editor.choose(() => page.locator("#add-picture").click(), [broken]);
  await expect(editor.notices).toHaveAttribute("data-code", "bad-picture");
  await expect(editor.notices).toContainText("broken.png");
  expect(await editor.design()).toEqual(before);
});
