/** `<texelcast-editor mode="full">`: the whole editor in somebody's page, which says what may be done in it. */
import { expect, type Page, test } from "@playwright/test";
import { renderPrint } from "../../node/print.ts";
import type { ChangeDetail, ExportedDesign } from "../../web/element/element-api.ts";
import { seriousFaults } from "./support/page-faults.ts";
import { demoFile, file, glbWithoutUvs } from "./support/test-files.ts";

type Element = HTMLElementTagNameMap["texelcast-editor"];

/** Opens an element in full mode; what it tells is kept in `window.told`. */
async function openFull(page: Page, query = ""): Promise<void> {
  await page.goto(`element.html?mode=full&loading=eager&size=512${query}`);
  await page.evaluate(async () => {
    const told = { changes: [] as ChangeDetail[], errors: [] as string[] };
    Object.assign(window, { told });
    const element = document.querySelector("texelcast-editor") as Element;
    element.addEventListener("change", ({ detail }) => told.changes.push(detail));
    element.addEventListener("error", ({ detail }) => told.errors.push(detail.code));
    await element.start();
  });
}

const told = (page: Page): Promise<{ changes: ChangeDetail[]; errors: string[] }> =>
  page.evaluate(() => (window as unknown as { told: { changes: ChangeDetail[]; errors: string[] } }).told);

const layerCount = (page: Page): Promise<number> =>
  page.evaluate(
    async () => (await (document.querySelector("texelcast-editor") as Element).exportDesign()).design.layers.length,
  );

test("what is painted in the element is told to its page, and printed by a server to the same bytes", async ({
  page,
}) => {
  await openFull(page, "&locale=en&max-decals=1");
  const editor = page.locator("texelcast-editor");
  await page.evaluate(() => {
    (document.querySelector("texelcast-editor") as Element).beforeAccept = ({ name }) => !name.startsWith("banned");
  });
  const upload = async (...files: ReturnType<typeof file>[]): Promise<void> => {
    const chooser = page.waitForEvent("filechooser");
    await editor.getByRole("button", { name: "Add picture…" }).click();
    await (await chooser).setFiles(files);
  };
  // The panels ask the page as its own script is asked.
  await upload(file("banned.png", demoFile("decals/smiley.png").buffer));
  await expect(editor.locator("tc-notice-stack")).toContainText("banned.png");
  await upload(demoFile("decals/smiley.png"));
  await expect(editor.getByRole("row", { name: /smiley/ })).toBeVisible();
  await upload(demoFile("decals/flower.png"));
  await expect(editor.locator("tc-notice-stack")).toContainText("takes 1 pictures and texts at most");

  await editor.getByRole("radio", { name: "Brush" }).click();
  const view = await editor.getByRole("application", { name: /Model in 3D/ }).boundingBox();
  if (!view) throw new Error("The view is not shown.");
  const [x, y] = [view.x + view.width * 0.4, view.y + view.height * 0.6];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y - 10, { steps: 4 });
  await page.mouse.up();
  await expect.poll(async () => (await told(page)).changes.at(-1)?.counts).toEqual({ decals: 1, texts: 0, layers: 2 });

  const { exported, bytes, sha256 } = await page.evaluate(async () => {
    const element = document.querySelector("texelcast-editor") as Element;
    const print = await element.exportTexture();
    const { design, assets } = await element.exportDesign();
    const plain = assets.map((asset) => ({ ...asset, bytes: [...asset.bytes] }));
    return { exported: { design, assets: plain }, bytes: [...print.bytes], sha256: print.sha256 };
  });
  const { design, assets }: ExportedDesign = {
    ...exported,
    assets: exported.assets.map((asset) => ({ ...asset, bytes: Uint8Array.from(asset.bytes) })),
  };
  const model = new Uint8Array(demoFile("mug.glb").buffer);
  const print = await renderPrint({ model, design, assets, material: 0, size: 512 });
  expect(print.sha256).toBe(sha256);
  expect(Buffer.from(print.bytes).equals(Buffer.from(bytes))).toBe(true);
});

test("a model without texture coordinates stays an error with its code: the element unwraps nothing", async ({
  page,
}) => {
  await page.route("**/*.glb", (route) => route.fulfill({ body: glbWithoutUvs().buffer }));
  await page.goto("element.html?mode=full&loading=eager&size=512");
  const code = await page.evaluate(async () => {
    const element = document.querySelector("texelcast-editor") as Element;
    return await element.start().then(
      () => "",
      (error: { code: string }) => error.code,
    );
  });
  expect(code).toBe("no-uvs");
  await expect(page.locator("texelcast-editor").getByRole("button", { name: "Unwrap and open" })).toHaveCount(0);
});

test("two elements speak two languages, and one of them another one from then on", async ({ page }) => {
  await openFull(page, "&locale=de");
  await page.evaluate(async () => {
    const second = document.createElement("texelcast-editor");
    Object.assign(second, { src: "demo/mug.glb", mode: "full", locale: "en", size: 256 });
    document.querySelector("main")?.append(second);
    await second.start();
  });
  const [first, second] = [page.locator("texelcast-editor").first(), page.locator("texelcast-editor").last()];
  await expect(first.getByRole("tab", { name: "Ebenen" })).toBeVisible();
  await expect(second.getByRole("tab", { name: "Layers" })).toBeVisible();
  await page.evaluate(() => document.querySelectorAll("texelcast-editor")[1]?.setAttribute("locale", "de"));
  await expect(second.getByRole("tab", { name: "Ebenen" })).toBeVisible();
  await expect(second.getByRole("application", { name: /Modell in 3D/ })).toBeVisible();
  expect((await told(page)).errors).toEqual([]);

  // What is wrong with the page's own zones is told to it, in the element's language.
  const zoneFault = await page.evaluate(async () => {
    const element = document.querySelector("texelcast-editor") as Element;
    const error = new Promise<{ code: string; message: string; hint: string }>((resolve) => {
      element.addEventListener("error", ({ detail }) => resolve(detail), { once: true });
    });
    const shape = { kind: "box", position: [0, 0.05, 0.05], size: [0.1, 0.08, 0.1] };
    element.zones = { texelcastZones: 1, zones: [{ id: "wrap", name: "Wrap", material: 7, shape }] };
    const { code, message, hint } = await error;
    const { violations } = await element.validate();
    return { code, message, hint, violations: violations.map((each) => [each.code, each.zone, each.layer]) };
  });
  expect(zoneFault).toMatchObject({ code: "bad-zones", violations: [["zone-without-material", "wrap", null]] });
  expect(zoneFault.message).toContain("Material 7");
  expect(zoneFault.hint).toBe("Gib ihr eines des Modells: 0 (Glaze).");
});

test("a design that can only be looked at is changed by no tool, no key, no field and no call", async ({ page }) => {
  await openFull(page, "&locale=en");
  const editor = page.locator("texelcast-editor");
  await page.evaluate(async () => {
    const element = document.querySelector("texelcast-editor") as Element;
    await element.addDecal("demo/decals/smiley.png");
    element.readonly = true;
    await element.updateComplete;
  });
  const design = (): Promise<string> =>
    page.evaluate(async () => {
      const { design } = await (document.querySelector("texelcast-editor") as Element).exportDesign();
      return JSON.stringify(design);
    });
  const before = await design();
  await expect(editor.getByRole("note")).toContainText("This design can only be looked at");
  await expect(editor.getByRole("radiogroup", { name: "Tools" })).toHaveCount(0);
  await editor.getByRole("row", { name: /smiley/ }).click();
  const fields = editor.getByRole("group", { name: /Cannot be changed/ });
  await expect(fields.getByRole("spinbutton", { name: "Position X" })).toBeDisabled();
  await expect(fields.getByRole("textbox", { name: "Name" })).toBeDisabled();
  await expect(editor.getByRole("button", { name: /^Undo/ })).toBeDisabled();

  const view = editor.getByRole("application", { name: /Model in 3D/ });
  const box = await view.boundingBox();
  if (!box) throw new Error("The view is not shown.");
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2, { steps: 3 });
  await page.mouse.up();
  await view.focus();
  for (const key of ["b", "Delete", "ArrowLeft", "]", "Control+z", "Control+d", "Control+g"])
    await page.keyboard.press(key);
  await editor.getByRole("row", { name: /smiley/ }).focus();
  for (const key of ["F2", "Space", "Delete", "Alt+ArrowUp"]) await page.keyboard.press(key);
  const outcome = await page.evaluate(async () => {
    const element = document.querySelector("texelcast-editor") as Element;
    const code = (error: { code: string }): string => error.code;
    const added = await element.addText("Moin").catch(code);
    const removed = ((): boolean => element.removeLayer("layer-1"))();
    return { added, removed, undone: element.undo() };
  });
  expect(outcome).toEqual({ added: "refused", removed: false, undone: false });
  expect(await design()).toBe(before);
  expect(await seriousFaults(page)).toEqual([]);

  // The page itself may show another one; and let it be changed again.
  await page.evaluate(async () => {
    const element = document.querySelector("texelcast-editor") as Element;
    element.design = { format: "texelcast-design", version: 1, assets: {}, layers: [] };
    await element.updateComplete;
  });
  await expect.poll(() => layerCount(page)).toBe(0);
  await page.evaluate(() => document.querySelector("texelcast-editor")?.removeAttribute("readonly"));
  await expect(editor.getByRole("radiogroup", { name: "Tools" })).toBeVisible();
  await page.evaluate(async () => (document.querySelector("texelcast-editor") as Element).addText("Moin"));
  expect(await layerCount(page)).toBe(1);
});

test("taken away and put back, the whole editor goes on with its design and leaves no worker behind", async ({
  page,
}) => {
  await openFull(page);
  const layers = await page.evaluate(async () => {
    const element = document.querySelector("texelcast-editor") as Element;
    await element.addDecal("demo/decals/smiley.png");
    element.remove();
    await new Promise((done) => setTimeout(done, 50));
    document.body.append(element);
    return (await element.exportDesign()).design.layers.length;
  });
  expect(layers).toBe(1);
  await expect.poll(() => page.workers().length).toBe(1);
  await page.evaluate(() => document.querySelector("texelcast-editor")?.remove());
  await expect.poll(() => page.workers().length).toBe(0);
  expect((await told(page)).errors).toEqual([]);
});

test("in a narrow box of a wide page, what its buttons lay open stands in the sheet, and moves beside them where it is wide", async ({
  page,
}) => {
  await page.goto("element.html?mode=full&loading=eager&size=256&locale=en");
  const editor = page.locator("texelcast-editor");
  await editor.evaluate(async (element: Element) => {
    element.style.width = "380px";
    await element.start();
  });
  const rail = editor.getByRole("radiogroup", { name: "Tools" });
  const isRow = async (): Promise<boolean> => {
    const box = await rail.boundingBox();
    return box !== null && box.width > box.height;
  };
  const sheet = editor.locator("tc-bottom-sheet");
  const [view, panel] = [editor.locator("#view-menu"), editor.locator("#view-panel")];
  await expect(sheet).toBeVisible();
  expect(await isRow()).toBe(true);
  await view.click();
  await expect(sheet.locator("tc-view-settings")).toBeVisible();
  await expect(panel).toHaveCount(0);

  await editor.evaluate((element) => element.style.removeProperty("width"));
  await expect(panel).toBeVisible();
  await expect(sheet).toHaveCount(0);
  expect(await isRow()).toBe(false);
  await page.keyboard.press("Escape");
  await editor.getByRole("radio", { name: "Brush" }).click();
  await editor.locator("#show-palette").click();
  await expect(editor.locator("tc-stage tc-color-palette")).toBeVisible();
  await editor.evaluate((element) => {
    element.style.width = "380px";
  });
  await expect(sheet.locator("tc-color-palette")).toBeVisible();
  await expect(editor.locator("tc-stage tc-color-palette")).toHaveCount(0);
});
