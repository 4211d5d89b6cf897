import type { Page } from "@playwright/test";
import { avifFile } from "../support/avif-file.ts";
import { softPicture } from "../support/ktx2-file.ts";
import { type EditorPage, expect, type TestFile, test } from "./support/editor-page.ts";
import { file, ringPicture, squareGlb } from "./support/test-files.ts";

const names = async (editor: EditorPage): Promise<string[]> => (await editor.design()).layers.map(({ name }) => name);

/** As a program that puts files on the clipboard, and Ctrl+V after it. */
async function pasteFile(page: Page, { name, mimeType, buffer }: TestFile): Promise<void> {
  await page.evaluate(
    ({ name, mimeType, data }) => {
      const clipboardData = new DataTransfer();
      const bytes = Uint8Array.from(atob(data), (character) => character.charCodeAt(0));
      clipboardData.items.add(new File([bytes], name, { type: mimeType }));
      document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
    },
    { name, mimeType, data: buffer.toString("base64") },
  );
}

/** As a program that puts words on the clipboard; the page must have the permission. */
const putWords = (page: Page, words: string): Promise<void> =>
  page.evaluate((text) => navigator.clipboard.writeText(text), words);

test("layers are copied, cut and pasted, each in one step, and into another project too", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  await editor.addDemoDecal("badge");
  await editor.addDemoDecal("number");
  await editor.row("Travel badge").click();
  await page.keyboard.press("Control+c");
  await page.keyboard.press("Control+v");
  await expect(editor.row("Travel badge 2")).toBeFocused();
  expect(await names(editor)).toEqual(["Travel badge", "Travel badge 2", "Number 07"]);
  await page.keyboard.press("Control+z");
  await expect(editor.row("Travel badge 2")).toHaveCount(0);

  const start = await editor.settledHash();
  await editor.row("Number 07").click();
  await page.keyboard.press("Control+x");
  expect(await names(editor)).toEqual(["Travel badge"]);
  await page.keyboard.press("Control+v");
  await expect(editor.row("Number 07")).toHaveCount(1);
  expect(await editor.settledHash(), "back where it was").toBe(start);
  await expect(page.locator("#undo")).toHaveAttribute("aria-label", "Undo paste layer");

  await editor.row("Travel badge").click({ modifiers: ["Shift"] });
  await page.keyboard.press("Control+c");
  await page.locator("tc-top-bar .models button").first().click();
  await page.getByRole("menuitemradio", { name: "Mug" }).click();
  await editor.idle();
  const before = await names(editor);
  await page.keyboard.press("Control+v");
  await expect(editor.row("Travel badge")).toHaveCount(1);
  expect((await names(editor)).length).toBe(before.length + 2);
  expect(Object.keys((await editor.design()).assets), "its pictures came along").toHaveLength(4);
});

test("a picture on the clipboard becomes a decal, and what is none is refused as a dropped file is", async ({
  editor,
  page,
  context,
}) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await editor.open();
  await page.evaluate(async (data) => {
    const picture = await (await fetch(`data:image/png;base64,${data}`)).blob();
    await navigator.clipboard.write([new ClipboardItem({ "image/png": picture })]);
  }, ringPicture().buffer.toString("base64"));
  const before = (await names(editor)).length;
  await page.keyboard.press("Control+v");
  await expect(editor.row("Picture")).toHaveCount(1);
  expect(await names(editor)).toHaveLength(before + 1);
  await expect(page.locator("#undo")).toHaveAttribute("aria-label", "Undo add decal");

  await pasteFile(page, file("broken.png", ringPicture().buffer.subarray(0, 60), "image/png"));
  await expect(editor.notices).toContainText("Could not open broken.png");
  expect(await names(editor)).toHaveLength(before + 1);
  await pasteFile(page, file("photo.avif", await avifFile(softPicture(32, 32)), "image/avif"));
  await expect(editor.row("photo")).toHaveCount(1);
});

test("words on the clipboard become a text, in one step; blank ones, and those for a field, do not", async ({
  editor,
  page,
  context,
}) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await editor.open();
  const before = await names(editor);
  await putWords(page, "  \r\n ");
  await page.keyboard.press("Control+v");
  await putWords(page, "\r\nACME Coffee \r\nsince 1987\r\n\r\n");
  await page.keyboard.press("Control+v");
  await expect(editor.row("ACME Coffee")).toHaveCount(1);
  expect(await names(editor)).toEqual([...before, "ACME Coffee"]);
  expect((await editor.design()).layers.at(-1)).toMatchObject({ type: "text", text: "ACME Coffee\nsince 1987" });
  expect(await editor.selectedName()).toBe("ACME Coffee");
  await expect(page.locator("tc-text-fields textarea")).not.toBeFocused();
  await expect(page.locator("#undo")).toHaveAttribute("aria-label", "Undo add text");
  await page.keyboard.press("Control+v");
  await expect.poll(async () => (await names(editor)).length).toBe(before.length + 2);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await expect.poll(() => names(editor)).toEqual(before);
});

test("a drawing that was copied as its text is a picture on the model, also out of a web page, and one that is broken is told", async ({
  editor,
  page,
  context,
}) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await editor.open();
  const before = await names(editor);
  await putWords(page, '\n<svg viewBox="0 0 20 10"><rect width="20" height="10" fill="#c2410c"/></svg>\n');
  await page.keyboard.press("Control+v");
  await expect(editor.row("Picture")).toHaveCount(1);
  expect((await editor.design()).layers.at(-1)).toMatchObject({ type: "decal", name: "Picture" });
  await expect(page.locator("#undo")).toHaveAttribute("aria-label", "Undo add decal");
  await putWords(page, "<svg><rect</svg>");
  await page.keyboard.press("Control+v");
  await expect(editor.notices).toContainText("Could not open Picture.svg");
  expect(await names(editor)).toEqual([...before, "Picture"]);
});

test("a text field keeps its own copy and paste, and marked words theirs", async ({ editor, page }) => {
  await editor.open();
  await editor.row("Texelcast mark").click();
  const name = page.locator("tc-layer-properties #name");
  const before = await names(editor);
  await name.click();
  await page.keyboard.press("Control+a");
  await page.keyboard.press("Control+c");
  await page.keyboard.press("End");
  await page.keyboard.press("Control+v");
  await expect(name).toHaveValue("Texelcast markTexelcast mark");
  await page.keyboard.press("Escape");
  expect(await names(editor)).toEqual(before);
});

test("layers are copied and pasted by the list's menus, whatever words are marked on the page", async ({
  editor,
  page,
}) => {
  await editor.open();
  const more = page.locator("tc-layer-list .more button").first();
  const item = (name: string) => page.getByRole("menuitem", { name, exact: true });
  await editor.row("Texelcast mark").click();
  await more.click();
  await expect(item("Paste")).toBeDisabled();
  await page.keyboard.press("Escape");
  // A press on the status line marks words of it, which Ctrl+C would take.
  await page.evaluate(() => {
    const words = document.createElement("p");
    words.textContent = "Marked";
    document.body.append(words);
    getSelection()?.selectAllChildren(words);
  });
  await editor.row("Texelcast mark").click({ button: "right" });
  await item("Copy").click();
  await editor.row("Texelcast mark").click({ button: "right" });
  await item("Paste").click();
  await expect(editor.row("Texelcast mark 2")).toHaveCount(1);
  await expect(page.locator("#undo")).toHaveAttribute("aria-label", "Undo paste layer");
  await editor.row("Smiley").click();
  await page.keyboard.press("Control+v");
  await expect(editor.row("Texelcast mark 3"), "the clipboard has them, too").toHaveCount(1);
  expect(await names(editor)).toEqual(["Texelcast mark", "Texelcast mark 2", "Smiley", "Texelcast mark 3"]);

  // By Ctrl+C the menu has them as well.
  await editor.row("Smiley").click();
  await page.keyboard.press("Control+c");
  await more.click();
  await item("Paste").click();
  await expect(editor.row("Smiley 2")).toHaveCount(1);
});
