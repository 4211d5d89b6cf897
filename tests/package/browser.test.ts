/** The installed package in a real Chromium: by a static server under a strict policy, and through Vite. */
import { join } from "node:path";
import type { Browser } from "@playwright/test";
import { build, createServer } from "vite";
import { afterAll, beforeAll, expect, test } from "vitest";
import { STORY_FILES, storyHash, storyScript } from "./support/engine-story.ts";
import { addShopFiles, type InstalledPackage, installPackage, runInNode } from "./support/installed.ts";
import { openBrowser, openPage, STRICT_POLICY, serveFolder } from "./support/serve.ts";

const DIST = "/node_modules/texelcast/dist";
const page = (script: string): string =>
  `<!doctype html><html lang="en"><title>Shop</title><link rel="icon" href="data:," /><body></body><script type="module" src="${script}"></script></html>`;

let installed: InstalledPackage;
let browser: Browser;
let expected: string;

beforeAll(async () => {
  installed = await installPackage();
  installed.provide("three");
  addShopFiles(installed.folder, {
    ...STORY_FILES,
    "plain.html": page("/plain.js"),
    "plain.js": storyScript(`${DIST}/core.js`),
    "bytes.html": page("/bytes.js"),
    "bytes.js": storyScript(
      `${DIST}/core.js`,
      `{ wasm: await WebAssembly.compileStreaming(fetch("${DIST}/assets/texelcast.wasm")) }`,
    ),
    "element.html": page("/element.js"),
    "element.js": ELEMENT_SCRIPT,
    "index.html": page("/main.js"),
    "main.js": `import { TexelcastError } from "texelcast";\n${storyScript("texelcast/core")}globalThis.root = TexelcastError.name;`,
  });
  browser = await openBrowser();
  expected = await storyHash();
});
afterAll(async () => {
  await browser?.close();
  installed?.remove();
});

const ELEMENT_SCRIPT = `
import "${DIST}/standalone.js";
const editor = document.createElement("texelcast-editor");
editor.style.cssText = "display: block; inline-size: 600px; block-size: 500px";
Object.assign(editor, { src: "/mug.glb", loading: "eager", size: 256 });
async function story() {
  document.body.append(editor);
  await editor.start();
  await editor.addDecal("/logo.png");
  const { sha256 } = await editor.exportTexture();
  const { design } = await editor.exportDesign();
  return { sha256, design: JSON.stringify(design) };
}
story().then((told) => { globalThis.story = told; }, (error) => { globalThis.story = String(error?.stack ?? error); });
`;

/** What the page's story came to, and what it complained of. */
async function tell(address: string): Promise<{ story: unknown; complaints: string[] }> {
  const { page: opened, complaints } = await openPage(browser, address);
  await opened.waitForFunction(() => "story" in globalThis, null, { timeout: 50_000 });
  const story = await opened.evaluate(() => (globalThis as unknown as { story: unknown }).story);
  await opened.close();
  return { story, complaints };
}

test("a plain page under a strict policy runs the engine, with the same texels as in Node", async () => {
  const server = await serveFolder(installed.folder, { "content-security-policy": STRICT_POLICY });
  expect(await tell(`${server.origin}/plain.html`)).toEqual({ story: expected, complaints: [] });
  await server.stop();
});

test("the engine takes a WebAssembly module that the page has compiled", async () => {
  const server = await serveFolder(installed.folder, { "content-security-policy": STRICT_POLICY });
  expect(await tell(`${server.origin}/bytes.html`)).toEqual({ story: expected, complaints: [] });
  await server.stop();
});

test("a plain page under a strict policy opens the element; Node prints the very bytes that it exported", async () => {
  const server = await serveFolder(installed.folder, { "content-security-policy": STRICT_POLICY });
  const { story, complaints } = await tell(`${server.origin}/element.html`);
  expect(complaints).toEqual([]);
  const { sha256, design } = story as { sha256: string; design: string };
  const script = `
    import { readFileSync } from "node:fs";
    import { renderPrint } from "texelcast/node";
    const assets = () => readFileSync("logo.png");
    const print = await renderPrint({ model: "mug.glb", design: ${JSON.stringify(design)}, assets, size: 256 });
    console.log(print.sha256);`;
  expect(await runInNode(installed.folder, script)).toBe(sha256);
  await server.stop();
});

// Its worker and its .wasm lie beside the scripts, which pre-bundling would move.
const OPTIMIZE = { exclude: ["texelcast"] };
// The worker loads its decoders when it needs them, which Vite's default, "iife", cannot express.
const VITE = { configFile: false, logLevel: "error", worker: { format: "es" } } as const;

test("Vite builds a shop", async () => {
  const root = installed.folder;
  const outDir = join(root, "built");
  await build({ ...VITE, root, build: { outDir, target: "es2022" } });
  addShopFiles(outDir, STORY_FILES);
  const server = await serveFolder(outDir);
  expect(await tell(`${server.origin}/`)).toEqual({ story: expected, complaints: [] });
  await server.stop();
});

test("Vite serves a shop for development", async () => {
  const server = await createServer({ ...VITE, root: installed.folder, server: { port: 0 }, optimizeDeps: OPTIMIZE });
  await server.listen();
  expect(await tell(server.resolvedUrls?.local[0] ?? "")).toEqual({ story: expected, complaints: [] });
  await server.close();
});
