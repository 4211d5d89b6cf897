/**
 * A browser of March 2023, as phones have that get no newer one: what has come since (URL.canParse, AbortSignal.any, popovers,
 * light-dark()) is not there, and nothing that a customer or a designer does may need it.
 */
import { type Browser, chromium, expect, type Page, test } from "@playwright/test";
import { oldestChromiumLaunch } from "../../scripts/bootstrap/oldest-chromium.mjs";
import { manyLayersHash } from "../support/many-layers.ts";
import { hashManyLayersInPage, manyLayersInput } from "../support/many-layers-page.ts";
import { exportMugInPage, mugPrintHash } from "../support/mug-print.ts";

const launch = oldestChromiumLaunch();
test.skip(launch === null, "this Chromium is for Linux on x64");

type Element = HTMLElementTagNameMap["texelcast-editor"];

let browser: Browser;

test.beforeAll(async () => {
  browser = await chromium.launch(launch ?? {});
});

test.afterAll(async () => {
  await browser?.close();
});

/** A page, and what it writes to the console as an error, or throws and does not catch. */
async function openPage(address: string): Promise<{ page: Page; faults: string[] }> {
  const page = await browser.newPage({ baseURL: test.info().project.use.baseURL });
  const faults: string[] = [];
  page.on("console", (message) => {
    // That is news of the browser's own, which does not know them yet.
    if (message.type() === "error" && !message.text().includes("'popover' attribute")) faults.push(message.text());
  });
  page.on("pageerror", (error) => faults.push(error.stack ?? error.message));
  await page.goto(address);
  return { page, faults };
}

test("a shop's element takes a picture, words and a drag there, and prints the bytes that a server prints", async () => {
  const { page, faults } = await openPage("element.html?locale=en&size=256&loading=eager");
  expect(await page.evaluate(() => ["canParse" in URL, "any" in AbortSignal, "popover" in document.body])).toEqual([
    false,
    false,
    false,
  ]);
  await page.evaluate(async () => {
    const element = document.querySelector("texelcast-editor") as Element;
    element.select(await element.addDecal("demo/decals/smiley.png"));
  });
  await expect(page.locator("texelcast-editor").getByRole("button", { name: "Done" })).toBeVisible();
  const box = await page.locator("texelcast-editor .own.view").boundingBox();
  if (!box) throw new Error("The product is not shown.");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const before = await page.evaluate(() => document.querySelector<Element>("texelcast-editor")?.exportDesign());
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 40, y - 30, { steps: 5 });
  await page.mouse.up();
  await page.evaluate(async () => {
    await document.querySelector<Element>("texelcast-editor")?.addText("Moin שלום");
  });
  const exported = await page.evaluate(exportMugInPage);
  expect(exported.design.layers.map(({ type }) => type)).toEqual(["decal", "text"]);
  expect(exported.design.layers[0]).not.toEqual(before?.design.layers[0]);
  expect(exported.sha256).toBe(await mugPrintHash(exported));
  expect(faults).toEqual([]);
  await page.close();
});

test("the page opens, lays open its menus in their places, and paints many layers to the last byte there", async () => {
  const { page, faults } = await openPage("./?new");
  await page.waitForFunction(() => window.texelcast !== undefined);
  await page.evaluate(() => window.texelcast.ready.then(() => window.texelcast.idle()));
  const background = await page.locator("tc-top-bar").evaluate((bar) => getComputedStyle(bar).backgroundColor);
  expect(background).toBe("rgb(255, 255, 255)");

  const opener = page.locator("tc-top-bar .models button").first();
  await opener.click();
  const menu = page.getByRole("menuitem", { name: "Open model…" });
  await expect(menu).toBeVisible();
  const [above, below] = [await opener.boundingBox(), await menu.boundingBox()];
  expect(below?.y).toBeGreaterThan((above?.y ?? 0) + (above?.height ?? 0) - 1);
  await page.keyboard.press("Escape");
  await expect(menu).toBeHidden();

  await page.locator("tc-view-menu button").first().click();
  await expect(page.locator("#view-panel")).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(page.locator("#view-panel")).toBeHidden();

  expect(await page.evaluate(hashManyLayersInPage, manyLayersInput())).toBe(manyLayersHash);
  expect(faults).toEqual([]);
  await page.close();
});
