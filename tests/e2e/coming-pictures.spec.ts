/** What is done while a picture is still on its way: it was asked for before. */
import type { Page } from "@playwright/test";
import { type EditorPage, expect, test } from "./support/editor-page.ts";

const SVG = '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="40"><circle cx="20" cy="20" r="19"/></svg>';

/** Holds back the demo's pictures that are asked for from now on, until what is returned is called. */
async function holdDecals(page: Page): Promise<() => void> {
  let release: () => void = () => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route(/\/decals\//, async (route) => {
    await held;
    await route.continue();
  });
  return release;
}

const names = async (editor: EditorPage): Promise<string[]> => (await editor.design()).layers.map(({ name }) => name);

test("an undo while a picture is on its way takes that back, and not the step before it", async ({ editor, page }) => {
  await editor.openOnLowest();
  const before = await names(editor);
  await editor.action("duplicate").click();
  const duplicated = await names(editor);
  expect(duplicated).toHaveLength(before.length + 1);
  const release = await holdDecals(page);
  await page.locator("tc-decal-palette [data-decal=flower]").click();
  await page.keyboard.press("Control+z");
  release();
  await editor.idle();
  await expect.poll(() => names(editor)).toEqual(duplicated);
  await page.keyboard.press("Control+z");
  await expect.poll(() => names(editor)).toEqual(before);
});

test("an undo that follows a drop at once takes the dropped picture back", async ({ editor, page }) => {
  await editor.openOnLowest();
  await editor.action("duplicate").click();
  const duplicated = await names(editor);
  await page.evaluate(async (svg) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([svg], "disc.svg", { type: "image/svg+xml" }));
    const init = { dataTransfer, clientX: 240, clientY: 450, bubbles: true, cancelable: true, composed: true };
    document.elementFromPoint(240, 450)?.dispatchEvent(new DragEvent("drop", init));
    await new Promise((resolve) => setTimeout(resolve, 0));
    dispatchEvent(new KeyboardEvent("keydown", { key: "z", code: "KeyZ", ctrlKey: true }));
  }, SVG);
  await editor.idle();
  await expect.poll(() => names(editor)).toEqual(duplicated);
  await page.keyboard.press("Control+Shift+z");
  await expect.poll(() => names(editor)).toEqual([...duplicated, "disc"]);
});

test("a design that is saved while a picture is on its way holds it", async ({ editor, page }) => {
  await editor.open();
  const release = await holdDecals(page);
  await page.locator("tc-decal-palette [data-decal=flower]").click();
  const { bytes } = await editor.saved(async () => {
    await page.locator("#save-design").click();
    release();
  });
  const saved: { layers: { name: string }[] } = JSON.parse(bytes.toString());
  await editor.idle();
  expect(saved.layers.map(({ name }) => name)).toEqual(await names(editor));
  expect(saved.layers).toHaveLength(3);
});
