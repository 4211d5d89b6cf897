/** The pixel tools on small skins, texel by texel. */
import { expect, test } from "./support/editor-page.ts";
import { demoFile } from "./support/test-files.ts";

test("on a small skin the pixel tools are offered: pencil, bucket over seams, picker, and each is one step", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([demoFile("block-wide.glb")]);
  expect(await editor.textureSize()).toEqual({ width: 64, height: 64 });
  const bare = await editor.settledHash();
  const box = await editor.stage.boundingBox();
  if (!box) throw new Error("The stage has no place.");
  const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };

  await page.keyboard.press("n");
  await editor.drag({ x: middle.x - 30, y: middle.y - 20 }, { x: middle.x + 30, y: middle.y - 20 }, 5);
  await expect.poll(async () => (await editor.design()).layers.length).toBe(1);
  expect((await editor.design()).layers[0]).toMatchObject({
    type: "decal",
    filter: "nearest",
    projector: { kind: "uv", size: [1, 1] },
  });
  const pencilled = await editor.settledHash();
  expect(pencilled).not.toBe(bare);

  await page.keyboard.press("x");
  await page.keyboard.press("g");
  // The sides of a box differ a little in tint.
  await editor.setField("tool-tolerance", "24");
  await page.mouse.click(middle.x, middle.y + 10);
  await expect.poll(() => editor.settledHash()).not.toBe(pencilled);
  const texels = await editor.texels({ x: 0, y: 0, width: 64, height: 64 });
  let white = 0;
  for (let at = 0; at < texels.length; at += 4) if (texels.readUInt32LE(at) === 0xffffffff) white += 1;
  // A whole box but for the pencil's line: two sides of 8 x 12, two of 4 x 12, and two ends of 8 x 4 at the least.
  expect(white).toBeGreaterThan(300);

  await page.keyboard.press("d");
  await page.keyboard.press("i");
  await page.mouse.click(middle.x, middle.y + 10);
  await expect(page.locator("tc-tool-options #tool-color")).toHaveValue("#ffffff");

  await page.keyboard.press("Control+z");
  await expect.poll(() => editor.settledHash()).toBe(pencilled);
  await page.keyboard.press("Control+z");
  await expect.poll(() => editor.settledHash()).toBe(bare);
  await expect(editor.notices).toHaveCount(0);
});

test("on a pixel layer whose mask is painted on, the eraser hides by the mask and takes no texel away", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([demoFile("block-wide.glb")]);
  const { x, y } = await editor.middleOfStage();
  const line = [
    { x: x - 30, y },
    { x: x + 30, y },
  ] as const;
  await page.keyboard.press("n");
  await editor.drag(...line, 5);
  await expect.poll(async () => (await editor.design()).layers).toHaveLength(1);
  const pencilled = await editor.settledHash();
  const id = await editor.lowestLayer();
  const { asset } = await editor.decal(id);

  await editor.select(id);
  await editor.action("add-mask").click();
  await page.keyboard.press("e");
  await editor.drag(...line, 5);
  await expect
    .poll(async () => (await editor.decal(id)).mask?.layers)
    .toMatchObject([{ type: "decal", filter: "nearest", blend: "erase" }]);
  expect((await editor.decal(id)).asset).toBe(asset);
  expect(await editor.settledHash()).not.toBe(pencilled);
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(pencilled);
});

test("on a mask that hides all the pencil and the bucket show texels, the eraser hides them again, and nothing is cloned", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([demoFile("block-wide.glb")]);
  const { x, y } = await editor.middleOfStage();
  const bare = await editor.settledHash();
  const texels = () => editor.texels({ x: 0, y: 0, width: 64, height: 64 });
  const skin = await texels();
  await editor.addLayer(/^Fill/);
  await page.locator("tc-layer-list tc-menu.more button").first().click();
  await page.getByRole("menuitem", { name: "Add mask that hides all" }).click();
  expect(await editor.settledHash()).toBe(bare);

  /** Texels of the fill, of the skin, and of neither. */
  const counted = async () => {
    await editor.idle();
    const now = await texels();
    const counts = { filled: 0, skin: 0, mixed: 0 };
    for (let at = 0; at < now.length; at += 4) {
      if (now.readUInt32BE(at) === 0x7c86c4ff) counts.filled += 1;
      else if (now.readUInt32BE(at) === skin.readUInt32BE(at)) counts.skin += 1;
      else counts.mixed += 1;
    }
    return counts;
  };
  const masking = async () => (await editor.design()).layers.map(({ mask }) => mask?.layers.length);
  const line = [
    { x: x - 30, y },
    { x: x + 30, y },
  ] as const;
  await page.keyboard.press("n");
  await editor.drag(...line, 5);
  await expect.poll(masking).toEqual([2]);
  const pencilled = await editor.settledHash();
  const some = await counted();
  expect(some.filled).toBeGreaterThan(2);
  expect(some.mixed, "a texel is shown or hidden whole").toBe(0);

  await page.keyboard.press("g");
  await editor.setField("tool-tolerance", "24");
  await page.mouse.click(x, y + 40);
  await expect.poll(async () => (await counted()).filled).toBeGreaterThan(300);
  expect(await masking(), "what shows again is gathered").toEqual([2]);
  const bucketed = await editor.settledHash();

  await page.keyboard.press("e");
  await editor.drag(...line, 5);
  await expect.poll(masking).toEqual([3]);
  expect((await counted()).mixed).toBe(0);
  const erased = await editor.settledHash();
  expect(erased).not.toBe(bucketed);

  // In turn, each goes on in its layer.
  await page.keyboard.press("n");
  await editor.drag(...line, 5);
  await expect.poll(() => editor.settledHash(), "shown again").toBe(bucketed);
  await page.keyboard.press("e");
  await editor.drag(...line, 5);
  await expect.poll(() => editor.settledHash(), "hidden again").toBe(erased);
  expect(await masking()).toEqual([3]);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await expect.poll(() => editor.settledHash()).toBe(erased);

  await page.keyboard.press("s");
  await page.keyboard.down("Alt");
  await page.mouse.click(x, y + 30);
  await page.keyboard.up("Alt");
  await editor.drag(...line, 5);
  await expect(editor.notices).toContainText("The mask of Fill is marked");
  expect(await masking()).toEqual([3]);

  for (const hash of [bucketed, pencilled, bare]) {
    await page.keyboard.press("Control+z");
    await expect.poll(() => editor.settledHash()).toBe(hash);
  }
  for (const _step of "123") await page.keyboard.press("Control+Shift+z");
  await expect.poll(() => editor.settledHash()).toBe(erased);
  await page.evaluate(() => window.texelcast.kept());
  await editor.reload();
  expect(await editor.settledHash(), "it comes back as it was kept").toBe(erased);
});
