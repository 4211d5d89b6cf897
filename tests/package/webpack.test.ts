/** The installed package through webpack 5, which builds it without a setting. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { promisify } from "node:util";
import type { Browser } from "@playwright/test";
import { afterAll, beforeAll, expect, test } from "vitest";
import webpack from "webpack";
import { STORY_FILES, wordsScript } from "./support/engine-story.ts";
import { guideFile } from "./support/guide.ts";
import { addShopFiles, type InstalledPackage, installPackage } from "./support/installed.ts";
import { openBrowser, openPage, serveFolder } from "./support/serve.ts";

let installed: InstalledPackage;
let browser: Browser;
beforeAll(async () => {
  installed = await installPackage();
  installed.provide("three");
  browser = await openBrowser();
});
afterAll(async () => {
  await browser?.close();
  installed?.remove();
});

test("webpack builds a shop with the guide's settings, and its page writes words on a mug", async () => {
  addShopFiles(installed.folder, {
    "webpack.config.js": guideFile("webpack.config.js"),
    "src/index.js": wordsScript("texelcast/define"),
  });
  const { default: config } = (await import(join(installed.folder, "webpack.config.js"))) as {
    default: webpack.Configuration;
  };
  // Its minifier takes ten seconds over what is minified already.
  const dist = join(installed.folder, "dist");
  const own = { context: installed.folder, output: { path: dist }, optimization: { minimize: false } };
  const compiler = webpack({ ...config, ...own });
  const stats = await promisify(compiler.run.bind(compiler))();
  expect(stats?.toJson({ all: false, errors: true }).errors).toEqual([]);

  const page =
    '<!doctype html><html lang="en"><title>Shop</title><link rel="icon" href="data:," /><body></body><script src="/main.js"></script></html>';
  addShopFiles(dist, { ...STORY_FILES, "index.html": page });
  const server = await serveFolder(dist);
  const { page: opened, complaints } = await openPage(browser, `${server.origin}/`);
  await opened.waitForFunction(() => "story" in globalThis, null, { timeout: 50_000 });
  const story = await opened.evaluate(() => (globalThis as unknown as { story: unknown }).story);
  expect({ story, complaints }).toEqual({ story: expect.stringMatching(/^[0-9a-f]{64}$/), complaints: [] });
  await opened.close();
  await server.stop();
});

test("no script for pages asks for a module of Node's, or assigns to its own address", () => {
  // webpack and Turbopack refuse both, in branches that no page takes too.
  const dist = join(installed.folder, "node_modules/texelcast/dist");
  const refused =
    /import\.meta\.url\s*=[^=]|(?:\bfrom|\bimport\(?|\brequire\()\s*["'](?:node:|(?:fs|path|url|module)["'])/;
  const scripts = readdirSync(dist).filter((name) => /^(?!node|cli|.*-server).*\.js$/.test(name));
  expect(scripts).toContain("define.js");
  expect(scripts.filter((name) => refused.test(readFileSync(join(dist, name), "utf8")))).toEqual([]);
});
