/** Pictures that a customer chooses in the shop's mode: those that cannot be used, and those that take their time. */
import { expect, type Page, test } from "@playwright/test";
import { demoFile, file } from "./support/test-files.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];

/** The element's page with its product shown; codes of the errors that it tells are kept in `window.codes`. */
async function openShop(page: Page): Promise<void> {
  await page.goto("element.html");
  await page.locator("texelcast-editor").evaluate(async (element: Editor) => {
    const codes: string[] = [];
    Object.assign(window, { codes });
    element.addEventListener("error", ({ detail }) => codes.push(detail.code));
    await element.start();
  });
}

async function choose(page: Page, files: readonly ReturnType<typeof file>[]): Promise<void> {
  const chooser = page.waitForEvent("filechooser");
  await page.locator("texelcast-editor").getByRole("button", { name: "Add picture" }).click();
  await (await chooser).setFiles([...files]);
}

test("of several pictures that are chosen together, those that cannot be used keep none of the others away", async ({
  page,
}) => {
  await openShop(page);
  const [first, last] = [file("first.gif", "GIF89a"), file("last.pdf", "%PDF-1.7")];
  await choose(page, [first, demoFile("decals/badge.png"), last, demoFile("decals/flower.png")]);
  await expect(page.locator("texelcast-editor").locator("[part=row]")).toHaveText([/flower/, /badge/]);
  expect(await page.evaluate(() => (window as unknown as { codes: string[] }).codes)).toEqual([
    "bad-picture",
    "bad-picture",
  ]);
});

test("until a chosen picture is on the product or refused, the panel says that it is coming", async ({ page }) => {
  await openShop(page);
  const editor = page.locator("texelcast-editor");
  const coming = editor.getByText("Preparing…");
  for (const isAccepted of [true, false]) {
    await editor.evaluate((element: Editor) => {
      element.beforeAccept = () => new Promise((resolve) => Object.assign(window, { answer: resolve }));
    });
    await choose(page, [demoFile("decals/badge.png")]);
    await expect(coming).toBeVisible();
    await page.waitForFunction(() => "answer" in window);
    await page.evaluate((answer) => {
      const { window: page } = globalThis as unknown as { window: { answer?: (accepted: boolean) => void } };
      page.answer?.(answer);
      delete page.answer;
    }, isAccepted);
    await expect(coming).toHaveCount(0);
    await expect(editor.locator("[part=row]")).toHaveCount(1);
  }
});
