import { type EditorPage, expect, test } from "./support/editor-page.ts";
import { readPng } from "./support/read-png.ts";
import { squareGlb } from "./support/test-files.ts";

/** What the page shows there, red, green and blue. */
async function seenAt(editor: EditorPage, x: number, y: number): Promise<number[]> {
  const { rgba } = readPng(await editor.page.screenshot({ clip: { x, y, width: 1, height: 1 } }));
  return [...rgba.subarray(0, 3)];
}

async function zoomIn(editor: EditorPage): Promise<void> {
  const box = await editor.view.boundingBox();
  if (!box) throw new Error("The view has no place.");
  await editor.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  for (let step = 0; step < 4; step += 1) await editor.page.mouse.wheel(0, -240);
  await editor.settledHash();
  await editor.page.mouse.move(0, 0);
}

for (const [kind, viewport] of [
  ["a desktop", { width: 1280, height: 800 }],
  ["a phone", { width: 390, height: 844 }],
  ["a phone on its side", { width: 844, height: 390 }],
] as const) {
  test.describe(`on ${kind}`, () => {
    // The view is where it goes at once.
    test.use({ viewport, contextOptions: { reducedMotion: "reduce" } });

    test("a model that is zoomed in goes on under the tools, and is painted where it is pressed between them", async ({
      editor,
      page,
    }) => {
      await editor.open();
      await editor.openModel([squareGlb()]);
      await page.keyboard.press("b");
      await expect(page.getByRole("radio", { name: "Brush" })).toBeChecked();
      const [stage, view, rail] = await editor.places(editor.stage, editor.view, page.locator("tc-tool-rail"));
      // Beside the view, and beside the tools: their rail stands in the middle of its strip.
      const at =
        kind === "a phone"
          ? { x: stage.x + 6, y: rail.y + rail.height / 2 }
          : { x: stage.x + 3, y: view.y + view.height / 2 };
      expect(at.x < view.x || at.y > view.y + view.height, "the place is not in the view").toBe(true);
      const ground = await seenAt(editor, at.x, at.y);
      await zoomIn(editor);
      const bare = await seenAt(editor, at.x, at.y);
      expect(bare, "the model is there").not.toEqual(ground);
      const hash = await editor.settledHash();
      await page.mouse.click(at.x, at.y);
      expect(await editor.settledHash()).not.toBe(hash);
      await page.mouse.move(0, 0);
      await expect
        .poll(() => seenAt(editor, at.x, at.y), "what was painted is seen under the pointer")
        .not.toEqual(bare);
    });
  });
}
