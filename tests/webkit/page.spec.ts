import { Key, Origin } from "selenium-webdriver";
import { afterAll, beforeAll, expect, test } from "vitest";
import { decalPlaceInPage, lowestLayerInPage, settledHashInPage } from "../support/first-demo-page.ts";
import { manyLayersHash } from "../support/many-layers.ts";
import { hashManyLayersInPage, manyLayersInput } from "../support/many-layers-page.ts";
import { openSiteInWebkit, type SiteInWebkit } from "./support/site-in-webkit.ts";

let site: SiteInWebkit;

beforeAll(async () => {
  site = await openSiteInWebkit();
  await site.driver.get(`${site.address}?new`);
  await site.driver.wait(() => site.evaluate(() => window.texelcast !== undefined), 60_000);
  await site.evaluate(async () => {
    await window.texelcast.ready;
    await window.texelcast.idle();
  });
});

afterAll(async () => {
  await site?.close();
});

const decalPlace = () => site.evaluate(decalPlaceInPage);
const settledHash = () => site.evaluate(settledHashInPage);

test("the page opens on its first demo and draws it", async () => {
  const agent = await site.evaluate(() => navigator.userAgent);
  expect(agent).toContain("AppleWebKit/");
  expect(agent).not.toContain("Chrome");
  await site.driver.wait(() => site.evaluate(async () => (await window.texelcast.stats()).frames > 0), 60_000);
  expect(await site.evaluate(() => window.texelcast.design().layers.length)).toBeGreaterThan(0);
  const { shownRevision, bakeCount } = await site.evaluate(() => window.texelcast.stats());
  expect(bakeCount).toBe(1);
  expect(shownRevision).toBeGreaterThan(0);
  expect(await site.faults()).toEqual([]);
});

test("the decal is dragged with the mouse, texels change under way, and undo gives the first bytes back", async () => {
  const start = await settledHash();
  const from = await decalPlace();
  const mouse = () => site.driver.actions({ async: true });
  const to = (x: number, y: number) => ({
    origin: Origin.VIEWPORT,
    x: Math.round(from.x) + x,
    y: Math.round(from.y) + y,
    duration: 60,
  });
  await mouse().move(to(0, 0)).press().move(to(20, -5)).move(to(40, -10)).perform();
  await site.driver.wait(() => site.evaluate(async (hash) => (await window.texelcast.hash()) !== hash, start), 60_000);
  await mouse().move(to(60, -15)).release().perform();
  const moved = await settledHash();
  expect(moved).not.toBe(start);
  expect((await decalPlace()).position).not.toEqual(from.position);

  await site.driver.actions().keyDown(Key.CONTROL).sendKeys("z").keyUp(Key.CONTROL).perform();
  expect(await settledHash()).toBe(start);
  expect(await site.faults()).toEqual([]);
});

test("a long press on a button chooses no words, two quick ones zoom nothing, and lists have the page's own arrow", async () => {
  const looks = await site.evaluate(() => {
    const found = { buttons: [] as string[][], lists: [] as string[] };
    const visit = (root: ParentNode): void => {
      for (const element of root.querySelectorAll<HTMLElement>("*")) {
        if (element.shadowRoot) visit(element.shadowRoot);
        const style = getComputedStyle(element);
        if (element.localName === "button") found.buttons.push([style.webkitUserSelect, style.touchAction]);
        if (element.localName === "select") found.lists.push(style.appearance);
      }
    };
    visit(document);
    return found;
  });
  expect(looks.buttons.length).toBeGreaterThan(20);
  const zooms = ([chosen, touched]: string[]) => chosen !== "none" || !/^(manipulation|none)$/.test(touched ?? "");
  expect(looks.buttons.filter(zooms)).toEqual([]);
  expect(looks.lists.length).toBeGreaterThan(0);
  expect(looks.lists).toEqual(looks.lists.map(() => "none"));
});

test("the view's settings open as high as what is in them", async () => {
  const heading = await site.evaluate(async () => {
    const press = async (): Promise<void> => {
      window.findForTests("#view-menu")?.click();
      await new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)));
    };
    await press();
    const height = window.findForTests("#view-panel h2")?.offsetHeight;
    await press();
    return height;
  });
  expect(heading).toBeGreaterThan(0);
  expect(heading).toBeLessThan(40);
});

test("a notice has the place of the first steps' card to itself, and gives it back", async () => {
  const looks = await site.evaluate(async () => {
    const stack = window.findForTests("tc-notice-stack");
    const card = window.findForTests("tc-first-hint");
    if (!stack?.shadowRoot || !card) throw new Error("The page has no place for notices, or no first steps.");
    const { shadowRoot } = stack;
    const once = async (filled: boolean): Promise<string> => {
      while (stack.hasAttribute("filled") !== filled) await new Promise((next) => setTimeout(next, 20));
      return getComputedStyle(card).visibility;
    };
    const before = await once(false);
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File(["this is no model"], "knight.glb"));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
    const during = await once(true);
    shadowRoot.querySelector<HTMLElement>(".dismiss")?.click();
    return [before, during, await once(false)];
  });
  expect(looks).toEqual(["visible", "hidden", "visible"]);
  expect(await site.faults()).toEqual([]);
});

test("a layer is copied and pasted by keys, gets a typed name, and is there after a reload with the same bytes", async () => {
  const names = () => site.evaluate(() => window.texelcast.design().layers.map(({ name }) => name));
  const pressed = (key: "a" | "c" | "v") =>
    site.driver.actions().keyDown(Key.CONTROL).sendKeys(key).keyUp(Key.CONTROL).perform();
  const click = async (selector: string) => {
    const place = await site.evaluate((selector) => {
      const box = window.findForTests(selector)?.getBoundingClientRect();
      if (!box) throw new Error(`The page has no ${selector}.`);
      return { x: Math.round(box.x + box.width / 2), y: Math.round(box.y + box.height / 2) };
    }, selector);
    await site.driver
      .actions({ async: true })
      .move({ origin: Origin.VIEWPORT, ...place })
      .click()
      .perform();
  };
  const [lowest, ...others] = await names();
  await click(`.row[data-id="${await site.evaluate(lowestLayerInPage)}"]`);
  await pressed("c");
  await pressed("v");
  await site.driver.wait(async () => (await names()).length > others.length + 1, 60_000);
  await settledHash();
  await click("#name");
  await pressed("a");
  await site.driver.actions().sendKeys("Handle", Key.ENTER).perform();
  expect(await names()).toEqual([lowest, "Handle", ...others]);
  const shown = await settledHash();
  await site.evaluate(() => window.texelcast.kept());

  await site.driver.get(site.address);
  await site.driver.wait(() => site.evaluate(() => window.texelcast !== undefined), 60_000);
  await site.evaluate(() => window.texelcast.ready);
  expect(await names()).toEqual([lowest, "Handle", ...others]);
  expect(await settledHash()).toBe(shown);
  expect(await site.faults()).toEqual([]);
});

test("many layers give the one hash in WebKit that Chromium, Firefox, Node and native code give", async () => {
  expect(await site.evaluate(hashManyLayersInPage, manyLayersInput())).toBe(manyLayersHash);
});
