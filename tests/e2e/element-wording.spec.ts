/** `<texelcast-editor>` in words of the shop's own. */
import { readFileSync } from "node:fs";
import { expect, type Page, test } from "@playwright/test";

const french: unknown = JSON.parse(readFileSync("web/element/wording/fr.json", "utf8"));

const say = (page: Page, wording: unknown): Promise<void> =>
  page.evaluate((words) => {
    const editor = document.querySelector("texelcast-editor");
    if (editor) editor.wording = words as typeof editor.wording;
  }, wording);

test("the shop's words are seen and heard, also those that come while the product is shown, and can be taken back", async ({
  page,
}) => {
  await page.goto("element.html");
  const editor = page.locator("texelcast-editor");
  await expect(editor.getByRole("button", { name: "Add picture" })).toBeVisible();
  await say(page, { ...(french as object), submit: "Ajouter au panier" });
  await expect(editor.getByRole("button", { name: "Ajouter image" })).toBeVisible();
  await expect(editor.getByRole("button", { name: "Ajouter au panier" })).toBeVisible();
  await expect(editor.locator("[lang=fr]").first()).toBeAttached();

  await editor.getByRole("button", { name: "Ajouter texte" }).click();
  await expect(editor.getByRole("button", { name: "Supprimer Votre texte" })).toBeVisible();
  await expect(editor.getByLabel("Largeur")).toBeVisible();
  const refused = await page.evaluate(async () => {
    const element = document.querySelector("texelcast-editor");
    const error = await element?.addDecal(new Blob(["%PDF-1.7"])).catch((thrown: unknown) => thrown);
    return (error as Error | undefined)?.message;
  });
  expect(refused).toMatch(/est un PDF/);

  await say(page, null);
  await expect(editor.getByRole("button", { name: "Delete Votre texte" })).toBeVisible();
  await expect(editor.getByRole("button", { name: "Done" })).toBeVisible();
});

test("words of a language that runs from the right do so, in a page that runs from the left as well", async ({
  page,
}) => {
  await page.goto("element.html?loading=eager");
  await page.evaluate(() => document.querySelector("texelcast-editor")?.start());
  await say(page, { lang: "he", addText: "הוסף טקסט" });
  const editor = page.locator("texelcast-editor");
  await editor.getByRole("button", { name: "הוסף טקסט" }).click();
  await expect(editor.locator("select")).toBeVisible();
  for (const part of [".add", ".foot", ".row .quiet"])
    await expect(editor.locator(part).first()).toHaveCSS("direction", "rtl");
  await expect(editor.locator("select"), "names of fonts are Latin").toHaveCSS("direction", "ltr");
  await say(page, { lang: "en" });
  await expect(editor.locator(".add")).toHaveCSS("direction", "ltr");
});

test("words at an address are fetched, and the newest wish stays, whichever comes first", async ({ page }) => {
  let answer = (): void => undefined;
  const late = new Promise<void>((resolve) => {
    answer = resolve;
  });
  await page.route("**/late.json", async (route) => {
    await late;
    await route.fulfill({ json: { submit: "Too late" } });
  });
  await page.route("**/own.json", (route) => route.fulfill({ json: { submit: "Into the cart", sumbit: "x" } }));
  await page.goto("element.html");
  await page.evaluate(() => {
    const editor = document.querySelector("texelcast-editor");
    const heard: string[] = [];
    Object.assign(window, { heard });
    editor?.addEventListener("error", (event) => heard.push(`${event.detail.code} ${event.detail.error.field}`));
  });
  const editor = page.locator("texelcast-editor");
  await editor.evaluate((element) => element.setAttribute("wording", "late.json"));
  await editor.evaluate((element) => element.setAttribute("wording", "own.json"));
  await expect(editor.getByRole("button", { name: "Into the cart" })).toBeVisible();
  answer();
  await page.waitForResponse("**/late.json");
  await expect(editor.getByRole("button", { name: "Into the cart" })).toBeVisible();
  expect(await page.evaluate(() => (window as unknown as { heard: string[] }).heard)).toEqual([
    "bad-argument wording.sumbit",
  ]);
});
