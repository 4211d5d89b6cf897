import { afterAll, beforeAll, expect, test } from "vitest";
import { exportMugInPage, mugPrintHash } from "../support/mug-print.ts";
import { addPicturesInPage, picturesOfEachKind } from "../support/pictures-of-each-kind.ts";
import { openSiteInWebkit, type SiteInWebkit } from "./support/site-in-webkit.ts";

let site: SiteInWebkit;

beforeAll(async () => {
  site = await openSiteInWebkit();
});

afterAll(async () => {
  await site?.close();
});

test("a shop's element opens in WebKit, takes pictures of each kind and words, and prints the bytes that a server prints", async () => {
  await site.driver.get(`${site.address}element.html?locale=en&size=256&loading=lazy`);
  await site.evaluate(addPicturesInPage, await picturesOfEachKind());
  const exported = await site.evaluate(exportMugInPage);
  expect(exported.design.layers).toHaveLength(9);
  expect(exported.sha256).toBe(await mugPrintHash(exported));
  expect(await site.faults()).toEqual([]);
});
