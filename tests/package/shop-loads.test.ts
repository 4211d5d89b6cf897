/** What a page really asks its server for, by the server's own log, before and after somebody touches the product. */
import type { Browser, Page } from "@playwright/test";
import { afterAll, beforeAll, expect, test } from "vitest";
import { shopStages } from "../../scripts/package/stages.mjs";
import { STORY_FILES } from "./support/engine-story.ts";
import { addShopFiles, type InstalledPackage, installPackage } from "./support/installed.ts";
import { openBrowser, openPage, type StaticServer, serveFolder } from "./support/serve.ts";

const DIST = "/node_modules/texelcast/dist";
const PAGE = `<!doctype html><html lang="en"><title>Shop</title><link rel="icon" href="data:," />
<script type="importmap">{ "imports": {
  "three": "/node_modules/three/build/three.module.js",
  "three/": "/node_modules/three/"
} }</script>
<script type="module" src="${DIST}/define.js"></script>
<texelcast-editor src="/mug.glb" style="inline-size: 700px; block-size: 500px"></texelcast-editor></html>`;

let installed: InstalledPackage;
let browser: Browser;
let server: StaticServer;
beforeAll(async () => {
  installed = await installPackage();
  installed.provide("three");
  addShopFiles(installed.folder, { ...STORY_FILES, "shop.html": PAGE });
  browser = await openBrowser();
  server = await serveFolder(installed.folder);
});
afterAll(async () => {
  await browser?.close();
  await server?.stop();
  installed?.remove();
});

/** Scripts of the package among what was served, in order. */
const scripts = (): string[] =>
  server.served
    .filter((path) => path.startsWith(`${DIST}/`) && path.endsWith(".js"))
    .map((path) => path.slice(DIST.length + 1));

async function openShop(): Promise<{ page: Page; complaints: string[] }> {
  const opened = await openPage(browser, `${server.origin}/shop.html`);
  await opened.page.evaluate(() => document.querySelector("texelcast-editor")?.start());
  await opened.page.waitForLoadState("networkidle");
  return opened;
}

test("until the product is touched nothing is loaded but what shows it, and then what takes hold of it", async () => {
  const { page, complaints } = await openShop();
  const { shown, touch } = shopStages();
  const before = scripts();
  expect(before.toSorted()).toEqual([...shown].toSorted());

  await page.evaluate(async (logo) => {
    const editor = document.querySelector("texelcast-editor");
    await editor?.addDecal(logo);
    editor?.select(null);
  }, "/logo.png");
  expect([...touch].filter((name) => !scripts().includes(name))).toEqual([]);
  expect(complaints).toEqual([]);
  await page.close();
});

test("a drag that begins before there are hands turns the product when they come", async () => {
  const { page, complaints } = await openShop();
  const box = await page.locator("texelcast-editor .tcv-canvas").boundingBox();
  if (!box) throw new Error("The view has no place.");
  const snapshot = (): Promise<string> =>
    page.evaluate(async () => {
      const picture = await document.querySelector("texelcast-editor")?.snapshot("current", { width: 64, height: 64 });
      return btoa(String.fromCharCode(...new Uint8Array((await picture?.arrayBuffer()) ?? [])));
    });
  const still = await snapshot();
  const { touch } = shopStages();
  const [hand = ""] = [...touch];
  const held = server.served.length;
  await page.mouse.move(box.x + box.width * 0.1, box.y + box.height * 0.8);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.5, box.y + box.height * 0.8, { steps: 3 });
  await expect
    .poll(() => server.served.slice(held).some((path) => path.endsWith(hand)), { timeout: 20_000 })
    .toBe(true);
  await page.waitForLoadState("networkidle");
  await expect.poll(snapshot, { timeout: 20_000 }).not.toBe(still);
  await page.mouse.up();
  expect(complaints).toEqual([]);
  await page.close();
});
