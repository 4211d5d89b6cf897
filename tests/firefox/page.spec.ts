import type { Page } from "puppeteer-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { decalPlaceInPage, lowestLayerInPage, settledHashInPage } from "../support/first-demo-page.ts";
import { manyLayersHash } from "../support/many-layers.ts";
import { hashManyLayersInPage, manyLayersInput } from "../support/many-layers-page.ts";
import { openSiteInFirefox, type SiteInFirefox } from "./support/site-in-firefox.ts";

let site: SiteInFirefox;
let page: Page;

beforeAll(async () => {
  site = await openSiteInFirefox();
  ({ page } = site);
  await page.goto(site.address);
  await page.waitForFunction(() => window.texelcast !== undefined, { timeout: 60_000 });
  await page.evaluate(() => window.texelcast.ready);
  await page.evaluate(() => window.texelcast.idle());
});

afterAll(async () => {
  await site?.close();
});

const decalPlace = () => page.evaluate(decalPlaceInPage);
const settledHash = () => page.evaluate(settledHashInPage);

test("the page opens on its first demo and draws it", async () => {
  expect(await page.evaluate(() => navigator.userAgent)).toContain("Firefox/");
  await page.waitForFunction(async () => (await window.texelcast.stats()).frames > 0, { timeout: 60_000 });
  expect(await page.evaluate(() => window.texelcast.design().layers.length)).toBeGreaterThan(0);
  const { shownRevision, bakeCount } = await page.evaluate(() => window.texelcast.stats());
  expect(bakeCount).toBe(1);
  expect(shownRevision).toBeGreaterThan(0);
  expect(site.faults).toEqual([]);
});

test("the decal is dragged with the mouse, texels change under way, and undo gives the first bytes back", async () => {
  const start = await settledHash();
  const from = await decalPlace();
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 40, from.y - 10, { steps: 8 });
  await page.waitForFunction(async (hash) => (await window.texelcast.hash()) !== hash, { timeout: 60_000 }, start);
  await page.mouse.move(from.x + 60, from.y - 15, { steps: 4 });
  await page.mouse.up();
  const moved = await settledHash();
  expect(moved).not.toBe(start);
  expect((await decalPlace()).position).not.toEqual(from.position);

  await page.keyboard.down("Control");
  await page.keyboard.press("z");
  await page.keyboard.up("Control");
  expect(await settledHash()).toBe(start);
  expect(site.faults).toEqual([]);
});

test("a layer is copied and pasted by keys, gets a typed name, and is there after a reload with the same bytes", async () => {
  const names = () => page.evaluate(() => window.texelcast.design().layers.map(({ name }) => name));
  const pressed = async (key: "c" | "v") => {
    await page.keyboard.down("Control");
    await page.keyboard.press(key);
    await page.keyboard.up("Control");
  };
  const [lowest, ...others] = await names();
  await page.locator(`>>> .row[data-id="${await page.evaluate(lowestLayerInPage)}"]`).click();
  await pressed("c");
  await pressed("v");
  await page.waitForFunction((count) => window.texelcast.design().layers.length > count, {}, others.length + 1);
  await page.locator(">>> #name").click({ count: 3 });
  await page.keyboard.type("Größe");
  await page.keyboard.press("Enter");
  expect(await names()).toEqual([lowest, "Größe", ...others]);
  const shown = await settledHash();
  await page.evaluate(() => window.texelcast.kept());

  await page.goto(site.address);
  await page.waitForFunction(() => window.texelcast !== undefined, { timeout: 60_000 });
  await page.evaluate(() => window.texelcast.ready);
  expect(await names()).toEqual([lowest, "Größe", ...others]);
  expect(await settledHash()).toBe(shown);
  expect(site.faults).toEqual([]);
});

test("what Tab comes to in the panel is in sight whole", async () => {
  await page.setViewport({ width: 1440, height: 900 });
  await page.evaluate(() => window.texelcast.select(window.texelcast.design().layers[0]?.id ?? null));
  await page.evaluate(() => window.texelcast.idle());
  const cut: string[] = [];
  let stops = 0;
  for (let step = 0; step < 120; step += 1) {
    await page.keyboard.press("Tab");
    const stop = await page.evaluate(() => {
      let focused = document.activeElement;
      while (focused?.shadowRoot?.activeElement) focused = focused.shadowRoot.activeElement;
      let node: Element | null = focused;
      while (node && !node.matches(".lower"))
        node = node.parentElement ?? (node.getRootNode() as ShadowRoot).host ?? null;
      if (!focused || !node || node === focused) return null;
      const [box, room] = [focused.getBoundingClientRect(), node.getBoundingClientRect()];
      const name = focused.id || focused.getAttribute("aria-label") || focused.localName;
      return { name, isCut: box.top < room.top - 0.5 || box.bottom > room.bottom + 0.5 };
    });
    if (stop === null) {
      if (stops > 0) break;
      continue;
    }
    stops += 1;
    if (stop.isCut) cut.push(stop.name);
  }
  await page.setViewport({ width: 1280, height: 800 });
  expect(cut).toEqual([]);
  expect(stops).toBeGreaterThan(20);
});

test("many layers give the one hash in Firefox that Chromium, Node and native code give", async () => {
  expect(await page.evaluate(hashManyLayersInPage, manyLayersInput())).toBe(manyLayersHash);
});
