/** The example shop for a browser: its built pages, its real order server, and what must never happen on them. */
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { test as base, expect, type Locator, type Page } from "@playwright/test";
import { createEditorServer, originOf, type ShopOrigins } from "../../../node/storefront/editor-server.ts";
import { createShopServer } from "../../../node/storefront/shop-server.ts";
import { seriousFaults, smallTargets } from "./page-faults.ts";

export { expect } from "@playwright/test";

const SITE = fileURLToPath(new URL("../../../build/storefront", import.meta.url));
const PRESS = new URL("../../../build/node/storefront-press.mjs", import.meta.url);
const AXE = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
/** Pixels that a finger needs. */
const TARGET = 24;

export const sha256 = (bytes: Uint8Array): string => createHash("sha256").update(bytes).digest("hex");

export class ShopPage {
  readonly page: Page;
  /** In the page itself, or in the iframe there. */
  editor: Locator;
  /** Dialogs, requests to elsewhere, refusals of the content security policy, errors of the page. */
  readonly alarms: string[] = [];

  constructor(page: Page, origins: ShopOrigins) {
    const own = [origins.shop, origins.editor];
    this.page = page;
    this.editor = page.locator("texelcast-editor");
    page.on("dialog", (dialog) => {
      if (dialog.type() !== "beforeunload") this.alarms.push(`dialog: ${dialog.message()}`);
      void dialog.accept();
    });
    page.on("request", (request) => {
      const url = new URL(request.url());
      if (!/^(data|blob):/.test(url.protocol) && !own.includes(url.origin)) this.alarms.push(url.href);
    });
    page.on("pageerror", (error) => this.alarms.push(String(error)));
    page.on("console", (message) => {
      if (message.type() === "error") this.alarms.push(message.text());
    });
  }

  /** From here on the editors are in an iframe of another origin. */
  async frameEditors(): Promise<void> {
    await this.page.goto(`${this.page.url()}product.html?editor=iframe`);
    await this.page.goBack();
    this.editor = this.page.frameLocator("iframe").locator("texelcast-editor");
  }

  /** Waits until the product can be worked on. */
  async productShown(): Promise<void> {
    await expect
      .poll(() => this.editor.evaluate((element) => "loaded" in element && element.loaded), { timeout: 60_000 })
      .toBe(true);
  }

  /** What would keep someone from using the page as it stands: axe's serious faults, and what is too small to press. */
  async obstacles(): Promise<string[]> {
    // A colour on its way from light to dark is neither.
    await this.page.emulateMedia({ reducedMotion: "reduce" });
    // As a developer's tool and not as a script of the page, which its policy would refuse.
    await this.page.evaluate(readFileSync(AXE, "utf8"));
    return [...(await seriousFaults(this.page)), ...(await smallTargets(this.page, TARGET))];
  }

  /** Presses Tab until that has the focus. */
  async tabTo(target: Locator): Promise<void> {
    await expect(target).toBeVisible({ timeout: 60_000 });
    for (let presses = 0; presses < 80; presses++) {
      if (await target.evaluate((element) => element.matches(":focus"))) return;
      await this.page.keyboard.press("Tab");
    }
    throw new Error(`Tab did not come to ${target}`);
  }
}

export const test = base.extend<{ shop: ShopPage }, { origins: ShopOrigins }>({
  origins: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright asks for a pattern.
    async ({}, use) => {
      const folder = mkdtempSync(path.join(tmpdir(), "texelcast-shop-"));
      const origins: ShopOrigins = { shop: null, editor: null };
      const { app } = await createShopServer({
        site: SITE,
        store: path.join(folder, "files"),
        database: path.join(folder, "shop.sqlite"),
        origins,
        press: { script: PRESS },
      });
      const editor = await createEditorServer(SITE, origins);
      for (const server of [app, editor]) await server.listen({ port: 0, host: "localhost" });
      origins.shop = originOf(app, "localhost");
      origins.editor = originOf(editor, "localhost");
      await use(origins);
      for (const server of [app, editor]) await server.close();
      rmSync(folder, { recursive: true, force: true });
    },
    { scope: "worker" },
  ],
  shop: async ({ page, origins }, use) => {
    const shop = new ShopPage(page, origins);
    await page.goto(`${origins.shop}/`);
    await use(shop);
    expect(shop.alarms).toEqual([]);
  },
});
