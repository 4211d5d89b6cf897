/** The whole way of a skin: from a template to a picture that the command line gives byte for byte. */
import { EditorPage, expect, test } from "./support/editor-page.ts";
import { rendered } from "./support/rendered.ts";

test("a skin made from a template outlives its closed tab, and the command line paints the same bytes", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openTemplate("block-wide");
  const blank = await editor.settledHash();

  // A mirrored brush on the chest.
  await page.keyboard.press("b");
  await page.locator("#tool-mirror").selectOption("x");
  const middle = await editor.middleOfStage();
  await editor.drag({ x: middle.x - 12, y: middle.y - 10 }, { x: middle.x - 40, y: middle.y + 25 }, 8);
  const brushed = await editor.settledHash();
  expect(brushed).not.toBe(blank);
  expect((await editor.design()).layers.at(-1)).toMatchObject({ type: "paint", strokes: [{ mirror: { axis: "x" } }] });

  // Words, then a logo.
  await page.keyboard.press("t");
  await page.mouse.click(middle.x, middle.y);
  await page.locator("tc-text-fields textarea").fill("Ada 7");
  await editor.idle();
  const written = await editor.settledHash();
  expect(written).not.toBe(brushed);
  await page.locator("tc-text-fields textarea").blur();
  await page.keyboard.press("v");
  await editor.addDemoDecal("badge");
  const finished = await editor.settledHash();
  expect(finished).not.toBe(written);

  await page.evaluate(() => window.texelcast.kept());
  const context = page.context();
  await page.close();
  const again = new EditorPage(await context.newPage());
  await again.open();
  expect(await again.settledHash()).toBe(finished);

  const picture = await again.exported("Texture as PNG");
  const project = await again.savedProject();
  expect(project.name).toMatch(/\.texelcast$/);
  expect(rendered(project).equals(picture.bytes)).toBe(true);
});

test("two hundred strokes and a hundred undos stay within the budgets of memory", async ({ editor, page }) => {
  test.setTimeout(240_000);
  await editor.open();
  await page.keyboard.press("b");
  const middle = await editor.middleOfStage();
  const hashes: string[] = [];
  for (let stroke = 0; stroke < 200; stroke += 1) {
    const angle = stroke * 2.4;
    const from = { x: middle.x - 60 + 40 * Math.cos(angle), y: middle.y + 60 * Math.sin(angle) };
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 9, from.y + 6);
    await page.mouse.move(from.x + 18, from.y + 2);
    await page.mouse.up();
    if (stroke % 100 === 99) hashes.push(await editor.settledHash());
  }
  const painted = (await editor.design()).layers.find(({ type }) => type === "paint");
  expect(painted?.type === "paint" && painted.strokes.length).toBe(200);
  for (let undo = 0; undo < 100; undo += 1) await page.keyboard.press("ControlOrMeta+z");
  expect(await editor.settledHash()).toBe(hashes[0]);
  const { memoryPeakBytes, memoryBudgetBytes } = await editor.stats();
  expect(memoryPeakBytes).toBeLessThanOrEqual(memoryBudgetBytes);
  for (let redo = 0; redo < 100; redo += 1) await page.keyboard.press("ControlOrMeta+Shift+z");
  expect(await editor.settledHash()).toBe(hashes[1]);
});
