/** The installed package in a real Chromium: by a static server under a strict policy, and through Vite. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Browser } from "@playwright/test";
import { build, createServer } from "vite";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { THREE_RANGE } from "../../scripts/package/manifest.mjs";
import { readPictureHeader } from "../../web/engine/picture-header.ts";
import { STORY_FILES, storyHash, storyScript, wordsScript } from "./support/engine-story.ts";
import { guideFile } from "./support/guide.ts";
import { addShopFiles, CHECKOUT, type InstalledPackage, installPackage, runInNode } from "./support/installed.ts";
import { openBrowser, openPage, STRICT_POLICY, serveFolder } from "./support/serve.ts";

const DIST = "/node_modules/texelcast/dist";
const page = (script: string): string =>
  `<!doctype html><html lang="en"><title>Shop</title><link rel="icon" href="data:," /><body></body><script type="module" src="${script}"></script></html>`;

const viteOptions = () =>
  ({ root: installed.folder, configFile: join(installed.folder, "vite.config.js"), logLevel: "error" }) as const;

let installed: InstalledPackage;
let browser: Browser;
let expected: string;

beforeAll(async () => {
  installed = await installPackage();
  installed.provide("three");
  installed.provide("three-oldest");
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
    "element.js": elementScript(DIST),
    "words.html": page("/words.js"),
    "words.js": wordsScript(`${DIST}/standalone.js`),
    "index.html": page("/main.js"),
    "vite.config.js": guideFile("vite.config.js"),
    "main.js": `import { TexelcastError } from "texelcast";\n${storyScript("texelcast/core")}globalThis.root = TexelcastError.name;`,
  });
  browser = await openBrowser();
  expected = await storyHash();
});
afterAll(async () => {
  await browser?.close();
  installed?.remove();
});

const elementScript = (dist: string): string => `
import "${dist}/standalone.js";
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

/** The guide's lines between a scene of one ball and a look at it. */
const SCENE_SCRIPT = `
import * as THREE from "three";
const renderer = new THREE.WebGLRenderer();
renderer.setSize(64, 64);
const mesh = new THREE.Mesh(new THREE.SphereGeometry(0.5, 32, 16), new THREE.MeshBasicMaterial({ color: "#ffffff" }));
async function story() {
  const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 10);
  camera.position.z = 1.5;
  const world = new THREE.Scene();
  world.add(mesh);
  renderer.render(world, camera);
  const gl = renderer.getContext();
  const rgba = new Uint8Array(64 * 64 * 4);
  gl.readPixels(0, 0, 64, 64, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
  let colored = 0;
  for (let at = 0; at < rgba.length; at += 4) {
    if (Math.max(...rgba.subarray(at, at + 3)) - Math.min(...rgba.subarray(at, at + 3)) > 32) colored += 1;
  }
  painted.dispose();
  return { isPainted: colored > 100, mapAfter: mesh.material.map };
}
${guideFile("painted.js")}
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
    import { readdirSync, readFileSync } from "node:fs";
    import { renderPrint } from "texelcast/node";
    const assets = () => readFileSync("logo.png");
    const print = await renderPrint({ model: "mug.glb", design: ${JSON.stringify(design)}, assets, size: 256 });
    console.log(print.sha256);`;
  expect(await runInNode(installed.folder, script)).toBe(sha256);
  await server.stop();
});

test("the first lines of the element's document show a product where the package's dist is served", async () => {
  const document = readFileSync(join(CHECKOUT, "docs/element.md"), "utf8");
  const [, lines = ""] = /```html\n(.*?)```/s.exec(document) ?? [];
  const [, address = ""] = /src="https:\/\/your-shop\.example\/texelcast\/([\w.-]+)"/.exec(lines) ?? [];
  const tag = lines.replace(/<script.*<\/script>/, "").replace(/ (?:zones|poster)="[^"]*"/g, "");
  addShopFiles(installed.folder, {
    "first.html": page("/first.js").replace("<body>", `<body>${tag}`),
    "first.js": `import "${DIST}/${address}"; globalThis.story = await document.querySelector("texelcast-editor").start().then(() => "shown", String);`,
  });
  const server = await serveFolder(installed.folder);
  expect(await tell(`${server.origin}/first.html`)).toEqual({ story: "shown", complaints: [] });
  await server.stop();
});

test("a page without a bundler and without an import map is told where three.js is, in its language", async () => {
  addShopFiles(installed.folder, {
    "mapless.html": page("/mapless.js"),
    "mapless.js": `
      import { TexelcastEditor } from "${DIST}/define.js";
      const editor = Object.assign(new TexelcastEditor(), { src: "/mug.glb", locale: "de" });
      document.body.append(editor);
      globalThis.story = await editor.start().catch(({ code, reason, message, hint }) => ({ code, reason, message, hint }));`,
  });
  const server = await serveFolder(installed.folder);
  const { story } = await tell(`${server.origin}/mapless.html`);
  expect(story).toMatchObject({
    code: "unsupported",
    reason: "no-three",
    message: expect.stringContaining("three.js"),
    hint: expect.stringMatching(/standalone\.js.*docs\/guides\/plain-html\.md/),
  });
  await server.stop();
});

test("a page takes the element from another origin, as from a CDN, and exports the same bytes", async () => {
  const cdn = await serveFolder(installed.folder, { "access-control-allow-origin": "*" });
  const script = elementScript(`${cdn.origin}${DIST}`);
  addShopFiles(installed.folder, { "cdn.html": page("/cdn.js"), "cdn.js": script });
  const shop = await serveFolder(installed.folder);
  const [here, elsewhere] = [await tell(`${shop.origin}/element.html`), await tell(`${shop.origin}/cdn.html`)];
  expect(elsewhere).toEqual(here);
  expect(elsewhere).toMatchObject({ story: { sha256: expect.stringMatching(/^[0-9a-f]{64}$/) }, complaints: [] });
  await Promise.all([cdn.stop(), shop.stop()]);
});

test("under Trusted Types the guide's policy lets the element in, whole, and nothing of other origins", async () => {
  const trusted = page("/element.js").replace("<title>", '<script src="/trusted-types.js"></script><title>');
  const files = { "trusted.html": trusted, "trusted-types.js": guideFile("trusted-types.js") };
  addShopFiles(installed.folder, files);
  const policy = `${STRICT_POLICY}; require-trusted-types-for 'script'; trusted-types lit-html default`;
  const server = await serveFolder(installed.folder, { "content-security-policy": policy });
  const { story, complaints } = await tell(`${server.origin}/trusted.html`);
  expect({ story, complaints }).toMatchObject({
    story: { sha256: expect.stringMatching(/^[0-9a-f]{64}$/) },
    complaints: [],
  });
  const { page: opened } = await openPage(browser, `${server.origin}/trusted.html`);
  const elsewhere = await opened.evaluate(() => {
    try {
      return new Worker("https://other.example/worker.js").toString();
    } catch (error) {
      return (error as Error).name;
    }
  });
  expect(elsewhere).toBe("TypeError");
  await opened.close();
  await server.stop();
});

describe("a page that lets no worker begin", () => {
  /** What the element and the engine alone say of it, the element in German. */
  const REFUSALS = `
    import "${DIST}/standalone.js";
    import { createEngine } from "${DIST}/core.js";
    const editor = document.createElement("texelcast-editor");
    Object.assign(editor, { src: "/mug.glb", locale: "de" });
    document.body.append(editor);
    const told = ({ code, field, message, hint }) => ({ code, field, message, hint });
    const element = await editor.start().then(() => null, told);
    let core = null;
    try { createEngine().dispose(); } catch (error) { core = told(error); }
    globalThis.story = { element, core, shown: editor.shadowRoot.querySelector("[role=alert]").textContent };`;

  test("in an iframe that its sandbox leaves no origin, is told which word the sandbox needs", async () => {
    const framed = '<!doctype html><iframe sandbox="allow-scripts" src="/refusals.html"></iframe>';
    addShopFiles(installed.folder, { ...refusals(), "framed.html": framed });
    const server = await serveFolder(installed.folder, { "access-control-allow-origin": "*" });
    const { page: opened } = await openPage(browser, `${server.origin}/framed.html`);
    const frame = opened.frames().find((each) => each.url().endsWith("/refusals.html"));
    await frame?.waitForFunction(() => "story" in globalThis);
    const story = await frame?.evaluate(() => (globalThis as unknown as { story: unknown }).story);
    const refused = { code: "unsupported", field: "sandbox", hint: expect.stringContaining("allow-same-origin") };
    expect(story).toMatchObject({
      element: refused,
      core: refused,
      shown: expect.stringContaining("ohne eigene Herkunft"),
    });
    await opened.close();
    await server.stop();
  });

  test("by Trusted Types without the guide's policy, is told that it needs one", async () => {
    addShopFiles(installed.folder, refusals());
    const policy = `${STRICT_POLICY}; require-trusted-types-for 'script'`;
    const server = await serveFolder(installed.folder, { "content-security-policy": policy });
    const { story } = await tell(`${server.origin}/refusals.html`);
    const hint = expect.stringContaining("docs/guides/plain-html.md");
    const refused = { code: "unsupported", field: "require-trusted-types-for", hint };
    expect(story).toMatchObject({ element: refused, core: refused, shown: expect.stringContaining("Default-Policy") });
    await server.stop();
  });

  const refusals = () => ({ "refusals.html": page("/refusals.js"), "refusals.js": REFUSALS });
});

test("Vite builds a shop with the guide's two settings", async () => {
  const outDir = join(installed.folder, "built");
  await build({ ...viteOptions(), build: { outDir, target: "es2022" } });
  addShopFiles(outDir, STORY_FILES);
  const server = await serveFolder(outDir);
  expect(await tell(`${server.origin}/`)).toEqual({ story: expected, complaints: [] });
  await server.stop();
});

test("Vite serves a shop for development with the guide's two settings", async () => {
  const server = await createServer({ ...viteOptions(), server: { port: 0 } });
  await server.listen();
  expect(await tell(server.resolvedUrls?.local[0] ?? "")).toEqual({ story: expected, complaints: [] });
  await server.close();
});

test("in Vite's development server the element writes words and exports them, with the bytes of a plain page", async () => {
  const plain = await serveFolder(installed.folder);
  const told = await tell(`${plain.origin}/words.html`);
  await plain.stop();
  expect(told).toMatchObject({ story: expect.stringMatching(/^[0-9a-f]{64}$/), complaints: [] });
  addShopFiles(installed.folder, { "dev.html": page("/dev.js"), "dev.js": wordsScript("texelcast/define") });
  const server = await createServer({ ...viteOptions(), server: { port: 0 } });
  await server.listen();
  expect(await tell(`${server.resolvedUrls?.local[0]}dev.html`)).toEqual(told);
  await server.close();
});

test("no script of the package's pages imports one that a page or a worker begins with", () => {
  // Under a second address such a script would run twice, and make a second engine. At an edge there are no addresses, and no pages.
  const dist = join(installed.folder, "node_modules/texelcast/dist");
  const begun = /(?:\bfrom|\bimport)\s*"\.\/(define|standalone|core|three|host|embed|[\w-]+-worker)\.js"/;
  const scripts = readdirSync(dist).filter((name) => /(?<!-edge)\.js$/.test(name));
  expect(scripts.filter((name) => begun.test(readFileSync(join(dist, name), "utf8")))).toEqual([]);
});

test("the guide's lines for Node write the print file", async () => {
  await runInNode(installed.folder, guideFile("print.mjs"));
  const { width, height } = await readPictureHeader(readFileSync(join(installed.folder, "print.png")), "print.png");
  expect([width, height]).toEqual([512, 512]);
  // Nor does a customer's design make it read another's file.
  const design = JSON.parse(readFileSync(join(installed.folder, "design.json"), "utf8"));
  for (const asset of Object.values<{ uri: string }>(design.assets)) asset.uri = "../other.png";
  addShopFiles(installed.folder, { "other.png": readFileSync(join(installed.folder, "logo.png")) });
  addShopFiles(join(installed.folder, "hostile"), { "design.json": JSON.stringify(design) });
  await expect(runInNode(join(installed.folder, "hostile"), guideFile("print.mjs"))).rejects.toThrow(
    "../other.png is no file of the design.",
  );
});

// Both ends of the peer's range.
test.each(["three", "three-oldest"])(
  "the guide's lines for three.js paint a mesh of one's own, with %s",
  async (three) => {
    addShopFiles(installed.folder, {
      "scene.html": `<!doctype html><html lang="en"><title>Scene</title><link rel="icon" href="data:," />
<script type="importmap">{ "imports": {
  "three": "/node_modules/${three}/build/three.module.js",
  "texelcast/three": "${DIST}/three.js"
} }</script>
<script type="module" src="/scene.js"></script></html>`,
      "scene.js": SCENE_SCRIPT,
    });
    const server = await serveFolder(installed.folder);
    const { story, complaints } = await tell(`${server.origin}/scene.html`);
    expect({ story, complaints }).toEqual({ story: { isPainted: true, mapAfter: null }, complaints: [] });
    await server.stop();
  },
);

test("the peer range of three.js begins and ends where it is tested", () => {
  const versionOf = (name: string): string => {
    const { version } = JSON.parse(readFileSync(join(CHECKOUT, "node_modules", name, "package.json"), "utf8"));
    return version as string;
  };
  const [, newest = ""] = /^0\.(\d+)\./.exec(versionOf("three")) ?? [];
  expect(THREE_RANGE).toBe(`>=${versionOf("three-oldest")} <0.${Number(newest) + 1}.0`);
});
