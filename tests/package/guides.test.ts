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
import { customer, personalise } from "./support/personalise.ts";
import {
  holdBack,
  makeGate,
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
const LOGO_HASH = createHash("sha256").update(STORY_FILES["logo.png"]).digest("hex");
const NOBODY = "00000000-0000-4000-8000-000000000000";
const WOO_PRODUCT = "17";

let installed: InstalledPackage;
let browser: Browser;
let designs: DesignsServer;
let shop: StaticServer;
/** The editor's page has an origin of its own. */
let editor: StaticServer;
/** The web server's way to the guide's server. */
let below: Route;
let mayBeSaved = Promise.resolve();
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
  const toDesigns = passOn("/designs", designs.port);
  below = (request, response, path) => {
    // A body that a browser's test tools held back would come without its files.
    if (request.method === "POST" && path === "/designs")
      void mayBeSaved.then(() => toDesigns(request, response, path));
    else return toDesigns(request, response, path);
    return true;
  };
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
      variants: [
        { id: VARIANT, title: "Small", available: true },
        { id: VARIANT + 1, title: "Large & red", available: true },
        { id: VARIANT + 2, title: "Huge", available: false },
      ],
      metafields: { texelcast: { model: { value: `${editor.origin}/mug.glb` } } },
    },
  });
  const plugin = htmlOfPhp(FILES["texelcast.php"] ?? "", {
    "esc_url(TEXELCAST_PAGE)": `${editor.origin}/editor.html`,
    "esc_url($model)": `${editor.origin}/mug.glb`,
  });
  addShopFiles(folder, {
    "shopify.html": page("Shopify", `<div class="shopify-section">${section}</div>`),
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

const ordered = (opened: Page): Promise<string> => opened.locator("[name=design]").inputValue();

/** The editor's own button, then the id that the page got for the order: what was approved is what the server prints. */
async function expectApproved(opened: Page, place: Page | Frame): Promise<void> {
  const approved = await personalise(opened, place);
  await opened.getByText("Prints: 1").waitFor();
  await handIn(opened, place);
  expect(await printedHash(await ordered(opened))).toBe(approved());
}

async function handIn(opened: Page, place: Page | Frame): Promise<void> {
  await place.locator("texelcast-editor [part~=submit-button]").click();
  await opened.locator("[name=buy]:enabled").waitFor({ timeout: 30_000 });
}

/** Goes on after an approved design, once it was saved and once while it is: neither may be ordered any more. */
async function expectOnlyNewest(opened: Page, place: Page | Frame): Promise<void> {
  const { addText } = customer(place);
  await addText("second");
  await opened.getByText("Prints: 2").waitFor();
  await expectNothingToBuy(opened);

  const saving = makeGate();
  mayBeSaved = saving.open;
  await place.locator("texelcast-editor [part~=submit-button]").click();
  await opened.getByText("Saving your design").waitFor();
  await addText("third");
  await opened.getByText("Prints: 3").waitFor();
  const answered = opened.waitForResponse(/\/designs$/);
  saving.letGo();
  expect((await answered).status()).toBe(201);
  await opened.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
  await expectNothingToBuy(opened);

  await handIn(opened, place);
  const reply = await fetch(`${shop.origin}/designs/${await ordered(opened)}/design.json`);
  expect(((await reply.json()) as { layers: unknown[] }).layers).toHaveLength(3);
}

/** Goes on typing in the words that were put on last and are approved: from the first letter on they may not be ordered. */
async function expectNotTheOldWords(opened: Page, place: Page | Frame): Promise<void> {
  // The change that tells of them at last is kept away: it is not to be what does it.
  await place.evaluate(() => addEventListener("change", (event) => event.stopImmediatePropagation(), true));
  await place.locator("texelcast-editor textarea").press("End");
  await opened.keyboard.type("s");
  await opened.locator("[name=buy]:disabled").waitFor();
}

const expectNothingToBuy = async (opened: Page): Promise<void> =>
  expect(await opened.locator("[name=buy]").isDisabled()).toBe(true);

test("plain HTML: what the customer approved is what the guide's server prints, under a strict policy", async () => {
  const server = await serveFolder(installed.folder, { "content-security-policy": STRICT_POLICY }, "localhost", below);
  const { page: opened, complaints } = await openPage(browser, `${server.origin}/`);
  await expectApproved(opened, opened);
  await expectOnlyNewest(opened, opened);
  await expectNotTheOldWords(opened, opened);
  expect(complaints).toEqual([]);
  await opened.close();
  await server.stop();
});

test("plain HTML: what was saved is shown again by its address, with the same hash", async () => {
  const { page: opened, complaints } = await openPage(browser, `${shop.origin}/`);
  const approved = await personalise(opened, opened);
  await handIn(opened, opened);
  const address = `/designs/${await ordered(opened)}/design.json`;
  await opened.reload();
  expect(await customer(opened).textureOf(address)).toBe(approved());
  expect(complaints).toEqual([]);
  await opened.close();
});

test("plain HTML: a customer is told in words that a design could not be saved, and why, and can try again", async () => {
  const { page: opened } = await openPage(browser, `${shop.origin}/`);
  await personalise(opened, opened);
  const done = opened.locator("texelcast-editor [part~=submit-button]");
  const status = opened.locator("form [role=status]");
  for (const [answer, words] of [
    [null, "no connection"],
    [413, "too large"],
    [422, "422"],
    [503, "503"],
  ] as const) {
    await opened.route(/\/designs$/, (route) => (answer === null ? route.abort() : route.fulfill({ status: answer })));
    await done.click();
    await status.getByText(words).waitFor();
    expect(await status.textContent()).toContain("Your design could not be saved");
    await expectNothingToBuy(opened);
    await opened.unroute(/\/designs$/);
  }
  await handIn(opened, opened);
  await opened.close();
});

test("plain HTML: a product with nothing on it is not for sale as a personalised one", async () => {
  const { page: opened } = await openPage(browser, `${shop.origin}/`);
  await customer(opened).start();
  await opened.locator("texelcast-editor [part~=submit-button]").click();
  await opened.getByText("Put a picture or words on it first.").waitFor();
  await expectNothingToBuy(opened);
  await opened.close();
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

test("plain HTML: nothing in the page moves when the element comes", async () => {
  const opened = await browser.newPage({ viewport: { width: 390, height: 844 } });
  await opened.addInitScript(() => {
    const shifts: number[] = [];
    Object.assign(globalThis, { shifts });
    new PerformanceObserver((list) => {
      for (const { value } of list.getEntries() as (PerformanceEntry & { value: number })[]) shifts.push(value);
    }).observe({ type: "layout-shift", buffered: true });
  });
  const scripts = await holdBack(opened, /\/dist\/standalone\.js$/);
  await opened.goto(`${shop.origin}/`, { waitUntil: "commit" });
  // What is there before it has been drawn: a place that is taken later would move what stands below.
  await opened.locator("texelcast-editor").waitFor({ state: "attached" });
  await opened.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve, 100))));
  scripts.letGo();
  await customer(opened).start();
  const moved = await opened.evaluate(() => (globalThis as unknown as { shifts: number[] }).shifts);
  // Search engines call 0.1 good; the bar that the element has for a moment is 0.002.
  expect(moved.reduce((sum, shift) => sum + shift, 0)).toBeLessThan(0.05);
  await opened.close();
});

test.each(["react", "vue"])(
  "%s, built by Vite: what the customer approved is what the guide's server prints",
  async (name) => {
    const server = await serveFolder(join(installed.folder, "built"), {}, "localhost", below);
    const { page: opened, complaints } = await openPage(browser, `${server.origin}/${name}.html`);
    await opened.locator("texelcast-editor").waitFor({ state: "attached" });
    await expectApproved(opened, opened);
    await expectOnlyNewest(opened, opened);
    await expectNotTheOldWords(opened, opened);
    expect(complaints).toEqual([]);
    await opened.close();
    await server.stop();
  },
);

test("the iframe of another origin: what the customer approved is what the guide's server prints", async () => {
  const { page: opened, complaints } = await openPage(browser, `${shop.origin}/framed.html`);
  const frame = await framed(opened);
  await expectApproved(opened, frame);
  await expectOnlyNewest(opened, frame);
  await expectNotTheOldWords(opened, frame);
  expect(complaints).toEqual([]);
  await opened.close();
});

test("the iframe's page says what is wrong where the editor's page cannot be mounted, and fits a phone", async () => {
  const script = (FILES["framed.js"] ?? "").replace("https://editor.example/editor.html", "/editor.html");
  const opened = await browser.newPage({ viewport: { width: 390, height: 844 }, isMobile: true });
  await opened.route("**/framed.js", (route) => route.fulfill({ body: script, contentType: "text/javascript" }));
  await opened.goto(`${shop.origin}/framed.html`);
  await opened.getByText("The editor's page needs a whole http(s) address.").waitFor();
  expect(await opened.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
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

test("Shopify's section sells the variant that is chosen, and none without its design while the editor is still coming", async () => {
  const opened = await browser.newPage();
  const editorsPage = await holdBack(opened, /\/editor\.html/);
  await opened.goto(`${shop.origin}/shopify.html`, { waitUntil: "domcontentloaded" });
  const variant = opened.getByLabel("Variant");
  expect(await variant.inputValue()).toBe(String(VARIANT));
  await variant.selectOption("Large & red");
  await opened.getByRole("button", { name: "Add to cart" }).click();
  await opened.getByText("Making your print file").waitFor();
  expect(carted.splice(0)).toEqual([]);
  editorsPage.letGo();
  await opened.getByText("Put a picture or words on it first.").waitFor();

  await personalise(opened, await framed(opened));
  await opened.getByRole("button", { name: "Add to cart" }).click();
  await opened.waitForURL(`${shop.origin}/cart`);
  expect(carted.splice(0)).toMatchObject([{ items: [{ id: VARIANT + 1 }] }]);
  await opened.close();
});

test("Shopify's theme editor lays the section anew, and the editor comes again", async () => {
  const { page: opened, complaints } = await openPage(browser, `${shop.origin}/shopify.html`);
  await framed(opened);
  await opened.evaluate(async () => {
    const section = document.querySelector(".shopify-section") as HTMLElement;
    const fresh = new DOMParser().parseFromString(await (await fetch(location.href)).text(), "text/html");
    section.innerHTML = fresh.querySelector(".shopify-section")?.innerHTML ?? "";
    section.dispatchEvent(new CustomEvent("shopify:section:load", { bubbles: true }));
  });
  await opened.locator("iframe").waitFor();
  await personalise(opened, await framed(opened));
  await opened.getByRole("button", { name: "Add to cart" }).click();
  await opened.waitForURL(`${shop.origin}/cart`);
  expect(carted.splice(0)).toHaveLength(1);
  expect(complaints).toEqual([]);
  await opened.close();
});

test("WooCommerce's form is not sent without its design while the editor is still coming", async () => {
  const opened = await browser.newPage();
  const editorsPage = await holdBack(opened, /\/editor\.html/);
  await opened.goto(`${shop.origin}/woocommerce.html`, { waitUntil: "domcontentloaded" });
  await opened.getByRole("button", { name: "Add to cart" }).click();
  await opened.getByText("Making your print file").waitFor();
  editorsPage.letGo();
  await opened.getByText("Put a picture or words on it first.").waitFor();
  expect(carted.splice(0)).toEqual([]);
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

test("WooCommerce's form, where the cart leaves the page there, sends no old words with those that are typed", async () => {
  const { page: opened } = await openPage(browser, `${shop.origin}/woocommerce.html`);
  const sent: string[] = [];
  await opened.route("**/woocommerce/cart", (route) => {
    sent.push(new URLSearchParams(route.request().postData() ?? "").get("texelcast_design") ?? "");
    return route.fulfill({ status: 204 });
  });
  const frame = await framed(opened);
  await customer(frame).start();
  await customer(frame).addText("Ada");
  const button = opened.getByRole("button", { name: "Add to cart" });
  await button.click();
  await expect.poll(() => sent, { timeout: 30_000 }).toHaveLength(1);
  await frame.evaluate(() => addEventListener("change", (event) => event.stopImmediatePropagation(), true));
  await frame.locator("texelcast-editor textarea").press("End");
  await opened.keyboard.type("s");
  await button.click();
  await expect.poll(() => sent, { timeout: 30_000 }).toHaveLength(2);
  const reply = await fetch(`${shop.origin}/designs/${sent[1]}/design.json`);
  expect(((await reply.json()) as { layers: unknown[] }).layers).toMatchObject([{ text: "Adas" }]);
  await opened.close();
});

/** A form as the page's half sends it, with what a stranger would change about it. */
function sentDesign(
  changes: Readonly<Record<string, string | null>> = {},
  fileName = LOGO_HASH,
  file: BlobPart = STORY_FILES["logo.png"],
): FormData {
  const form = new FormData();
  const parts = {
    design: STORY_FILES["design.json"].replace("logo.png", `assets/${LOGO_HASH}.png`),
    print: JSON.stringify({ size: 64 }),
    approved: "0".repeat(64),
    ...changes,
  };
  for (const [name, text] of Object.entries(parts)) if (text !== null) form.append(name, text);
  form.append(fileName, new Blob([file]));
  return form;
}
/** A design whose own picture is no picture, though its name is the hash of what it is. */
function brokenPicture(): Parameters<typeof sentDesign> {
  const hash = createHash("sha256").update("no picture").digest("hex");
  return [{ design: STORY_FILES["design.json"].replace("logo.png", `assets/${hash}.png`) }, hash, "no picture"];
}
const send = (body: FormData, query = ""): Promise<Response> =>
  fetch(`${shop.origin}/designs${query}`, { method: "POST", body });

test("the guide's server prints nothing that was not approved, and keeps no file under a name that is not its hash", async () => {
  expect((await send(sentDesign({}, "../../stolen"))).status).toBe(422);
  const { id } = (await (await send(sentDesign())).json()) as { id: string };
  expect((await fetch(`${shop.origin}/designs/${id}/print.png`)).status).toBe(409);
});

test.each<[string, FormData]>([
  ["a design that is none", sentDesign({ design: "{}" })],
  ["no design", sentDesign({ design: null })],
  ["no print", sentDesign({ print: null })],
  ["a print that is no object", sentDesign({ print: "null" })],
  ["a print that takes minutes", sentDesign({ print: '{"size":16384}' })],
  ["a print of a size that is none", sentDesign({ print: '{"size":"64"}' })],
  ["a material that the model does not have", sentDesign({ print: '{"material":9}' })],
  ["a material by name", sentDesign({ print: '{"material":"mug"}' })],
  ["a picture that is none", sentDesign(...brokenPicture())],
  ["no approved hash", sentDesign({ approved: null })],
  ["a file of the design missing", sentDesign({ design: STORY_FILES["design.json"].replace("logo", "other") })],
])("the guide's server refuses %s while the customer is there", async (_, form) => {
  expect((await send(form)).status).toBe(422);
});

test("the guide's server answers while it prints, and prints one after the other", async () => {
  const { id } = (await (await send(sentDesign({ print: JSON.stringify({ size: 2048 }) }))).json()) as { id: string };
  const ended: string[] = [];
  const ask = async (path: string, as: string): Promise<void> => {
    expect((await fetch(`${shop.origin}/designs/${id}/${path}`)).ok).toBe(path === "design.json");
    ended.push(as);
  };
  const prints = [ask("print.png", "first print"), ask("print.png", "second print")];
  await ask("design.json", "design");
  await Promise.all(prints);
  expect(ended).toEqual(["design", "first print", "second print"]);
});

test("the guide's server takes what Shopify's app proxy adds to an address", async () => {
  const reply = await send(sentDesign(), "?shop=ada.myshopify.com&path_prefix=%2Fapps%2Fdesigns&signature=ab");
  expect(reply.status).toBe(201);
});

test("the guide's server gives a kept file to no script and no frame, and nothing by another name", async () => {
  const { id } = (await (await send(sentDesign())).json()) as { id: string };
  const get = (path: string): Promise<Response> => fetch(`${shop.origin}/designs/${path}`);
  const file = await get(`${id}/assets/${LOGO_HASH}.png`);
  expect(new Uint8Array(await file.arrayBuffer())).toEqual(new Uint8Array(STORY_FILES["logo.png"]));
  expect(file.headers.get("content-type")).toBe("application/octet-stream");
  expect(file.headers.get("x-content-type-options")).toBe("nosniff");
  const strange = [
    `${id}/approved`,
    `${id}/assets/..%2fapproved`,
    `${id}/assets/${"0".repeat(64)}.png`,
    `${NOBODY}/print.png`,
  ];
  for (const path of strange) expect((await get(path)).status, path).toBe(404);
});

test("every piece of code in the guides is run by a test", () => {
  expect(looseFences()).toEqual([]);
});
