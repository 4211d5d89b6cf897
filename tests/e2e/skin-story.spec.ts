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
  await page.locator("#more-options").click();
  await page.locator("#tool-mirror").selectOption("x");
  await page.locator("#more-options").click();
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
