/** What a customer has typed is in what the page is given, though the field has not been left. */
import { expect, type Locator, type Page, test } from "@playwright/test";
import { renderPrint } from "../../node/print.ts";
import { demoFile } from "./support/test-files.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];

/** A text "A" on the mug, and its field open behind its letter. */
async function openTyping(page: Page, mode: string): Promise<Locator> {
  await page.goto(`element.html?loading=eager&locale=en&size=128&mode=${mode}`);
  const editor = page.locator("texelcast-editor");
  await editor.evaluate(async (element: Editor) => {
    await element.start();
    await element.addText("A");
  });
  await editor.getByRole("textbox", { name: "Words" }).focus();
  await page.keyboard.press("End");
  return editor;
}

for (const mode of ["shop", "full"]) {
  test(`what is typed in the ${mode} mode is in the design that a page asks for while its field is open`, async ({
    page,
  }) => {
    const editor = await openTyping(page, mode);
    await page.keyboard.type("da");
    const { design, sha256, steps } = await editor.evaluate(async (element: Editor) => {
      const asked = element.exportDesign();
      const { sha256 } = await element.exportTexture();
      let steps = 0;
      const { design } = await asked;
      while (element.undo()) steps++;
      return { design, sha256, steps };
    });
    expect(design.layers).toMatchObject([{ type: "text", text: "Ada", name: "Ada" }]);
    const model = new Uint8Array(demoFile("mug.glb").buffer);
    const printed = await renderPrint({ model, design, material: 0, size: 128 });
    expect(printed.sha256, "the picture is that of the design").toBe(sha256);
    expect(steps, "what was typed is a step, and asking is none").toBe(2);
  });
}

test("what is typed when the element begins anew is there afterwards", async ({ page }) => {
  const editor = await openTyping(page, "shop");
  await page.keyboard.type("da");
  await editor.evaluate(async (element: Editor) => await element.exportTexture());
  const texts = await editor.evaluate(async (element: Editor) => {
    await element.restart();
    const { design } = await element.exportDesign();
    return design.layers.map((layer) => layer.type === "text" && layer.text);
  });
  expect(texts).toEqual(["Ada"]);
});

test("letters that no font has are named beneath the words once they rest, where a product has no zones, too", async ({
  page,
}) => {
  const editor = await openTyping(page, "shop");
  await page.keyboard.type("日本");
  const told = editor.locator("[part=findings]");
  await expect(told).toContainText("No font has 日 本");
  await page.keyboard.press("Backspace");
  await page.keyboard.press("Backspace");
  await expect(told).toHaveCount(0);
});

const textsOf = (editor: Locator): Promise<unknown[]> =>
  editor.evaluate(async (element: Editor) => {
    const { design } = await element.exportDesign();
    return design.layers.map((layer) => layer.type === "text" && layer.text);
  });

for (const mode of ["shop", "full"]) {
  test(`what is typed in the ${mode} mode is told as a change once it rests, though its field is not left`, async ({
    page,
  }) => {
    const editor = await openTyping(page, mode);
    const listening = await editor.evaluateHandle((element: Editor) => ({
      told: new Promise((resolve) => {
        element.addEventListener("change", ({ detail: { design } }) => {
          const [layer] = design.layers;
          if (layer?.type === "text" && layer.text === "Ada") resolve(layer.text);
        });
      }),
    }));
    await page.keyboard.type("da");
    expect(await listening.evaluate(({ told }) => told)).toBe("Ada");
    await expect(editor.getByRole("textbox", { name: "Words" })).toBeFocused();
  });

  test(`a press on Undo takes back what is typed in the ${mode} mode and no more, and Redo brings it again`, async ({
    page,
  }) => {
    const editor = await openTyping(page, mode);
    await page.keyboard.type("da");
    await editor.getByRole("button", { name: /^Undo/ }).click();
    await expect.poll(() => textsOf(editor)).toEqual(["A"]);
    await editor.getByRole("button", { name: /^Redo/ }).click();
    await expect.poll(() => textsOf(editor)).toEqual(["Ada"]);
  });

  test(`Ctrl+Z behind the field takes back what is typed in the ${mode} mode and no more`, async ({ page }) => {
    const editor = await openTyping(page, mode);
    await page.keyboard.type("da");
    await page.keyboard.press("Tab");
    await page.keyboard.press("ControlOrMeta+z");
    await expect.poll(() => textsOf(editor)).toEqual(["A"]);
    expect(await editor.evaluate((element: Editor) => element.canRedo), "the browser's own undo would be no step").toBe(
      true,
    );
  });

  test(`a page's own undo takes back what is typed in the ${mode} mode and no more, and its redo brings it again`, async ({
    page,
  }) => {
    const editor = await openTyping(page, mode);
    await page.keyboard.type("da");
    await expect.poll(() => textsOf(editor)).toEqual(["Ada"]);
    expect(await editor.evaluate((element: Editor) => element.undo())).toBe(true);
    expect(await textsOf(editor)).toEqual(["A"]);
    expect(await editor.evaluate((element: Editor) => element.redo())).toBe(true);
    expect(await textsOf(editor)).toEqual(["Ada"]);
  });
}

test("a field that is left without words says again what is on the product", async ({ page }) => {
  const editor = await openTyping(page, "shop");
  const words = editor.getByRole("textbox", { name: "Words" });
  await page.keyboard.type("da");
  await expect.poll(() => textsOf(editor)).toEqual(["Ada"]);
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.press("Delete");
  await page.keyboard.press("Tab");
  await expect(words).toHaveValue("Ada");
  expect(await textsOf(editor)).toEqual(["Ada"]);
});

test("words and a font that cannot be fetched leave the field as the product is, and a message without addresses says what to do", async ({
  page,
}) => {
  const editor = await openTyping(page, "shop");
  await page.route(/NotoEmoji|Lobster/, (route) => route.fulfill({ status: 404 }));
  await editor.evaluate((element: Editor) =>
    element.addEventListener("error", ({ detail }) => Object.assign(window, { told: detail }), { once: true }),
  );
  const words = editor.getByRole("textbox", { name: "Words" });
  await page.keyboard.type("da");
  await page.keyboard.insertText("🦊");
  await expect(words).toHaveValue("Ada");
  const notice = editor.getByRole("alert");
  await expect(notice).toContainText("The font for this could not be loaded");
  await expect(notice).not.toContainText("http");
  expect(await page.evaluate(() => (window as { told?: object }).told)).toMatchObject({
    code: "missing-file",
    error: { reason: "not-loaded", subject: expect.stringMatching(/^http.*NotoEmoji/) },
  });
  await page.keyboard.type("s");
  await page.keyboard.press("Tab");
  await expect.poll(() => textsOf(editor)).toEqual(["Adas"]);

  const font = editor.getByRole("combobox", { name: "Font" });
  await font.selectOption({ label: "Lobster" });
  await expect(font).toHaveValue("inter-700");
  expect(await textsOf(editor)).toEqual(["Adas"]);
});

test("letters that are typed behind one whose font is slow and does not come stay", async ({ page }) => {
  const editor = await openTyping(page, "shop");
  let answer = (): void => undefined;
  const asked = new Promise<void>((resolve) => {
    answer = resolve;
  });
  await page.route(/NotoEmoji/, async (route) => {
    await asked;
    await route.fulfill({ status: 404 });
  });
  await page.keyboard.insertText("🦊");
  await page.keyboard.type("da");
  answer();
  await expect(editor.getByRole("alert")).toContainText("The font for this could not be loaded");
  await expect(editor.getByRole("textbox", { name: "Words" })).toHaveValue("Ada");
  expect(await textsOf(editor)).toEqual(["Ada"]);
});

test("whoever types while a picture is on its way goes on typing when it comes, and loses no letter", async ({
  page,
}) => {
  const editor = await openTyping(page, "shop");
  const coming = await editor.evaluateHandle((element: Editor) => {
    let added: Promise<string> | undefined;
    const asked = new Promise<() => void>((resolve) => {
      element.beforeAccept = () => new Promise((accept) => resolve(() => accept(true)));
      added = element.addDecal("demo/decals/smiley.png");
    });
    return { asked, added };
  });
  await page.keyboard.type("d");
  await coming.evaluate(async ({ asked, added }) => {
    (await asked)();
    await added;
  });
  await page.keyboard.type("a");
  await expect(editor.getByRole("textbox", { name: "Words" })).toBeFocused();
  const layers = await editor.evaluate(async (element: Editor) => (await element.exportDesign()).design.layers);
  expect(layers).toMatchObject([{ type: "text", text: "Ada" }, { type: "decal" }]);
});
