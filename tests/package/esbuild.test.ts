/** The installed package through esbuild, which leaves addresses of files as they are. */
import { cpSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { build } from "esbuild";
import { expect, test } from "vitest";
import { STORY_FILES, wordsScript } from "./support/engine-story.ts";
import { addShopFiles, installPackage } from "./support/installed.ts";
import { openBrowser, openPage, serveFolder } from "./support/serve.ts";

test("with the worker's scripts and the assets laid beside what esbuild makes, a page writes words on a mug", async () => {
  const installed = await installPackage();
  installed.provide("three");
  const { folder } = installed;
  const [dist, out] = [join(folder, "node_modules/texelcast/dist"), join(folder, "out")];
  addShopFiles(folder, { "shop.js": wordsScript("texelcast/define") });
  await build({ entryPoints: [join(folder, "shop.js")], bundle: true, format: "esm", splitting: true, outdir: out });
  cpSync(join(dist, "assets"), join(out, "assets"), { recursive: true });
  for (const name of readdirSync(dist)) if (name.includes("worker")) cpSync(join(dist, name), join(out, name));

  const page =
    '<!doctype html><html lang="en"><title>Shop</title><link rel="icon" href="data:," /><body></body><script type="module" src="/shop.js"></script></html>';
  addShopFiles(out, { ...STORY_FILES, "index.html": page });
  const [server, browser] = [await serveFolder(out), await openBrowser()];
  const { page: opened, complaints } = await openPage(browser, `${server.origin}/`);
  await opened.waitForFunction(() => "story" in globalThis, null, { timeout: 50_000 });
  const story = await opened.evaluate(() => (globalThis as unknown as { story: unknown }).story);
  expect({ story, complaints }).toEqual({ story: expect.stringMatching(/^[0-9a-f]{64}$/), complaints: [] });
  await browser.close();
  await server.stop();
  installed.remove();
});
