import { afterAll, beforeAll, expect, test } from "vitest";
import type { PlaceOptions } from "../../web/element/element-api.ts";
import { guideFile } from "../package/support/guide.ts";
import { exportMugInPage, mugPrintHash } from "../support/mug-print.ts";
import { addPicturesInPage, picturesOfEachKind } from "../support/pictures-of-each-kind.ts";
import { openSiteInFirefox, type SiteInFirefox } from "./support/site-in-firefox.ts";

type Element = HTMLElementTagNameMap["texelcast-editor"];

let site: SiteInFirefox;

beforeAll(async () => {
  site = await openSiteInFirefox();
});

afterAll(async () => {
  await site?.close();
});

test("a shop's element opens in Firefox, takes a picture, and prints the bytes that a server prints", async () => {
  const { page, address, faults } = site;
  await page.goto(`${address}element.html?locale=en&size=256&loading=lazy`);
  await page.waitForSelector("texelcast-editor >>> [data-act=start]");
  const place: PlaceOptions = {
    projector: { kind: "planar", position: [0, 0.05, 0.04], rotation: [0, 0, 0, 1], size: [0.04, 0.04, 0.04] },
  };
  const decals = await page.evaluate(async (options) => {
    const element = document.querySelector("texelcast-editor") as Element;
    const changed = new Promise<number>((resolve) => {
      element.addEventListener("change", ({ detail }) => resolve(detail.counts.decals), { once: true });
    });
    await element.addDecal("demo/decals/smiley.png", options);
    return await changed;
  }, place);
  expect(decals).toBe(1);
  const exported = await page.evaluate(exportMugInPage);
  expect(exported.sha256).toBe(await mugPrintHash(exported));
  expect(faults).toEqual([]);
});

test("pictures of each kind, and words, are printed from Firefox as a server prints them", async () => {
  const { page, address, faults } = site;
  await page.goto(`${address}element.html?locale=en&size=256&loading=lazy`);
  await page.evaluate(addPicturesInPage, await picturesOfEachKind());
  const exported = await page.evaluate(exportMugInPage);
  expect(exported.design.layers).toHaveLength(9);
  expect(exported.sha256).toBe(await mugPrintHash(exported));
  expect(faults).toEqual([]);
});

test("under Trusted Types the guide's policy lets the element in, in Firefox too, and nothing of other origins", async () => {
  const policy = "require-trusted-types-for 'script'; trusted-types lit-html default";
  const strict = await openSiteInFirefox({ "content-security-policy": policy });
  try {
    await strict.page.evaluateOnNewDocument(guideFile("trusted-types.js"));
    await strict.page.goto(`${strict.address}element.html?locale=en&size=256&loading=eager`);
    const told = await strict.page.evaluate(async () => {
      const element = document.querySelector("texelcast-editor") as Element;
      await element.addText("Moin");
      const { sha256 } = await element.exportTexture();
      try {
        new Worker("https://other.example/worker.js");
        return { sha256, elsewhere: "began" };
      } catch (error) {
        return { sha256, elsewhere: (error as Error).name };
      }
    });
    expect(told).toEqual({ sha256: expect.stringMatching(/^[0-9a-f]{64}$/), elsewhere: "TypeError" });
    expect(strict.faults.filter((fault) => !fault.includes("other.example"))).toEqual([]);
  } finally {
    await strict.close();
  }
});
