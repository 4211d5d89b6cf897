/** The example shop's pages where the line fails for a moment, somebody else answers, or the browser lets them keep nothing. */
import type { Page } from "@playwright/test";
import { paintPng } from "../support/png-file.ts";
import { expect, type ShopPage, test } from "./support/shop.ts";

const LOGO = Buffer.from(paintPng(48, 48, (x, y) => [200, 5 * x, 5 * y, 255]));
const UNREACHED = "The shop cannot be reached. Check the connection, and try again. Your design stays as it is.";
/** What the wireless network of a hotel answers to everything, until somebody has signed in. */
const PORTAL = { contentType: "text/html", body: "<!doctype html><title>Sign in</title>" };
/** What a gateway between answers in JSON of its own. */
const GATEWAY = { error: "Service Unavailable", statusCode: 503 };

/** Browsers write each answer that is none into their console. */
const forgetTheLine = (shop: ShopPage): void => {
  const heard = shop.alarms.splice(0);
  expect(heard.filter((alarm) => !alarm.startsWith("Failed to load resource"))).toEqual([]);
};

/** As browsers do that are told to keep nothing of any page. */
const keepNothing = (page: Page) =>
  page.addInitScript(() => {
    for (const name of ["localStorage", "sessionStorage"]) {
      Object.defineProperty(window, name, {
        get: () => {
          throw new DOMException(`Failed to read the '${name}' property from 'Window'`, "SecurityError");
        },
      });
    }
  });

async function putLogoOn(shop: ShopPage): Promise<void> {
  const { page, editor } = shop;
  await shop.productShown();
  const chosen = page.waitForEvent("filechooser");
  await editor.getByRole("button", { name: "Add picture" }).click();
  await (await chosen).setFiles({ name: "logo.png", mimeType: "image/png", buffer: LOGO });
  await expect(page.getByText("1 print", { exact: true })).toBeVisible();
  await page.getByLabel("Print it as it is").check();
}

test("an order that is shown stays where the server does not answer for a while, and is asked for again", async ({
  shop,
}) => {
  const { page } = shop;
  const line = {
    ...{
      id: "l",
      product: "mug",
      productName: "Stoneware mug",
      design: {},
      decals: 1,
      area: 1,
      unitPrice: 2550,
      quantity: 1,
    },
    ...{
      approved: { sha256: "a".repeat(64), width: 64, height: 64 },
      snapshot: "b".repeat(64),
      printed: null,
      fault: null,
    },
  };
  const order = { id: "o", number: 7, name: "Ada", created: "2026-11-30T12:00:00Z", currency: "EUR", total: 2550 };
  let asked = 0;
  await page.route("**/api/files/**", (route) => route.fulfill({ contentType: "image/png", body: LOGO }));
  await page.route("**/api/orders/o", (route) => {
    asked += 1;
    if (asked === 2) return route.abort();
    if (asked === 3) return route.fulfill({ status: 502, ...PORTAL });
    if (asked === 4) return route.fulfill(PORTAL);
    if (asked === 5) return route.fulfill({ status: 503, json: GATEWAY });
    const status = asked < 9 ? "waiting" : "ready";
    const printed = status === "ready" ? { ...line.approved, bytes: 100 } : null;
    return route.fulfill({ json: { ...order, lines: [{ ...line, status, printed }] } });
  });
  await page.goto(`${page.url()}order.html?order=o`);
  const thanks = page.getByRole("heading", { level: 1 });
  await expect(thanks).toHaveText("Thank you, Ada.");
  await expect(page.locator(".fault")).toContainText(UNREACHED);
  await expect(thanks).toHaveText("Thank you, Ada.");
  await expect(page.locator(".fault")).toHaveCount(0);
  await expect(page.locator("[data-status=ready]")).toBeVisible();
  forgetTheLine(shop);
});

test("where somebody else answers in the shop's place, or an answer breaks off, that is told in the shop's own words", async ({
  shop,
}) => {
  const { page } = shop;
  await page.route("**/api/products", (route) => route.fulfill(PORTAL));
  await page.reload();
  await expect(page.locator(".fault")).toContainText(UNREACHED);
  await page.unroute("**/api/products");
  await page.reload();
  await page.getByRole("link", { name: "Stoneware mug" }).click();
  await putLogoOn(shop);
  await page.route("**/api/files/*", (route) => route.fulfill(PORTAL));
  await page.getByRole("button", { name: "Add to cart" }).click();
  await expect(page.locator(".fault")).toContainText(UNREACHED);
  // Nothing of it is lost: it goes the same way when the line is back.
  await page.unroute("**/api/files/*");
  await page.getByRole("button", { name: "Add to cart" }).click();
  await page.waitForURL(/cart\.html/, { timeout: 60_000 });
  await expect(page.getByText("1 print")).toBeVisible();
  // The order is made, and its answer does not arrive.
  await page.route("**/order", async (route) => {
    await route.fetch();
    await route.abort();
  });
  await page.getByLabel("Your name").fill("Ada");
  await page.getByRole("button", { name: "Place order" }).click();
  await expect(page.locator(".fault")).toContainText(UNREACHED);
  await page.unroute("**/order");
  await page.getByRole("button", { name: "Place order" }).click();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Thank you, Ada.");
  await expect(page.locator("[data-status=ready]")).toBeVisible({ timeout: 60_000 });
  forgetTheLine(shop);
});

test("a browser that keeps nothing shows the products and their editor, and says at the cart what to allow", async ({
  shop,
}) => {
  const { page } = shop;
  await keepNothing(page);
  await page.reload();
  await page.getByRole("link", { name: "Stoneware mug" }).click();
  await putLogoOn(shop);
  await expect(page.locator(".fault")).toHaveCount(0);
  await page.getByRole("button", { name: "Add to cart" }).click();
  await expect(page.locator(".fault")).toContainText("This browser lets the shop keep no cart.");
  await expect(shop.editor.locator("[data-layer]")).toHaveCount(1);
  await page.goto(new URL("cart.html", page.url()).href);
  await expect(page.getByText("Your cart is empty", { exact: false })).toBeVisible();
  await expect(page.locator(".fault")).toHaveCount(0);
});
