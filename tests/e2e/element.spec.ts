/** `<texelcast-editor>` on a shop's page: a customer's story, elements that come and go, and what must not get in. */
import { createHash } from "node:crypto";
import { expect, type Page, test } from "@playwright/test";
import type { ChangeDetail, ErrorDetail } from "../../web/element/element-api.ts";
import { seriousFaults, smallTargets } from "./support/page-faults.ts";
import { demoFile, file } from "./support/test-files.ts";

const ZONES = {
  texelcastZones: 1,
  zones: [
    {
      id: "wrap",
      name: "Wrap",
      shape: { kind: "box", position: [0, 0.05, 0.05], size: [0.1, 0.08, 0.1] },
      safe: 2,
      bleed: 1,
    },
  ],
};

interface Watched {
  readonly changes: ChangeDetail[];
  readonly errors: ErrorDetail[];
}

/** Opens the element's page; what the element tells is kept in `window.told`. */
async function openShop(page: Page, query = ""): Promise<void> {
  await page.goto(`element.html${query}`);
  await page.evaluate(() => {
    const told: Watched = { changes: [], errors: [] };
    Object.assign(window, { told });
    const editor = document.querySelector("texelcast-editor");
    editor?.addEventListener("change", ({ detail }) => told.changes.push(detail));
    editor?.addEventListener("error", ({ detail }) => told.errors.push(detail));
  });
}

const told = (page: Page): Promise<Watched> => page.evaluate(() => (window as unknown as { told: Watched }).told);
const lastChange = async (page: Page): Promise<ChangeDetail | undefined> => (await told(page)).changes.at(-1);
const codes = async (page: Page): Promise<string[]> => (await told(page)).errors.map(({ code }) => code);

test("a customer personalises a product, and the hash that is approved is that of the print file", async ({ page }) => {
  const requests: string[] = [];
  page.on("request", (request) => requests.push(request.url()));
  await openShop(page, "?loading=lazy");
  const editor = page.locator("texelcast-editor");
  await expect(editor.getByRole("button", { name: "Personalise" })).toBeVisible();
  // Until it is touched, nothing heavy has come.
  expect(requests.filter((url) => /\.(wasm|glb)$|worker/.test(url))).toEqual([]);
  expect(page.workers()).toHaveLength(0);

  await editor.evaluate((element: HTMLElementTagNameMap["texelcast-editor"], zones) => {
    element.zones = zones;
    element.beforeAccept = ({ name }) => (name.startsWith("banned") ? { accept: false, reason: "Not here." } : true);
  }, ZONES);
  await editor.getByRole("button", { name: "Personalise" }).click();
  const upload = async (...files: ReturnType<typeof file>[]): Promise<void> => {
    const chooser = page.waitForEvent("filechooser");
    await editor.getByRole("button", { name: "Add picture" }).click();
    await (await chooser).setFiles(files);
  };
  await upload({ ...demoFile("decals/flower.png"), name: "flower.png" });
  await expect(editor.getByRole("button", { name: "flower Picture" })).toHaveAttribute("aria-pressed", "true");

  // By number and by keyboard.
  const wide = editor.getByRole("spinbutton", { name: "Width, cm" });
  await wide.fill("1000000000");
  await page.keyboard.press("Enter");
  const widest = Number(await wide.getAttribute("aria-valuemax"));
  expect(widest, "ten times the mug, in centimetres").toBeLessThan(1000);
  await expect(wide).toHaveAttribute("aria-valuenow", String(widest));
  await wide.fill("3");
  await page.keyboard.press("Enter");
  await editor.getByRole("application").focus();
  await page.keyboard.press("Shift+ArrowLeft");
  await page.keyboard.press("]");
  await editor.getByRole("button", { name: "Add text" }).click();
  await expect(editor.getByRole("textbox", { name: "Words" })).toBeFocused();
  await page.keyboard.type("Moin");
  await page.keyboard.press("Tab");
  await expect.poll(async () => (await lastChange(page))?.counts).toEqual({ decals: 1, texts: 1, layers: 2 });
  await expect.poll(async () => (await lastChange(page))?.design.layers.at(-1)?.name).toBe("Moin");
  const change = await lastChange(page);
  const width = expect.closeTo(0.03, 6);
  expect(change?.design.layers[0]).toMatchObject({ projector: { size: [width, width, expect.any(Number)] } });
  expect(change?.areas.map(({ id }) => id)).toEqual(change?.design.layers.map(({ id }) => id));
  expect(change?.totalArea).toBeGreaterThan(1);

  // The shop's own rule, told by its own words; and the way back.
  await upload(file("banned.png", demoFile("decals/smiley.png").buffer));
  await expect(editor.getByRole("alert")).toContainText("Not here.");
  expect(await codes(page)).toEqual(["refused"]);
  await editor.getByRole("button", { name: "Close" }).click();
  await editor.getByRole("button", { name: "Delete flower" }).click();
  await expect(editor.locator("[data-layer]")).toHaveCount(1);
  await page.keyboard.press("Control+z");
  await expect(editor.locator("[data-layer]")).toHaveCount(2);
  await editor.getByRole("button", { name: "Show print quality" }).click();
  await expect(editor.getByText("Too coarse")).toBeVisible();

  const listening = await editor.evaluateHandle((element) => ({
    handedIn: new Promise<{ sha256: string; bytes: number[]; names: string[]; again: string }>((resolve) => {
      const shop = element as HTMLElementTagNameMap["texelcast-editor"];
      shop.addEventListener("submit", async ({ detail }) => {
        const { sha256, bytes } = detail.texture;
        const { sha256: again } = await shop.exportTexture(detail.print);
        resolve({ sha256, bytes: [...bytes], names: detail.assets.map(({ name }) => name), again });
      });
    }),
  }));
  await editor.getByRole("button", { name: "Done" }).click();
  const { sha256, bytes, names, again } = await listening.evaluate(({ handedIn }) => handedIn);
  expect(createHash("sha256").update(Uint8Array.from(bytes)).digest("hex")).toBe(sha256);
  expect(again).toBe(sha256);
  expect(names).toEqual([expect.stringMatching(/^assets\/[0-9a-f]{64}\.png$/)]);
  expect(await seriousFaults(page)).toEqual([]);
  expect(await smallTargets(page, 24)).toEqual([]);
});

test("elements come, move and go, and leave no worker, graphics or picture behind", async ({ page }) => {
  await page.addInitScript(() => {
    const contexts: WebGL2RenderingContext[] = [];
    const addresses = new Set<string>();
    Object.assign(window, { contexts, addresses });
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: never[]) {
      const context = (getContext as (...all: never[]) => unknown).apply(this, args);
      if (context instanceof WebGL2RenderingContext && !contexts.includes(context)) contexts.push(context);
      return context;
    } as typeof getContext;
    const { createObjectURL, revokeObjectURL } = URL;
    URL.createObjectURL = (blob) => {
      const url = createObjectURL(blob);
      addresses.add(url);
      return url;
    };
    URL.revokeObjectURL = (url) => {
      addresses.delete(url);
      revokeObjectURL(url);
    };
  });
  const held = async (): Promise<{ workers: number; contexts: number; addresses: number }> => ({
    workers: page.workers().length,
    ...(await page.evaluate(() => {
      const { contexts, addresses } = window as unknown as {
        contexts: WebGL2RenderingContext[];
        addresses: Set<string>;
      };
      return { contexts: contexts.filter((each) => !each.isContextLost()).length, addresses: addresses.size };
    })),
  });
  await openShop(page, "?loading=eager");
  const layers = await page.evaluate(async () => {
    const first = document.querySelector("texelcast-editor") as HTMLElementTagNameMap["texelcast-editor"];
    const second = document.createElement("texelcast-editor");
    second.src = "demo/skateboard.glb";
    document.querySelector("main")?.append(second);
    await Promise.all([first.addDecal("demo/decals/smiley.png"), second.start()]);
    // Moved to another place of the page: the same work goes on.
    document.body.append(first);
    await new Promise((done) => setTimeout(done, 50));
    const { design } = await first.exportDesign();
    return design.layers.length;
  });
  expect(layers).toBe(1);
  await expect.poll(held).toEqual({ workers: 2, contexts: 2, addresses: 1 });

  // Away and back again, and the design is there.
  const again = await page.evaluate(async () => {
    const [second, first] = [...document.querySelectorAll("texelcast-editor")];
    second?.remove();
    first?.remove();
    await new Promise((done) => setTimeout(done, 50));
    if (first) document.body.append(first);
    const exported = await first?.exportDesign();
    return exported?.design.layers.length;
  });
  expect(again).toBe(1);
  await expect.poll(held).toEqual({ workers: 1, contexts: 1, addresses: 1 });
  await page.evaluate(() => document.querySelector("texelcast-editor")?.remove());
  await expect.poll(held).toEqual({ workers: 0, contexts: 0, addresses: 0 });

  // What is asked of one that is away is answered, and leaves nothing behind either.
  const asked = await page.evaluate(async () => {
    const editor = document.createElement("texelcast-editor");
    editor.src = "demo/mug.glb";
    document.body.append(editor);
    editor.remove();
    await new Promise((done) => setTimeout(done, 50));
    return (await editor.exportDesign()).design.layers.length;
  });
  expect(asked).toBe(0);
  await expect.poll(held).toEqual({ workers: 0, contexts: 0, addresses: 0 });
  expect(await codes(page)).toEqual([]);
});

test("an element that goes from the page while the shop makes up its mind, or a file is slow, lets the calls go", async ({
  page,
}) => {
  await openShop(page, "?loading=eager");
  // Its answer never comes.
  await page.route("**/slow.png", () => {});
  const asked = await page.evaluate(async () => {
    const editor = document.querySelector("texelcast-editor") as HTMLElementTagNameMap["texelcast-editor"];
    const asking = new Promise<AbortSignal>((resolve) => {
      editor.beforeAccept = (_, { signal }) => {
        resolve(signal);
        return new Promise(() => {});
      };
    });
    const codeOf = (call: Promise<unknown>): Promise<string> => call.then(String, ({ code }) => code);
    const calls = [editor.addDecal("slow.png"), editor.addDecal("demo/decals/smiley.png")].map(codeOf);
    const signal = await asking;
    editor.remove();
    return { codes: await Promise.all(calls), aborted: signal.aborted };
  });
  expect(asked).toEqual({ codes: ["disposed", "disposed"], aborted: true });
  expect(await codes(page)).toEqual([]);
});

test("an element whose graphics stay away says so, and begins anew with its design and its steps when it is asked to", async ({
  page,
}) => {
  await openShop(page, "?loading=eager");
  const editor = page.locator("texelcast-editor");
  await editor.evaluate((element: HTMLElementTagNameMap["texelcast-editor"]) =>
    element
      .addDecal("demo/decals/smiley.png")
      .then((id) => element.removeLayer(id))
      .then(() => element.addText("one"))
      .then(() => element.addText("two"))
      .then(() => element.undo()),
  );
  await page
    .locator("texelcast-editor .tcv-canvas")
    .evaluate((canvas: HTMLCanvasElement) =>
      canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext(),
    );
  const alert = editor.getByRole("alert");
  await expect(alert).toContainText("Nothing of your design is lost");
  expect(await codes(page)).toEqual(["graphics-lost"]);
  await alert.getByRole("button").click();
  await expect(alert).toHaveCount(0);
  const names = async (): Promise<string[]> =>
    editor.evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) =>
      (await element.exportDesign()).design.layers.map(({ name }) => name),
    );
  const travel = (way: "undo" | "redo"): Promise<boolean> =>
    editor.evaluate((element: HTMLElementTagNameMap["texelcast-editor"], way) => element[way](), way);
  expect(await names()).toEqual(["one"]);
  expect(await travel("redo")).toBe(true);
  expect(await names()).toEqual(["one", "two"]);
  for (const before of [["one"], [], ["smiley"]]) {
    await travel("undo");
    expect(await names()).toEqual(before);
  }
  // What the new engine has never had is given to it again.
  const bare = await editor.evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) => {
    const { sha256 } = await element.exportTexture();
    element.undo();
    return sha256 !== (await element.exportTexture()).sha256 && !element.canUndo;
  });
  expect(bare).toBe(true);
  expect(await codes(page)).toEqual(["graphics-lost"]);
});

test("words can be put on a product before the dialog that it stands in is opened", async ({ page }) => {
  await openShop(page, "?size=128");
  const sides = await page.evaluate(async () => {
    const dialog = document.createElement("dialog");
    const editor = document.createElement("texelcast-editor");
    editor.src = "demo/mug.glb";
    editor.size = 128;
    dialog.append(editor);
    document.body.append(dialog);
    await editor.addText("Ada");
    dialog.showModal();
    const [layer] = (await editor.exportDesign()).design.layers;
    return layer?.type === "text" && layer.projector.kind === "planar" ? layer.projector.size : null;
  });
  expect(sides?.every((side) => side > 0 && side < 1)).toBe(true);
});

test("what is handed in was told as a change before, with the words that were still being typed", async ({ page }) => {
  await openShop(page);
  const editor = page.locator("texelcast-editor");
  const words = editor.getByRole("textbox", { name: "Words" });
  // What is told of the first comes after a rest, which must not reach into what is looked at.
  await editor.evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) => {
    const told = new Promise((resolve) => element.addEventListener("change", resolve, { once: true }));
    await element.addText("First");
    await told;
  });
  await words.focus();
  await page.keyboard.type("Then");
  const { order, same } = await editor.evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) => {
    const order: string[] = [];
    let newest = "";
    element.addEventListener("change", ({ detail: { design } }) => {
      newest = JSON.stringify(design);
      order.push("change");
    });
    element.addEventListener("submit", () => order.push("submit"));
    const { design } = await element.submit();
    const same = newest === JSON.stringify(design);
    // What would still be told comes with the next: they are told one after the other.
    await element.addText("Later");
    await element.submit();
    return { order, same };
  });
  expect(order).toEqual(["change", "submit", "change", "submit"]);
  expect(same).toBe(true);
});

test("who sets another design while the product is loading, and waits for it, gets it shown", async ({ page }) => {
  await openShop(page, "?loading=lazy");
  const layers = await page
    .locator("texelcast-editor")
    .evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) => {
      const before = element.start();
      await new Promise((resolve) => element.addEventListener("progress", resolve, { once: true }));
      await new Promise((resolve) => setTimeout(resolve));
      element.design = {
        format: "texelcast-design",
        version: 1,
        layers: [{ type: "fill", id: "red", color: "#ff0000" }],
      };
      const exported = element.exportDesign();
      await Promise.all([before, element.start()]);
      return (await exported).design.layers.map(({ id }) => id);
    });
  expect(layers).toEqual(["red"]);
  expect(await codes(page)).toEqual([]);
});

test("pressed again while its font is slow, a text comes once, and is ready to be typed over", async ({ page }) => {
  let deliver = (): void => {};
  const delivered = new Promise<void>((resolve) => {
    deliver = resolve;
  });
  await page.route(/\.ttf$/, async (route) => {
    await delivered;
    await route.continue();
  });
  await openShop(page, "?size=128");
  const editor = page.locator("texelcast-editor");
  const add = editor.getByRole("button", { name: "Add text" });
  await add.click();
  await expect(add).toHaveAttribute("aria-disabled", "true");
  await add.click({ force: true });
  deliver();
  await expect(editor.getByRole("textbox", { name: "Words" })).toBeFocused();
  await expect(add).toHaveAttribute("aria-disabled", "false");
  await page.keyboard.type("Ada");
  await page.keyboard.press("Tab");
  const names = await editor.evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) =>
    (await element.exportDesign()).design.layers.map(({ name }) => name),
  );
  expect(names).toEqual(["Ada"]);
});

test("zones that cannot be read are told and hide no product, and hold once they are corrected", async ({ page }) => {
  await openShop(page, "?loading=lazy");
  const loaded = await page.evaluate(async () => {
    const editor = document.querySelector("texelcast-editor") as HTMLElementTagNameMap["texelcast-editor"];
    editor.zones = "{}";
    await editor.start();
    return editor.loaded;
  });
  expect(loaded).toBe(true);
  expect(await codes(page)).toEqual(["bad-zones"]);
  // In one turn: what is set before a call holds for it.
  const width = await page.evaluate(async (zones) => {
    const editor = document.querySelector("texelcast-editor") as HTMLElementTagNameMap["texelcast-editor"];
    editor.zones = zones;
    return (await editor.exportTexture({ zone: "wrap" })).width;
  }, ZONES);
  expect(width).toBeGreaterThan(0);
  expect(await codes(page)).toEqual(["bad-zones"]);
});

test("an element speaks the language around its shadow tree, and the one that was asked for last", async ({ page }) => {
  await openShop(page);
  // German comes only when English has been asked for again.
  let asked = false;
  let letCome = (): void => {};
  const mayCome = new Promise<void>((resolve) => {
    letCome = resolve;
  });
  await page.route(/\/german-[^/]*\.js$/, async (route) => {
    asked = true;
    await mayCome;
    await route.continue();
  });
  await page.evaluate(async () => {
    const around = document.createElement("div");
    around.lang = "de";
    const inside = document.createElement("div");
    around.append(inside);
    document.body.append(around);
    const editor = document.createElement("texelcast-editor");
    const other = document.createElement("texelcast-editor");
    for (const [id, each] of Object.entries({ editor, other })) {
      Object.assign(each, { id, src: "demo/mug.glb", loading: "lazy" });
    }
    other.locale = "de";
    document.body.append(other);
    await other.updateComplete;
    other.locale = "en";
    await other.updateComplete;
    inside.attachShadow({ mode: "open" }).append(editor);
  });
  await expect.poll(() => asked).toBe(true);
  letCome();
  await expect(page.locator("#editor")).toContainText("gestalten");
  await expect(page.locator("#other")).toContainText("Personalise");
});

test("the page's address gives the element its own attributes, and nothing that runs", async ({ page }) => {
  const run = encodeURIComponent("document.title = 'run'");
  await page.goto(`element.html?loading=eager&max-decals=3&onprogress=${run}&onload=${run}&id=x&style=color:red`);
  const editor = page.locator("texelcast-editor");
  await expect(editor.getByRole("application")).toBeVisible();
  const names = await editor.evaluate((element) => element.getAttributeNames());
  expect(names).toEqual(["src", "loading", "max-decals"]);
  expect(await page.title()).toBe("Texelcast in a shop");
});

test("a property that is taken back with undefined, a wrong value and a call that nobody waits for break nothing", async ({
  page,
}) => {
  await openShop(page, "?size=128");
  const uncaught: string[] = [];
  page.on("pageerror", (error) => uncaught.push(String(error)));
  const editor = page.locator("texelcast-editor");
  const found = await editor.evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) => {
    const anything = element as unknown as Record<string, unknown>;
    const source = await (await fetch(element.src as string)).arrayBuffer();
    await element.start();
    await element.addText("kept");
    // As frameworks do with a property that their component no longer has.
    for (const name of ["design", "zones", "beforeAccept", "locale", "wasmUrl", "poster", "maxDecals"]) {
      anything[name] = undefined;
    }
    for (const wrong of [7, {}, Symbol("none"), Object.create(null)]) {
      Object.assign(anything, { locale: wrong, maxDecals: wrong, cameraOrbit: wrong });
      await element.updateComplete;
    }
    Object.assign(anything, { locale: "", maxDecals: null, cameraOrbit: "" });
    const picture = Uint8Array.from(
      atob("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="),
      (c) => c.charCodeAt(0),
    );
    await element.addDecal(picture);
    const nothing = await element.addDecal(undefined as unknown as string).catch((error) => error);
    void element.restart();
    await element.restart();
    const { design } = await element.exportDesign();
    anything.src = { bytes: source };
    await element.updateComplete;
    await element.start();
    return { names: design.layers.map(({ name }) => name), nothing: [nothing.code, nothing.field] };
  });
  expect(found).toEqual({ names: ["kept", "picture"], nothing: ["bad-argument", "source"] });
  expect([...new Set(await codes(page))]).toEqual(["bad-argument"]);
  expect(uncaught).toEqual([]);
});

test("hostile designs and files are refused by name, run nothing and fetch nothing", async ({ page, baseURL }) => {
  const alarms: string[] = [];
  page.on("dialog", (dialog) => {
    alarms.push(dialog.message());
    void dialog.dismiss();
  });
  page.on("pageerror", (error) => alarms.push(error.message));
  page.on("request", (request) => {
    const url = request.url();
    if (!/^(data|blob):/.test(url) && new URL(url).origin !== new URL(baseURL ?? "").origin) alarms.push(url);
  });
  await openShop(page, "?loading=eager");
  const outcome = await page.evaluate(async () => {
    const editor = document.querySelector("texelcast-editor") as HTMLElementTagNameMap["texelcast-editor"];
    await editor.start();
    const refusal = async (work: Promise<unknown>): Promise<string> =>
      await work.then(
        () => "taken",
        (error: { code: string }) => error.code,
      );
    const svg = (inner: string, attributes = ""): Blob =>
      new Blob([`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9" ${attributes}>${inner}</svg>`]);
    const files: Record<string, Blob> = {
      script: svg("<script>alert(1)</script>"),
      handler: svg("", 'onload="alert(2)"'),
      page: new Blob(["<html><script>alert(3)</script></html>"], { type: "image/png" }),
      heavy: new Blob([new Uint8Array(21 * 2 ** 20)]),
    };
    const refusals: Record<string, string> = {};
    for (const [name, blob] of Object.entries(files)) refusals[name] = await refusal(editor.addDecal(blob));

    const base = { format: "texelcast-design", version: 1 };
    const projector = { kind: "planar", position: [0, 0.05, 0], rotation: [0, 0, 0, 1], size: [0.05, 0.05, 0.1] };
    const decal = (uri: string, type = "image/png") => ({
      ...base,
      assets: { a: { type, uri } },
      layers: [{ type: "decal", asset: "a", projector }],
    });
    const designs: Record<string, unknown> = {
      proto:
        '{"format":"texelcast-design","version":1,"assets":{"__proto__":{"type":"image/png","uri":"x"}},"layers":[]}',
      field: '{"format":"texelcast-design","version":1,"__proto__":{"readonly":false},"assets":{},"layers":[]}',
      climbing: decal("../../../etc/passwd"),
      spelt: decal("%2e%2e%2fsecret.png"),
      elsewhere: decal("https://evil.example/spy.png"),
      liar: decal(`data:image/png;base64,${btoa("<svg xmlns='http://www.w3.org/2000/svg' onload='alert(4)'/>")}`),
      twice: decal("data:text/html,<script>alert(5)</script>"),
      many: { ...base, assets: {}, layers: Array.from({ length: 10_001 }, () => ({ type: "fill", color: "#ff0000" })) },
    };
    for (const [name, design] of Object.entries(designs)) {
      const error = new Promise<string>((resolve) => {
        editor.addEventListener("error", ({ detail }) => resolve(detail.code), { once: true });
      });
      editor.design = design as object;
      refusals[name] = await error;
    }
    const { design } = await editor.exportDesign();
    // A name is words, whatever stands in it.
    await editor.addDecal("demo/decals/smiley.png", { name: "<img src=x onerror=alert(6)>" });
    return { refusals, layers: design.layers.length, polluted: "readonly" in {} };
  });
  expect(outcome).toEqual({
    refusals: {
      ...{ script: "unsafe-file", handler: "unsafe-file", page: "bad-picture", heavy: "too-large" },
      ...{ proto: "bad-design", field: "bad-design", climbing: "outside-folder", spelt: "outside-folder" },
      ...{ elsewhere: "outside-folder", liar: "unsafe-file", twice: "bad-design", many: "bad-design" },
    },
    layers: 0,
    polluted: false,
  });
  const row = page.locator("texelcast-editor").getByRole("listitem");
  await expect(row).toContainText("<img src=x onerror=alert(6)>");
  expect(alarms).toEqual([]);
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, locale: "de-DE" });

  test("everything that is pressed is large enough for a finger, and the words are the page's language", async ({
    page,
  }) => {
    await openShop(page, "?loading=eager&locale=de");
    const editor = page.locator("texelcast-editor");
    await editor.getByRole("button", { name: "Text einfügen" }).tap();
    await expect(editor.getByRole("textbox", { name: "Text" })).toBeVisible();
    expect(await smallTargets(page, 44)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  });
});

test("what keys do to a picture is said in the customer's language once they rest, and a number that is not taken as well", async ({
  page,
}) => {
  await openShop(page, "?locale=de");
  const editor = page.locator("texelcast-editor");
  await editor.evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) => {
    await element.start();
    await element.addDecal("demo/decals/smiley.png", { name: "Smiley" });
  });
  const said = editor.locator(".visually-hidden[role=status]");
  const heard: [key: string, what: RegExp][] = [
    ["ArrowLeft", /^0,\d cm nach links$/],
    ["]", /^Drehung -?\d+,\d°$/],
    ["+", /^Breite \d,\d cm, Höhe \d,\d cm$/],
  ];
  const view = editor.getByRole("application");
  for (const [key, what] of heard) {
    for (let step = 0; step < 3; step += 1) await view.press(key);
    await expect(said).toHaveText(what);
  }
  await editor.evaluate((element) => {
    element.addEventListener("field-refused", () => Object.assign(window, { leaked: true }));
  });
  const width = editor.getByRole("spinbutton", { name: "Breite" });
  await width.fill("9999");
  await width.press("Enter");
  await expect(said).toHaveText(/^Breite: 0,01 cm – [\d,]+ cm$/);
  await expect(editor.locator("tc-number .why")).toHaveText(/^0,01 cm – [\d,]+ cm$/);
  expect(await page.evaluate(() => "leaked" in window)).toBe(false);
  // Two parts of one name would be one to whoever walks by names.
  const named = editor.locator(".shop").getByLabel("Dein Design", { exact: true });
  await expect(named).toHaveCount(1);
});
