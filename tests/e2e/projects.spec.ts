/** Projects kept by the page itself: what is there after the tab was closed, in a second tab, and where the browser refuses. */
import { EditorPage, expect, test } from "./support/editor-page.ts";
import { squareGltf } from "./support/test-files.ts";

test("a tab closed without saving is back as it was when the page is opened again", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel(squareGltf());
  await editor.addDemoDecal("badge");
  await editor.setField("spin", "12.5");
  const before = await editor.settledHash();
  const design = await editor.design();
  await page.evaluate(() => window.texelcast.kept());
  const context = page.context();
  await page.close();

  const again = new EditorPage(await context.newPage());
  await again.open();
  await expect(again.page.locator("tc-top-bar .models")).toContainText("square.gltf");
  expect(await again.settledHash()).toBe(before);
  expect(await again.design()).toEqual(design);
  await expect(again.notices).toContainText("square is back as you left it");
});
