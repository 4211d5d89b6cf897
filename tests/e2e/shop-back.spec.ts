/** Pages of the example shop that the browser keeps while another one is shown, and gives back as they were. */
import { chromium } from "@playwright/test";
import { chromiumLaunch } from "../../scripts/bootstrap/chromium.mjs";
import { test as base, expect } from "./support/shop.ts";

const test = base.extend({
  // biome-ignore lint/correctness/noEmptyPattern: Playwright asks for a pattern.
  page: async ({}, use) => {
    // Playwright's own browsers are begun without that cache.
    const browser = await chromium.launch({ ...chromiumLaunch(), ignoreDefaultArgs: ["--disable-back-forward-cache"] });
    const page = await browser.newPage();
    await page.addInitScript(() => {
      addEventListener("pageshow", ({ persisted }) => document.documentElement.toggleAttribute("data-kept", persisted));
    });
    await use(page);
    await browser.close();
  },
});

test("whoever comes back from the cart, or from an order, finds the page ready for the next one", async ({ shop }) => {
  const { page, editor } = shop;
  const back = async (): Promise<void> => {
    // What is given back is not loaded.
    await page.goBack({ waitUntil: "commit" });
    await expect(page.locator("html")).toHaveAttribute("data-kept");
  };
  const cart = page.locator(".cart-link");
  await page.getByRole("link", { name: "Stoneware mug" }).click();
  await shop.productShown();
  await editor.evaluate((element) => (element as HTMLElementTagNameMap["texelcast-editor"]).addText("Ada"));
  const intoCart = page.getByRole("button", { name: "Add to cart" });
  await intoCart.click();
  await page.waitForURL(/cart\.html/, { timeout: 60_000 });
  await back();
  await expect(intoCart).toHaveAttribute("aria-disabled", "false");
  await expect(page.getByText("Putting it into the cart …")).toHaveCount(0);
  await expect(cart).toHaveAccessibleName("Cart, 1 piece");
  await intoCart.click();
  await page.waitForURL(/cart\.html/, { timeout: 60_000 });
  await expect(page.locator(".line")).toHaveCount(2);

  await page.getByLabel("Your name").fill("Ada");
  await page.getByRole("button", { name: "Place order" }).click();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Thank you, Ada.");
  await back();
  await expect(page.getByText("Your cart is empty.")).toBeVisible();
  await expect(cart).toHaveAccessibleName("Cart, empty");
});
