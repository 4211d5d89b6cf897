/** The pages that are opened: a plain one with the package, and the example shop's. */
import { mkdtempSync, rmSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import type { FastifyInstance } from "fastify";
import { createEditorServer, type ShopOrigins } from "../../node/storefront/editor-server.ts";
import { createShopServer } from "../../node/storefront/shop-server.ts";
import type { Answer, SlowNetwork, Source } from "./slow-server.ts";

const inRoot = (name: string): string => fileURLToPath(new URL(`../../${name}`, import.meta.url));
export const DIST = inRoot("build/package/dist");
const SITE = inRoot("build/storefront");
const PRESS = new URL("../../build/node/storefront-press.mjs", import.meta.url);

const TYPES: Readonly<Record<string, string>> = {
  ".js": "text/javascript",
  ".wasm": "application/wasm",
  ".webp": "image/webp",
  ".glb": "model/gltf-binary",
  ".ttf": "font/ttf",
};

const plainPage = (head: string): string => `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <title>Mug</title>
    <link rel="icon" href="data:," />
    ${head}
  </head>
  <body>
    <texelcast-editor src="/mug.glb" poster="/mug.webp" mode="shop" loading="eager"></texelcast-editor>
  </body>
</html>`;

const PLAIN_PAGES: Readonly<Record<string, string>> = {
  "/": plainPage('<script type="module" src="/dist/standalone.js"></script>'),
  // What is three.js's and what is ours are files of their own here.
  "/map.html": plainPage(`<script type="importmap">{ "imports": {
      "three": "/three/build/three.module.js",
      "three/": "/three/"
    } }</script>
    <script type="module" src="/dist/define.js"></script>`),
};

const FILES: readonly (readonly [below: string, file: string])[] = [
  ["/dist/", `${DIST}/`],
  ["/three/", inRoot("node_modules/three/")],
  ["/mug.glb", inRoot("build/public/demo/mug.glb")],
  ["/mug.webp", inRoot("build/public/shop/mug-plain.webp")],
];

const plain: Source = async (asked) => {
  const page = PLAIN_PAGES[asked];
  if (page !== undefined) return { status: 200, headers: { "content-type": "text/html" }, body: Buffer.from(page) };
  const [below, file] = FILES.find(([start]) => asked.startsWith(start)) ?? ["", ""];
  const body = await readFile(file + asked.slice(below.length)).catch(() => null);
  if (body === null) throw new Error(`the page asked for ${asked}`);
  return { status: 200, headers: { "content-type": TYPES[path.extname(asked)] ?? "application/octet-stream" }, body };
};

const behind =
  (app: FastifyInstance): Source =>
  async (url): Promise<Answer> => {
    const { statusCode: status, headers, rawPayload: body } = await app.inject(url);
    const told = Object.entries(headers).filter(([name]) => !/^(content-length|connection|date)$/.test(name));
    return { status, headers: Object.fromEntries(told.map(([name, value]) => [name, String(value)])), body };
  };

export interface Addresses {
  readonly html: string;
  /** The same page with an import map. */
  readonly map: string;
  readonly shop: string;
  readonly framed: string;
  stop(): Promise<void>;
}

export async function serveAll(network: SlowNetwork): Promise<Addresses> {
  const folder = mkdtempSync(path.join(tmpdir(), "texelcast-load-"));
  const origins: ShopOrigins = { shop: null, editor: null };
  const store = path.join(folder, "files");
  const { app } = await createShopServer({
    site: SITE,
    store,
    database: ":memory:",
    origins,
    press: { script: PRESS },
  });
  const editor = await createEditorServer(SITE, origins);
  origins.shop = await network.serve(behind(app));
  origins.editor = await network.serve(behind(editor));
  const product = `${origins.shop}/product.html?product=mug`;
  const html = `${await network.serve(plain)}/`;
  return {
    html,
    map: `${html}map.html`,
    shop: product,
    framed: `${product}&editor=iframe`,
    stop: async () => {
      network.stop();
      await Promise.all([app.close(), editor.close()]);
      rmSync(folder, { recursive: true, force: true });
    },
  };
}
