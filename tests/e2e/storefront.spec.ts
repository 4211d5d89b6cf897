/** The example shop as its customers use it: what they approve is what arrives at the press, to the byte. */
import { readFileSync } from "node:fs";
import type { Locator, Page } from "@playwright/test";
import { paintPng } from "../support/png-file.ts";
import { expect, type ShopPage, sha256, test } from "./support/shop.ts";

/** Words that would run if anybody took them for markup. */
const WORDS = "<img src=x onerror=alert(1)>";
const CUSTOMER = '<b onclick="alert(1)">Ada</b>';
/** So few pixels that they are seen on a mug. */
const LOGO = Buffer.from(paintPng(48, 48, (x, y) => [200, 5 * x, 5 * y, 255]));

async function order(page: Page, press: () => Promise<void>): Promise<void> {
  await page.getByLabel("Your name").fill(CUSTOMER);
  await press();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText(`Thank you, ${CUSTOMER}.`);
}

/** The order is ready, both hashes are one, and so is that of the file that is downloaded. */
async function expectPrinted(page: Page, press: () => Promise<void>): Promise<void> {
  await expect(page.locator("[data-status=ready]")).toBeVisible({ timeout: 60_000 });
  const approved = await page.locator("[data-hash=approved]").textContent();
  expect(approved).toMatch(/^[0-9a-f]{64}$/);
  await expect(page.locator("[data-hash=printed]")).toHaveText(String(approved));
  await expect(page.getByText("The same file, to the byte")).toBeVisible();
  const [download] = await Promise.all([page.waitForEvent("download"), press()]);
  expect(sha256(readFileSync(await download.path()))).toBe(approved);
}

async function upload({ page, editor }: ShopPage, press: () => Promise<void>): Promise<void> {
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), press()]);
  await chooser.setFiles({ name: "logo.png", mimeType: "image/png", buffer: LOGO });
  await expect(editor.locator("[data-layer]")).toHaveCount(1);
}

/**
 * A mug with a logo and a name: personalised, warned about, kept, edited from the cart, ordered, and printed as approved.
 * @param press what is pressed in the editor, and the way into the cart
 * @param look at each page on the way
 */
async function buyMug(
  shop: ShopPage,
  press: (button: Locator) => Promise<void>,
  look = async (): Promise<void> => {},
): Promise<void> {
  const { page, editor } = shop;
  await page.getByRole("link", { name: "Stoneware mug" }).click();
  await shop.productShown();
  await upload(shop, () => press(editor.getByRole("button", { name: "Add picture" })));
  await press(editor.getByRole("button", { name: "Add text" }));
  await expect(editor.getByLabel("Words")).toBeFocused();
  await page.keyboard.insertText(WORDS);
  await page.keyboard.press("Tab");
  await expect(page.getByText("2 prints")).toBeVisible();
  await expect(page.getByRole("region", { name: "Before it is printed" })).toContainText("logo Only 31 DPI");
  await look();

  await press(page.getByRole("button", { name: "Add to cart" }));
  await expect(page.getByText("Tick “Print it as it is” first")).toBeVisible();
  await page.keyboard.press("Space");
  await page.getByRole("button", { name: "Add to cart" }).click();
  await page.waitForURL(/cart\.html/, { timeout: 60_000 });
  await expect(page.getByText("2 prints")).toBeVisible();
  await page.reload();
  const snapshot = page.getByRole("img", { name: "Stoneware mug with your design" });
  await expect(snapshot).toHaveJSProperty("naturalWidth", 480);
  const before = await snapshot.getAttribute("src");
  const price = await page.locator(".line-price").textContent();
  await look();

  await page.getByRole("link", { name: "Edit Stoneware mug" }).click();
  await shop.productShown();
  await expect(editor.locator("[data-layer]")).toHaveCount(2);
  await expect(page.locator(".sum dd"), "what is edited costs what it cost").toHaveText(String(price).trim());
  await editor.getByRole("button", { name: WORDS }).first().click();
  await editor.getByLabel("Words").fill("Ada L.");
  await editor.getByLabel("Words").press("Tab");
  await page.getByLabel("Print it as it is").check();
  await page.getByRole("button", { name: "Save to cart" }).click();
  await expect(snapshot).not.toHaveAttribute("src", String(before), { timeout: 60_000 });

  await order(page, () => page.getByRole("button", { name: "Place order" }).click());
  await expectPrinted(page, () => page.getByRole("link", { name: "Download the print file" }).click());
  await look();
}

test("a mug with a logo and a name goes through the cart, is edited there, ordered, and printed as approved", async ({
  shop,
}) => {
  const look = async (): Promise<void> => expect(await shop.obstacles()).toEqual([]);
  await look();
  await buyMug(shop, (button) => button.click(), look);
});

test("with the editor in an iframe of another origin the mug goes the same way, by keys into the frame and out of it", async ({
  shop,
}) => {
  await shop.frameEditors();
  await buyMug(shop, async (button) => {
    await shop.tabTo(button);
    await shop.page.keyboard.press("Enter");
  });
});

test("where the system forces its colours, the shop's buttons have an edge", async ({ shop: { page } }) => {
  await page.emulateMedia({ forcedColors: "active" });
  await page.getByRole("link", { name: "Stoneware mug" }).click();
  await expect(page.getByRole("button", { name: "Add to cart" })).toHaveCSS("border-top-style", "solid");
});

test.describe("on a touch screen", () => {
  test.use({ hasTouch: true, isMobile: true });

  test("the way back to all products is as high as a finger", async ({ shop: { page } }) => {
    await page.getByRole("link", { name: "Stoneware mug" }).click();
    const back = await page.getByRole("link", { name: "All products" }).boundingBox();
    expect(back?.height).toBeGreaterThanOrEqual(44);
  });
});

test("an edit of a text that still has the focus is in the price that goes into the cart", async ({ shop }) => {
  const { page, editor } = shop;
  await page.getByRole("link", { name: "Stoneware mug" }).click();
  await shop.productShown();
  // Whoever does not see where it begins is told.
  const designer = page.getByRole("group", { name: "Stoneware mug" });
  await expect(designer.getByRole("button", { name: "Add text" })).toBeVisible();
  await editor.getByRole("button", { name: "Add text" }).click();
  await expect(page.getByText("1 print", { exact: true })).toBeVisible();
  const before = await page.locator(".sum dd").textContent();
  await expect(editor.getByLabel("Words")).toBeFocused();
  await page.keyboard.insertText("A good deal more words");
  // The button takes the focus only as it is pressed. The server refuses a price that is not its own.
  await page.getByRole("button", { name: "Add to cart" }).click();
  await page.waitForURL(/cart\.html/, { timeout: 60_000 });
  await expect(page.locator(".line-price")).not.toHaveText(String(before));
});

test("a part of the editor that does not come is told without its address", async ({ shop }) => {
  const { page } = shop;
  await page.route(/\.wasm/, (route) => route.fulfill({ status: 404 }));
  await page.getByRole("link", { name: "Stoneware mug" }).click();
  await page.getByRole("button", { name: "Add to cart" }).click();
  const fault = page.locator(".fault");
  await expect(fault).toContainText("A part of the editor could not be fetched. Check the connection, and try again.");
  await expect(page.getByRole("alert").filter({ hasText: "://" })).toHaveCount(0);
  // The browser's own line on what was answered.
  expect(shop.alarms.splice(0).every((alarm) => alarm.includes("404"))).toBe(true);
});

test("a figure is personalised, ordered and its print file downloaded by keyboard alone", async ({ shop }) => {
  const { page, editor } = shop;
  const { keyboard } = page;
  const press = async (role: "button" | "link", name: string | RegExp, inside = false): Promise<void> => {
    await shop.tabTo((inside ? editor : page).getByRole(role, { name }).first());
    await keyboard.press("Enter");
  };
  await press("link", "Desk figure");
  await shop.productShown();
  await upload(shop, () => press("button", "Add picture", true));
  await press("button", "Add text", true);
  await expect(editor.getByLabel("Words")).toBeFocused();
  await keyboard.type("Seven");
  await keyboard.press("Tab");
  await expect(page.getByText("2 prints")).toBeVisible();
  await shop.tabTo(page.getByLabel("Print it as it is"));
  await keyboard.press("Space");
  await press("button", "Add to cart");
  await page.waitForURL(/cart\.html/, { timeout: 60_000 });
  await shop.tabTo(page.getByLabel("Your name"));
  await order(page, () => keyboard.press("Enter"));
  await expectPrinted(page, () => press("link", /Download the print file/));
});
