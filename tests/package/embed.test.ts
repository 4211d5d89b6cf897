/** The iframe in a real Chromium: shop and editor on two origins, and a third that means no good. */
import type { Browser, Page } from "@playwright/test";
import { afterAll, afterEach, beforeAll, beforeEach, expect, test } from "vitest";
import { STORY_FILES } from "./support/engine-story.ts";
import { addShopFiles, type InstalledPackage, installPackage } from "./support/installed.ts";
import { openBrowser, openPage, STRICT_POLICY, type StaticServer, serveFolder } from "./support/serve.ts";

const DIST = "/node_modules/texelcast/dist";
const NONCE = "0123456789abcdef0123456789abcdef";

const page = (script: string): string =>
  `<!doctype html><html lang="en"><title>Page</title><link rel="icon" href="data:," /><body></body>
<script type="module" src="${script}"></script></html>`;

/** The editor's page with an element of a few lines, which notes what it was asked. */
const STUB_HOST = `
import { hostEditor } from "${DIST}/host.js";
const editor = document.createElement("div");
Object.assign(editor, {
  undo: () => true,
  redo: () => { throw Object.assign(new Error("nothing to redo"), { code: "x" }); },
  start: () => new Promise(() => {}),
  addDecal: async (bytes, { name }) => {
    const accepted = await editor.beforeAccept({ name });
    editor.dispatchEvent(new CustomEvent("change", { detail: { counts: { decals: accepted ? 1 : 0 } } }));
    return accepted ? name + bytes.length : "refused";
  },
  addText: (text) => Promise.resolve(editor.beforeAccept?.({ name: text }) ?? "not asked").catch((error) => error.message),
});
document.body.append(editor);
globalThis.host = hostEditor(editor, { shops: [new URL(location.href).searchParams.get("shop")] });
globalThis.editor = editor;
`;

/** An editor's page that sends what a broken or hostile one might. */
const FALSE_HOST = `
const shop = new URL(location.href).searchParams.get("shop");
const hello = { texelcast: "hello", version: 1, nonce: "${NONCE}" };
addEventListener("message", ({ data, ports: [port] }) => {
  port.onmessage = ({ data: { id, method } }) => {
    for (const message of ["noise", { kind: "result" }, { kind: "result", id: id + 999, value: 1 }]) port.postMessage(message);
    if (method !== "set") return;
    port.postMessage({ kind: "result", id });
    port.postMessage({ kind: "result", id });
    parent.postMessage(hello, shop);
  };
});
for (const message of [{ ...hello, nonce: "short" }, { texelcast: "hello" }, hello]) parent.postMessage(message, shop);
`;

/** A third party in the shop's page: speaks to the shop and to the editor as if it were the other. */
const MEDDLER = `
parent.postMessage({ texelcast: "hello", version: 1, nonce: "${NONCE}" }, "*");
const { port2 } = new MessageChannel();
parent.frames[0].postMessage({ texelcast: "connect", version: 1, nonce: "${NONCE}" }, "*", [port2]);
document.title = "done";
`;

const REAL_HOST = `
import { hostEditor } from "${DIST}/host.js";
import { TexelcastEditor } from "${DIST}/standalone.js";
const editor = new TexelcastEditor();
editor.style.cssText = "display: block; inline-size: 500px; block-size: 400px";
hostEditor(editor, { shops: null });
document.body.append(editor);
`;

const SHOP = `import { mountTexelcast } from "${DIST}/embed.js"; globalThis.mountTexelcast = mountTexelcast;`;

let installed: InstalledPackage;
let browser: Browser;
let shop: StaticServer;
let editor: StaticServer;
let opened: { page: Page; complaints: string[] };

beforeAll(async () => {
  installed = await installPackage();
  const scripts = { shop: SHOP, stub: STUB_HOST, false: FALSE_HOST, meddler: MEDDLER, real: REAL_HOST };
  const pages = Object.entries(scripts).flatMap(([name, script]) => [
    [`${name}.html`, page(`/${name}.js`)],
    [`${name}.js`, script],
  ]);
  addShopFiles(installed.folder, { ...STORY_FILES, ...(Object.fromEntries(pages) as Record<string, string>) });
  editor = await serveFolder(installed.folder, { "content-security-policy": STRICT_POLICY }, "127.0.0.1");
  // A shop's policy names the editor's origin, and nothing else for it.
  const policy = `${STRICT_POLICY}; frame-src ${editor.origin}`;
  shop = await serveFolder(installed.folder, { "content-security-policy": policy });
  browser = await openBrowser();
});
afterAll(async () => {
  await browser?.close();
  await shop?.stop();
  await editor?.stop();
  installed?.remove();
});

beforeEach(async () => {
  opened = await openPage(browser, `${shop.origin}/shop.html`);
  await opened.page.waitForFunction(() => "mountTexelcast" in globalThis);
});
afterEach(() => opened.page.close());

/** Mounts in the shop's page, and runs a function there with the frame; gives its result, or the error's code. */
async function inShop(host: string, body: string, options = "{}"): Promise<unknown> {
  return await opened.page.evaluate(
    `(async () => {
      try {
        const frame = await mountTexelcast(document.body, { page: "${editor.origin}/${host}.html", ...${options} });
        globalThis.frame = frame;
        return await (async () => { ${body} })();
      } catch (error) { return error.code + ": " + error.message; }
    })()`,
  );
}

test("the shop drives the element of another origin, is asked about pictures and hears of changes", async () => {
  const told = await inShop(
    "stub",
    `const changes = [];
     frame.addEventListener("change", ({ detail }) => changes.push(detail.counts.decals));
     const first = await frame.addDecal(new Uint8Array(3), { name: "good" });
     const second = await frame.addDecal(new Uint8Array(3), { name: "bad" });
     return { first, second, changes, undone: await frame.undo(), ignored: frame.ignoredMessages,
              sandbox: frame.iframe.getAttribute("sandbox") };`,
    `{ maxDecals: 3, beforeAccept: ({ name }) => name === "good" }`,
  );
  expect(told).toEqual({
    first: "good3",
    second: "refused",
    changes: [1, 0],
    undone: true,
    ignored: 0,
    sandbox: "allow-scripts allow-same-origin allow-downloads",
  });
  const [, frame] = opened.page.frames();
  expect(await frame?.evaluate("editor.maxDecals")).toBe(3);
  expect(opened.complaints).toEqual([]);
});

test("the shop hears of what is typed at once, before it is a change, and of nothing else that it says", async () => {
  const heard = await inShop(
    "stub",
    `const inputs = [];
     frame.addEventListener("input", ({ detail }) => inputs.push(detail));
     globalThis.inputs = inputs;
     return inputs;`,
  );
  expect(heard).toEqual([]);
  const [, frame] = opened.page.frames();
  await frame?.evaluate(
    `const field = document.createElement("textarea");
     editor.append(field);
     field.dispatchEvent(new InputEvent("input", { bubbles: true, composed: true, data: "secret" }));`,
  );
  await expect.poll(() => opened.page.evaluate("globalThis.inputs")).toEqual([null]);
});

test("what the shop's hook answers reaches the element as it is, and without a hook nothing is asked", async () => {
  const answers =
    "{ yes: true, no: false, nothing: null, plain: { accept: true }, told: { accept: false, reason: 'Not here.' } }";
  const told = await inShop(
    "stub",
    `const said = {};
     for (const name of ["yes", "no", "forgotten", "nothing", "plain", "told", "broken"]) said[name] = await frame.addText(name);
     return said;`,
    `{ beforeAccept: async ({ name }) => { if (name === "broken") throw new Error("down"); return (${answers})[name]; } }`,
  );
  expect(told).toEqual({
    yes: true,
    no: false,
    forgotten: undefined,
    nothing: null,
    plain: { accept: true },
    told: { accept: false, reason: "Not here." },
    broken: expect.stringContaining("down"),
  });
  for (const none of ["{}", "{ beforeAccept: null }"]) {
    expect(await inShop("stub", `return await frame.addText("any");`, none)).toBe("not asked");
  }
});

test("a picture and words may wait for the shop's people as long as their answer may take", async () => {
  const { page: shopPage } = opened;
  await shopPage.clock.install();
  await inShop(
    "stub",
    `frame.all = Promise.all([frame.addDecal(new Uint8Array(3), { name: "logo" }), frame.addText("Moin")]);`,
    `{ beforeAccept: () => new Promise((resolve) => { setTimeout(resolve, 100_000, true); (globalThis.asked ??= []).push(1); }) }`,
  );
  // Not waitForFunction: what it asks again it evaluates as a text in the page, whose policy forbids that.
  await expect.poll(() => shopPage.evaluate("globalThis.asked?.length")).toBe(2);
  const all = shopPage.evaluate("frame.all.catch((error) => error.code)");
  await shopPage.clock.runFor(110_000);
  expect(await all).toEqual(["logo3", true]);
});

test("an error of the element comes over with its words, silence is given up, and what ends says so", async () => {
  const { page: shopPage } = opened;
  // What is given up is given up by the clock, however long the editor's page takes to be there.
  await shopPage.clock.install();
  await inShop(
    "stub",
    `globalThis.codeOf = (promise) => promise.then(() => "none", (error) => error.code);
     globalThis.silent = codeOf(frame.start());`,
  );
  await shopPage.clock.runFor(130_000);
  const told = await shopPage.evaluate(
    `(async () => {
       const failed = await codeOf(frame.redo());
       const unsendable = await codeOf(frame.addText(() => {}));
       const waiting = codeOf(frame.start());
       frame.unmount();
       return [failed, await silent, unsendable, await waiting, await codeOf(frame.undo()), document.querySelector("iframe")];
     })()`,
  );
  expect(told).toEqual(["internal", "timeout", "bad-argument", "disposed", "disposed", null]);
});

test("an iframe that is moved in the page is driven anew: what was on its way is called off, and told", async () => {
  const told = await inShop(
    "stub",
    `const codeOf = (promise) => promise.then((value) => value, (error) => error.code);
     const unheard = [];
     addEventListener("unhandledrejection", ({ reason }) => unheard.push(String(reason)));
     const errors = [];
     frame.addEventListener("error", ({ detail }) => errors.push(detail.code));
     let signal;
     globalThis.hook = (asked) => { signal = asked; return new Promise(() => {}); };
     await frame.set({ locale: "de", wording: { submit: "In den Korb" } });
     const waiting = [codeOf(frame.start()), codeOf(frame.addDecal(new Uint8Array(3), { name: "logo" })), frame.start().catch(() => {})];
     while (!signal) await frame.undo();
     frame.validate();
     const box = document.createElement("div");
     document.body.append(box);
     box.append(frame.iframe);
     // At once, and when the page is there again.
     const later = await Promise.all([codeOf(frame.undo()), codeOf(frame.set({ size: 512 }))]);
     globalThis.hook = () => true;
     later.push(await frame.addDecal(new Uint8Array(3), { name: "logo" }));
     return { waiting: await Promise.all(waiting), aborted: signal.aborted, later, errors, unheard, ignored: frame.ignoredMessages };`,
    `{ maxDecals: 3, beforeAccept: (asset, { signal }) => hook(signal) }`,
  );
  expect(told).toEqual({
    waiting: ["cancelled", "cancelled", undefined],
    aborted: true,
    later: [true, undefined, "logo3"],
    errors: ["cancelled"],
    unheard: [],
    ignored: 0,
  });
  const frame = opened.page.frames().at(-1);
  const properties = await frame?.evaluate("[editor.maxDecals, editor.locale, editor.wording.submit, editor.size]");
  expect(properties).toEqual([3, "de", "In den Korb", 512]);
  expect(opened.complaints).toEqual([]);
});

test("malformed, repeated and unasked-for messages of the editor's page are ignored and counted", async () => {
  const { page: shopPage } = opened;
  await shopPage.clock.install();
  await inShop("false", `globalThis.silent = frame.undo().catch((error) => error.code);`);
  // Two hellos of no form, a second hello, three pieces of noise a request, and an answer that came twice.
  await expect.poll(() => shopPage.evaluate("frame.ignoredMessages")).toBe(2 + 1 + 3 + 3 + 1);
  await shopPage.clock.runFor(130_000);
  const told = await shopPage.evaluate("silent.then((code) => ({ silent: code, ignored: frame.ignoredMessages }))");
  expect(told).toEqual({ silent: "timeout", ignored: 2 + 1 + 3 + 3 + 1 });
});

test("a third window can be neither the shop nor the editor", async () => {
  await inShop("stub", "");
  const { page: shopPage } = opened;
  await shopPage.evaluate((address) => {
    const meddler = document.createElement("iframe");
    meddler.src = address;
    document.body.append(meddler);
  }, `${editor.origin}/meddler.html`);
  await expect.poll(() => shopPage.evaluate("frame.ignoredMessages")).toBe(1);
  const [, stub] = shopPage.frames();
  await expect.poll(() => stub?.evaluate("host.ignoredMessages")).toBe(1);
  expect(await shopPage.evaluate("frame.undo()")).toBe(true);
});

test("the editor's page takes one channel, from its shop's exact origin and for this load alone", async () => {
  const { page: shopPage } = opened;
  const nonce = await shopPage.evaluate(async (address) => {
    const iframe = document.createElement("iframe");
    const hello = new Promise<string>((resolve) => {
      addEventListener("message", ({ data }) => resolve(data.nonce), { once: true });
    });
    iframe.src = `${address}?shop=${location.origin}`;
    document.body.append(iframe);
    return await hello;
  }, `${editor.origin}/stub.html`);
  const [, stub] = shopPage.frames();
  const send = (message: unknown, withPort = true): Promise<void> =>
    shopPage.evaluate(([data, port]) => frames[0]?.postMessage(data, "*", port ? [new MessageChannel().port1] : []), [
      message,
      withPort,
    ] as const);
  const connect = { texelcast: "connect", version: 1, nonce };
  await send("noise");
  await send({ ...connect, nonce: NONCE });
  await send({ ...connect, version: 2 });
  await send(connect, false);
  await expect.poll(() => stub?.evaluate("host.ignoredMessages")).toBe(4);
  await send(connect);
  await send(connect);
  await expect.poll(() => stub?.evaluate("host.ignoredMessages")).toBe(5);
});

test("a shop may wait for as long as it likes: what no clock can count is not given up at once", async () => {
  for (const patience of ["Infinity", "2 ** 31", "1e12"]) {
    expect(await inShop("stub", "return [await frame.undo(), frame.unmount()];", `{ timeoutMs: ${patience} }`)).toEqual(
      [true, undefined],
    );
  }
});

test("properties that are none are refused as such, and the editor goes on", async () => {
  const told = await inShop(
    "stub",
    `const codeOf = (promise) => promise.then(() => "set", (error) => error.code + " " + error.field);
     return [await codeOf(frame.set(null)), await codeOf(frame.set()), await codeOf(frame.set("size")), await frame.undo()];`,
  );
  expect(told).toEqual(["bad-argument options", "bad-argument options", "bad-argument options", true]);
});

test("a page of another version, without an address or without an answer is refused", async () => {
  const refused = async (host: string): Promise<unknown> =>
    opened.page.evaluate(
      (address) =>
        (globalThis as unknown as { mountTexelcast: (at: Element, options: object) => Promise<unknown> })
          .mountTexelcast(document.body, { page: address, timeoutMs: 1000 })
          .then(
            () => "mounted",
            (error: { code: string }) => `${error.code}, ${document.querySelectorAll("iframe").length} left`,
          ),
      host,
    );
  expect(await refused("/stub.html")).toBe("bad-argument, 0 left");
  expect(await refused(`${editor.origin}/meddler.html`)).toBe("timeout, 0 left");
});

test("a page that its server or the shop lets nobody frame is given up half a minute after the browser has it", async () => {
  const { page } = opened;
  await page.clock.install();
  await page.route("**/refusing.html*", (route) =>
    route.fulfill({
      contentType: "text/html",
      body: "<title>Not here</title>",
      headers: { "X-Frame-Options": "DENY" },
    }),
  );
  const mounted = (options: string): Promise<string> =>
    page.evaluate(`(async () => {
      const loaded = new Promise((resolve) => document.addEventListener("load", resolve, { capture: true, once: true }));
      globalThis.told = "waits";
      mountTexelcast(document.body, { page: "${editor.origin}/refusing.html", ...${options} }).catch((error) => {
        globalThis.told = error.code + ": " + error.message + " " + error.hint;
      });
      await loaded;
    })()`);
  const told = async (): Promise<unknown> => page.evaluate("told");
  await mounted("{}");
  await page.clock.runFor(29_000);
  expect(await told()).toBe("waits");
  await page.clock.runFor(2000);
  expect(await told()).toMatch(/^timeout: .* 30 seconds.*frame-ancestors/);
  // A shop that says how long knows why.
  await mounted("{ timeoutMs: 60_000 }");
  await page.clock.runFor(59_000);
  expect(await told()).toBe("waits");
  await page.clock.runFor(2000);
  expect(await told()).toMatch(/^timeout: .* 60 seconds/);
  opened.complaints.length = 0;
});

test("the real element in the iframe takes a picture and exports the texture", async () => {
  const told = await inShop(
    "real",
    `await frame.start();
     const logo = new Uint8Array(await (await fetch("/logo.png")).arrayBuffer());
     const id = await frame.addDecal(logo, { name: "logo.png" });
     const { sha256, bytes } = await frame.exportTexture();
     const { assets } = await frame.exportDesign();
     return { id: typeof id, sha256: /^[0-9a-f]{64}$/.test(sha256), png: bytes[1], assets: assets.length };`,
    `{ src: "/mug.glb", size: 256, loading: "eager" }`,
  );
  expect(told).toEqual({ id: "string", sha256: true, png: 80, assets: 1 });
  expect(opened.complaints).toEqual([]);
});
