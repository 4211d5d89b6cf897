/** Whoever works in the shop's element by keys keeps the keyboard in it, whatever a key takes away. */
import { expect, type Locator, type Page, test } from "@playwright/test";
import { parseDesign } from "../../web/editor/document/index.ts";
import { file } from "./support/test-files.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];

async function openWithText(page: Page): Promise<Locator> {
  await page.goto("element.html?loading=eager&size=64&locale=en");
  const editor = page.locator("texelcast-editor");
  await editor.evaluate((element: Editor) => element.addText("A"));
  await expect(editor.getByRole("textbox", { name: "Words" })).toBeVisible();
  return editor;
}

const ROW = ".choose";
const COLOR = "input[type=color]";
for (const [key, where, selector] of [
  ["Delete", "on the row of what is chosen", ROW],
  ["Control+z", "on the row of what was just added", ROW],
  ["Escape", "on a field of what is chosen", COLOR],
] as const) {
  test(`${key} ${where} leaves the keyboard in the view`, async ({ page }) => {
    const editor = await openWithText(page);
    await editor.locator(selector).focus();
    await page.keyboard.press(key);
    await expect(editor.locator(COLOR)).toHaveCount(0);
    await expect(editor.getByRole("application")).toBeFocused();
  });
}

test("on a keyboard with Cyrillic letters undo and redo have the keys that they have on a Latin one", async ({
  page,
}) => {
  const editor = await openWithText(page);
  const rows = editor.locator(ROW);
  const count = await rows.count();
  const press = (key: string, shiftKey: boolean) =>
    editor
      .getByRole("application")
      .dispatchEvent("keydown", { key, code: "KeyZ", ctrlKey: true, shiftKey, bubbles: true, composed: true });
  await press("я", false);
  await expect(rows).toHaveCount(count - 1);
  await press("Я", true);
  await expect(rows).toHaveCount(count);
});

for (const [key, side] of [
  ["-", 2e-9],
  ["+", 5e8],
] as const) {
  test(`words in a shop are no larger or smaller than a design may have them, however long ${key} is held`, async ({
    page,
  }) => {
    const editor = await openWithText(page);
    const design = await editor.evaluate(
      async (element: Editor, given) => {
        const exported = await element.exportDesign();
        const [layer] = exported.design.layers;
        if (layer?.type === "text") Object.assign(layer.projector, { size: given.size });
        element.design = exported;
        await element.exportDesign();
        element.select(layer?.id ?? "");
        const view = element.shadowRoot?.querySelector("[role=application]");
        for (let step = 0; step < 100; step += 1)
          view?.dispatchEvent(new KeyboardEvent("keydown", { key: given.key, bubbles: true, composed: true }));
        return (await element.exportDesign()).design;
      },
      { key, size: [side, side, 0.03] },
    );
    const [layer] = parseDesign(JSON.stringify(design), "exported.json").layers;
    const reached = layer?.type === "text" && layer.projector.kind === "planar" ? layer.projector.size[0] : side;
    expect(Math.abs(Math.log(reached / side))).toBeGreaterThan(0.6);
  });
}

test("a message that is sent away by a key leaves the keyboard in the view", async ({ page }) => {
  const editor = await openWithText(page);
  const chooser = page.waitForEvent("filechooser");
  await editor.getByRole("button", { name: "Add picture" }).click();
  await (await chooser).setFiles(file("cat.png", "no picture"));
  await editor.getByRole("button", { name: "Close" }).press("Enter");
  await expect(editor.getByRole("alert")).toHaveCount(0);
  await expect(editor.getByRole("application")).toBeFocused();
});

test("whoever begins by a key, and once more where the product did not come, is in the view when it is shown", async ({
  page,
}) => {
  await page.route("**/mug.glb", (route) => route.fulfill({ status: 404 }), { times: 1 });
  await page.goto("element.html?loading=lazy&size=64&locale=en");
  const editor = page.locator("texelcast-editor");
  await editor.getByRole("button", { name: "Personalise" }).press("Enter");
  const retry = editor.getByRole("button", { name: "Try again" });
  await expect(editor.getByRole("alert")).not.toContainText(/:\/\/|HTTP/);
  await retry.press("Enter");
  await expect(editor.getByRole("application")).toBeFocused({ timeout: 60_000 });
});
