/**
 * The guides' own code in a real Chromium: each puts a picture on the mug, the customer is done, the page sends the design to the
 * guide's server, and that server's print file is the one that was approved.
 */
import { createHash } from "node:crypto";
import { join } from "node:path";
import type { Browser, Frame, Page } from "@playwright/test";
import { build as bundle } from "esbuild";
import { build } from "vite";
import { afterAll, beforeAll, expect, test, vi } from "vitest";
import { type DesignsServer, startDesignsServer } from "./support/designs-server.ts";
import { STORY_FILES } from "./support/engine-story.ts";
import { guideFiles, looseFences } from "./support/guide.ts";
import { addShopFiles, type InstalledPackage, installPackage } from "./support/installed.ts";
import { personalise } from "./support/personalise.ts";
import {
  openBrowser,
  openPage,
  passOn,
  type Route,
  STRICT_POLICY,
  type StaticServer,
  serveFolder,
} from "./support/serve.ts";
import { htmlOfPhp, renderSection } from "./support/theme.ts";

// Each is a whole product page, its finished texture and its print file, with graphics drawn in software.
vi.setConfig({ testTimeout: 120_000, hookTimeout: 120_000 });

const FILES = guideFiles();
const VARIANT = 4471;
const WOO_PRODUCT = "17";

let installed: InstalledPackage;
let browser: Browser;
let designs: DesignsServer;
let shop: StaticServer;
/** The editor's page has an origin of its own. */
let editor: StaticServer;
/** Bodies that came to the platforms' carts. */
const carted: unknown[] = [];

/** Shopify's and WooCommerce's, as far as the guides talk to them. */
const carts: Route = (request, response, path) => {
  if (path === "/cart") {
    response.writeHead(200, { "content-type": "text/html" }).end("<!doctype html><title>Cart</title>");
    return true;
  }
  if (request.method !== "POST" || !/^\/(cart\/add\.js|woocommerce\/cart)$/.test(path)) return false;
  let text = "";
  request.setEncoding("utf8").on("data", (more) => {
    text += more;
  });
  request.on("end", () => {
    carted.push(path.endsWith(".js") ? JSON.parse(text) : Object.fromEntries(new URLSearchParams(text)));
    response.writeHead(200, { "content-type": "text/html" }).end("<!doctype html><title>Cart</title>");
  });
  return true;
};

const page = (title: string, body: string): string =>
  `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>${title}</title></head><body>${body}</body></html>`;

beforeAll(async () => {
  installed = await installPackage();
  for (const name of ["three", "react", "react-dom", "vue", "@vitejs/plugin-vue"]) installed.provide(name);
  const { folder } = installed;
  addShopFiles(folder, { ...STORY_FILES, ...FILES, "favicon.ico": "" });
  designs = await startDesignsServer(folder);
  const below = passOn("/designs", designs.port);
  const proxy = passOn("/apps/designs", designs.port, "/designs");
  const route: Route = (...of) => below(...of) || proxy(...of) || carts(...of);
  shop = await serveFolder(folder, {}, "localhost", route);
  editor = await serveFolder(folder, { "content-security-policy": STRICT_POLICY }, "127.0.0.1");

  // The guides' two example hosts are the two origins here.
  const hosts = (text: string): string =>
    text.replaceAll("https://shop.example", shop.origin).replaceAll("https://editor.example", editor.origin);
  addShopFiles(folder, { "editor.js": hosts(FILES["editor.js"] ?? ""), "framed.js": hosts(FILES["framed.js"] ?? "") });

  const section = await renderSection(FILES["sections/texelcast-product.liquid"] ?? "", {
    section: { settings: { editor: `${editor.origin}/editor.html` } },
    product: {
      title: 'Mug "Ada"',
      selected_or_first_available_variant: { id: VARIANT },
      metafields: { texelcast: { model: { value: `${editor.origin}/mug.glb` } } },
    },
  });
  const plugin = htmlOfPhp(FILES["texelcast.php"] ?? "", {
    "esc_url(TEXELCAST_PAGE)": `${editor.origin}/editor.html`,
    "esc_url($model)": `${editor.origin}/mug.glb`,
  });
  addShopFiles(folder, {
    "shopify.html": page("Shopify", section),
    "woocommerce.html": page(
      "WooCommerce",
      `<form action="/woocommerce/cart" method="post">${plugin}
       <button name="add-to-cart" value="${WOO_PRODUCT}">Add to cart</button></form>
       <script type="module" src="/texelcast-woocommerce.js"></script>`,
    ),
  });
  for (const [entry, outfile] of [
    ["texelcast-product.js", "assets/texelcast-product.js"],
    ["woocommerce.js", "texelcast-woocommerce.js"],
  ] as const) {
    await bundle({
      absWorkingDir: folder,
      entryPoints: [entry],
      outfile,
      bundle: true,
      format: "esm",
      logLevel: "error",
    });
  }
  await buildFrameworks(folder);
  browser = await openBrowser();
});
afterAll(async () => {
  await browser?.close();
  await shop?.stop();
  await editor?.stop();
  await designs?.stop();
  installed?.remove();
});

/** React's page and Vue's in one build: Vue's settings are those of React and its compiler. */
async function buildFrameworks(folder: string): Promise<void> {
  const outDir = join(folder, "built");
  const entries = { react: "/react/main.jsx", vue: "/vue/main.js" };
  for (const [name, script] of Object.entries(entries)) {
    const body = `<div id="product"></div><script type="module" src="${script}"></script>`;
    addShopFiles(folder, { [`${name}.html`]: page(name, body) });
  }
  const input = Object.keys(entries).map((name) => join(folder, `${name}.html`));
  await build({
    root: folder,
    configFile: join(folder, "vue/vite.config.js"),
    logLevel: "error",
    build: { outDir, target: "es2022", rolldownOptions: { input } },
  });
  addShopFiles(outDir, { ...STORY_FILES, "favicon.ico": "" });
}

/** The framed editor, when it has answered. */
async function framed(opened: Page): Promise<Frame> {
  await opened.frameLocator("iframe").locator("texelcast-editor").waitFor({ state: "attached" });
  const frame = opened.frames().find((one) => one.url().startsWith(editor.origin));
  if (frame === undefined) throw new Error("the page has no editor in an iframe");
  return frame;
}

async function printedHash(design: string): Promise<string> {
  const reply = await fetch(`${shop.origin}/designs/${design}/print.png`);
  expect(reply.status, designs.faults()).toBe(200);
  return createHash("sha256")
    .update(new Uint8Array(await reply.arrayBuffer()))
    .digest("hex");
}

/** The editor's own button, then the id that the page got for the order: what was approved is what the server prints. */
async function expectApproved(opened: Page, place: Page | Frame): Promise<void> {
  const approved = await personalise(opened, place);
  await opened.getByText("Prints: 1").waitFor();
  await place.locator("texelcast-editor [part~=submit-button]").click();
  await opened.locator("[name=buy]:enabled").waitFor({ timeout: 30_000 });
  expect(await printedHash(await opened.locator("[name=design]").inputValue())).toBe(approved());
}

test("plain HTML: what the customer approved is what the guide's server prints, under a strict policy", async () => {
  const route = passOn("/designs", designs.port);
  const server = await serveFolder(installed.folder, { "content-security-policy": STRICT_POLICY }, "localhost", route);
  const { page: opened, complaints } = await openPage(browser, `${server.origin}/`);
  await expectApproved(opened, opened);
  expect(complaints).toEqual([]);
  await opened.close();
  await server.stop();
});

test("plain HTML with an import map shows the mug with the page's own three.js", async () => {
  const { page: opened, complaints } = await openPage(browser, `${shop.origin}/import-map.html`);
  await opened.evaluate(async () => {
    await customElements.whenDefined("texelcast-editor");
    await (document.querySelector("texelcast-editor") as HTMLElement & { start(): Promise<void> }).start();
  });
  expect(shop.served).toContain("/node_modules/three/build/three.module.js");
  expect(complaints).toEqual([]);
  await opened.close();
});

test.each(["react", "vue"])(
  "%s, built by Vite: what the customer approved is what the guide's server prints",
  async (name) => {
    const server = await serveFolder(
      join(installed.folder, "built"),
      {},
      "localhost",
      passOn("/designs", designs.port),
    );
    const { page: opened, complaints } = await openPage(browser, `${server.origin}/${name}.html`);
    await opened.locator("texelcast-editor").waitFor({ state: "attached" });
    await expectApproved(opened, opened);
    expect(complaints).toEqual([]);
    await opened.close();
    await server.stop();
  },
);

test("the iframe of another origin: what the customer approved is what the guide's server prints", async () => {
  const { page: opened, complaints } = await openPage(browser, `${shop.origin}/framed.html`);
  await expectApproved(opened, await framed(opened));
  expect(complaints).toEqual([]);
  await opened.close();
});

test("Shopify's section puts the design's id and the approved hash into the cart line's properties", async () => {
  const { page: opened, complaints } = await openPage(browser, `${shop.origin}/shopify.html`);
  const approved = await personalise(opened, await framed(opened));
  await opened.getByLabel("Pieces").fill("3");
  await opened.getByRole("button", { name: "Add to cart" }).click();
  await opened.waitForURL(`${shop.origin}/cart`);
  const [{ items }] = carted.splice(0) as [{ items: [{ properties: { _design: string } }] }];
  expect(items).toEqual([
    {
      id: VARIANT,
      quantity: 3,
      properties: { _design: expect.any(String), _approved: approved(), Personalised: "Yes" },
    },
  ]);
  expect(await printedHash(items[0].properties._design)).toBe(approved());
  expect(complaints).toEqual([]);
  await opened.close();
});

test("WooCommerce's plugin is PHP, and its page and script send the design's id with the product's form", async () => {
  const { page: opened, complaints } = await openPage(browser, `${shop.origin}/woocommerce.html`);
  const approved = await personalise(opened, await framed(opened));
  await opened.getByRole("button", { name: "Add to cart" }).click();
  await opened.waitForURL(`${shop.origin}/woocommerce/cart`);
  const [sent] = carted.splice(0) as [{ texelcast_design: string }];
  expect(sent).toEqual({ texelcast_design: expect.any(String), "add-to-cart": WOO_PRODUCT });
  // What the plugin takes for an id.
  const [, id = ""] = /TEXELCAST_ID = '\/(.*)\/'/.exec(FILES["texelcast.php"] ?? "") ?? [];
  expect(sent.texelcast_design).toMatch(new RegExp(id));
  expect(await printedHash(sent.texelcast_design)).toBe(approved());
  expect(complaints).toEqual([]);
  await opened.close();
});

test("the guide's server prints nothing that was not approved, and keeps no file under a name that is not its hash", async () => {
  const logo = STORY_FILES["logo.png"];
  const hash = createHash("sha256").update(logo).digest("hex");
  const send = async (name: string): Promise<Response> => {
    const form = new FormData();
    form.append("design", STORY_FILES["design.json"].replace("logo.png", `assets/${hash}.png`));
    form.append("print", JSON.stringify({ size: 64 }));
    form.append("approved", "0".repeat(64));
    form.append(name, new Blob([logo]));
    return await fetch(`${shop.origin}/designs`, { method: "POST", body: form });
  };
  expect((await send("../../stolen")).status).toBe(422);
  const { id } = (await (await send(hash)).json()) as { id: string };
  expect((await fetch(`${shop.origin}/designs/${id}/print.png`)).status).toBe(409);
});

test("every piece of code in the guides is run by a test", () => {
  expect(looseFences()).toEqual([]);
});
