/**
 * The guides' pages that React renders on a server: rendered in bare Node as a framework does it, hydrated in a real Chromium, with the
 * customer's way through them. Next.js itself is not among the checkout's packages; what its guide says runs without it.
 */
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Browser } from "@playwright/test";
import { build as bundle } from "esbuild";
import { build } from "vite";
import { afterAll, beforeAll, expect, test, vi } from "vitest";
import { type DesignsServer, startDesignsServer } from "./support/designs-server.ts";
import { STORY_FILES } from "./support/engine-story.ts";
import { guideFiles } from "./support/guide.ts";
import { addShopFiles, type InstalledPackage, installPackage, runInNode } from "./support/installed.ts";
import { personalise } from "./support/personalise.ts";
import { openBrowser, openPage, passOn, serveFolder } from "./support/serve.ts";

// Each is a whole product page, its finished texture and its print file, with graphics drawn in software.
vi.setConfig({ testTimeout: 120_000, hookTimeout: 120_000 });

const FILES = guideFiles();

/** What the server and the page's script both render. */
const PRODUCTS = {
  react: `
    import { createElement, useState } from "react";
    import { Designer } from "./react/designer.jsx";
    function Product() {
      const [design, setDesign] = useState("");
      const field = createElement("input", { type: "hidden", name: "design", value: design });
      const buy = createElement("button", { name: "buy", disabled: design === "" });
      return createElement("form", null, createElement(Designer, { onSaved: setDesign }), field, buy);
    }
    export const product = createElement(Product);`,
  next: `
    import { createElement } from "react";
    import Product from "./next/app/product/page.tsx";
    export const product = createElement(Product);`,
};

/** Next.js's part in the guide's route. */
const ROUTE_SERVER = `
  import { createServer } from "node:http";
  import { Readable } from "node:stream";
  import { POST } from "./route.mjs";
  createServer(async (request, response) => {
    const { method, headers } = request;
    const body = Readable.toWeb(request);
    const reply = await POST(new Request("http://shop/designs", { method, headers, body, duplex: "half" }));
    response.writeHead(reply.status, Object.fromEntries(reply.headers)).end(Buffer.from(await reply.arrayBuffer()));
  }).listen(process.env.PORT, () => console.log("The route answers."));`;

let installed: InstalledPackage;
let browser: Browser;
beforeAll(async () => {
  installed = await installPackage();
  for (const name of ["three", "react", "react-dom"]) installed.provide(name);
  const { folder } = installed;
  addShopFiles(folder, FILES);
  // The project's root, as Next.js sees it.
  addShopFiles(join(folder, "next"), {
    "save-design.js": FILES["save-design.js"] ?? "",
    "designs-server.mjs": ROUTE_SERVER,
  });
  addShopFiles(join(folder, "next/public"), {});
  await bundleForNode("next/app/designs/route.ts", "next/route.mjs");
  browser = await openBrowser();
});
afterAll(async () => {
  await browser?.close();
  installed?.remove();
});

async function bundleForNode(entry: string, outfile: string): Promise<void> {
  await bundle({
    absWorkingDir: installed.folder,
    entryPoints: [entry],
    outfile,
    bundle: true,
    platform: "node",
    format: "esm",
    packages: "external",
    jsx: "automatic",
    logLevel: "error",
  });
}

/** Renders the page in Node, and builds it with the script that hydrates it; gives the folder to serve. */
async function buildRendered(name: keyof typeof PRODUCTS): Promise<string> {
  const { folder } = installed;
  addShopFiles(folder, {
    [`product-${name}.js`]: PRODUCTS[name],
    [`render-${name}.js`]: `
      import { renderToString } from "react-dom/server";
      import { product } from "./product-${name}.js";
      console.log(renderToString(product));`,
    [`hydrate-${name}.js`]: `
      import { hydrateRoot } from "react-dom/client";
      import { product } from "./product-${name}.js";
      hydrateRoot(document.querySelector("#page"), product);`,
  });
  await bundleForNode(`render-${name}.js`, `rendered-${name}.mjs`);
  const rendered = await runInNode(folder, `await import("./rendered-${name}.mjs")`);
  addShopFiles(folder, {
    [`${name}.html`]: `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>${name}</title></head>
      <body><div id="page">${rendered}</div><script type="module" src="/hydrate-${name}.js"></script></body></html>`,
  });
  const outDir = join(folder, `built-${name}`);
  await build({
    root: folder,
    configFile: join(folder, "vite.config.js"),
    logLevel: "error",
    build: { outDir, target: "es2022", rolldownOptions: { input: join(folder, `${name}.html`) } },
  });
  addShopFiles(outDir, { ...STORY_FILES, "favicon.ico": "" });
  return outDir;
}

/** The customer's way through the page; gives the id of the order and the hash of what was approved. */
async function order(name: keyof typeof PRODUCTS, designs: DesignsServer): Promise<{ id: string; approved: string }> {
  const server = await serveFolder(await buildRendered(name), {}, "localhost", passOn("/designs", designs.port));
  const { page, complaints } = await openPage(browser, `${server.origin}/${name}.html`);
  await page.locator("texelcast-editor").waitFor({ state: "attached" });
  const approved = await personalise(page, page);
  await page.getByText("Prints: 1").waitFor();
  await page.locator("texelcast-editor [part~=submit-button]").click();
  await page.locator("[name=buy]:enabled").waitFor({ timeout: 30_000 });
  const id = await page.locator("[name=design]").inputValue();
  expect(complaints).toEqual([]);
  await page.close();
  await server.stop();
  return { id, approved: approved() };
}

const sha256 = (bytes: Uint8Array): string => createHash("sha256").update(bytes).digest("hex");

test("React, rendered on a server and hydrated: the page hears the element, and what was approved is printed", async () => {
  const designs = await startDesignsServer(installed.folder);
  const { id, approved } = await order("react", designs);
  const reply = await fetch(`http://localhost:${designs.port}/designs/${id}/print.png`);
  expect(sha256(new Uint8Array(await reply.arrayBuffer())), designs.faults()).toBe(approved);
  await designs.stop();
});

test("Next.js's guide: its page is rendered and hydrated, and its route prints what was approved", async () => {
  const designs = await startDesignsServer(join(installed.folder, "next"));
  const { id, approved } = await order("next", designs);
  expect(sha256(readFileSync(join(installed.folder, `next/designs/${id}.png`))), designs.faults()).toBe(approved);
  // A stranger's form asks for what would take minutes; refused before its design is read.
  const form = new FormData();
  form.append("print", '{"size":16384}');
  const asked = await fetch(`http://localhost:${designs.port}/designs`, { method: "POST", body: form });
  expect(asked.status).toBe(422);
  expect(designs.faults()).toBe("");
  await designs.stop();
});
