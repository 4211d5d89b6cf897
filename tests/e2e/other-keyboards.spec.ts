/** Keyboards that are not the tests' own: letters of another script, words that are composed, keys that are held. */
import type { Page } from "@playwright/test";
import { expect, test } from "./support/editor-page.ts";

const CTRL = 2;
const SHIFT = 8;

/** Presses a key as a layout has it: by what it types, and by its place. */
async function press(page: Page, key: string, code: string, modifiers = 0): Promise<void> {
  const session = await page.context().newCDPSession(page);
  const windowsVirtualKeyCode = code.startsWith("Key") ? code.charCodeAt(3) : 0;
  const typed = modifiers === 0 && key.length === 1 ? { text: key } : {};
  await session.send("Input.dispatchKeyEvent", {
    type: "keyDown",
    key,
    code,
    modifiers,
    windowsVirtualKeyCode,
    ...typed,
  });
  await session.send("Input.dispatchKeyEvent", { type: "keyUp", key, code, modifiers, windowsVirtualKeyCode });
  await session.detach();
}

test("on a keyboard with Cyrillic letters undo, redo, saving and tools have the keys that they have on a Latin one", async ({
  editor,
  page,
}) => {
  await editor.openOnLowest();
  const before = await editor.settledHash();
  const count = (await editor.design()).layers.length;
  await press(page, "в", "KeyD", CTRL);
  const layers = async () => (await editor.design()).layers.length;
  await expect.poll(layers).toBe(count + 1);
  await press(page, "я", "KeyZ", CTRL);
  await expect.poll(layers).toBe(count);
  expect(await editor.settledHash()).toBe(before);
  await press(page, "Я", "KeyZ", CTRL | SHIFT);
  await expect.poll(layers).toBe(count + 1);
  const saved = await editor.saved(() => press(page, "ы", "KeyS", CTRL));
  expect(saved.name).toMatch(/\.design\.json$/);
  await press(page, "и", "KeyB");
  await expect(page.locator("tc-tool-rail").getByRole("radio", { name: "Brush" })).toBeChecked();
  const stroked = (await editor.design()).layers;
  await press(page, "Ц", "KeyW", SHIFT);
  await press(page, "ч", "KeyX");
  expect((await editor.design()).layers).toEqual(stroked);
});

for (const [part, open] of [
  ["a layer's row", async (page: Page) => page.locator("tc-layer-list .row.primary .name").dblclick()],
  ["the properties", async (page: Page) => page.locator("tc-layer-properties #name").click()],
] as const) {
  test(`a name that is composed in ${part} is taken once it is whole`, async ({ editor, page }) => {
    const id = await editor.openOnLowest();
    const { name } = await editor.decal(id);
    await open(page);
    const session = await page.context().newCDPSession(page);
    await page.keyboard.press("Control+a");
    await session.send("Input.imeSetComposition", { text: "にほん", selectionStart: 3, selectionEnd: 3 });
    // Chooses among what the letters may mean: the field itself gets nothing of it.
    await press(page, "Enter", "Enter");
    expect((await editor.decal(id)).name).toBe(name);
    await session.send("Input.insertText", { text: "日本" });
    // Takes back what is composed, and not what was typed before.
    await session.send("Input.imeSetComposition", { text: "ご", selectionStart: 1, selectionEnd: 1 });
    await press(page, "Escape", "Escape");
    await session.send("Input.insertText", { text: "語" });
    await page.keyboard.press("Enter");
    expect((await editor.decal(id)).name).toBe("日本語");
  });
}

test("a design is saved once, however long its keys are held", async ({ editor, page }) => {
  await editor.open();
  let saved = 0;
  page.on("download", () => {
    saved += 1;
  });
  await editor.saved(async () => {
    await page.keyboard.down("Control");
    for (let times = 0; times < 5; times += 1) await page.keyboard.down("s");
    await page.keyboard.up("s");
    await page.keyboard.up("Control");
  });
  await editor.saved(() => page.keyboard.press("Control+s"));
  expect(saved).toBe(2);
});
