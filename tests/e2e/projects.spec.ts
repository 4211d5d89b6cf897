/** Projects kept by the page itself: what is there after the tab was closed, in a second tab, and where the browser refuses. */
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { EditorPage, expect, test } from "./support/editor-page.ts";
import { heavyGlb, squareGlb, squareGltf } from "./support/test-files.ts";

/** Built by every stage of `npm test` before its tests. */
const COMMAND_LINE = fileURLToPath(new URL("../../build/node/texelcast.mjs", import.meta.url));

/** A badge on the mug, kept as a project, and the page in another tab as well. */
async function keptAndOpenInAnother(editor: EditorPage): Promise<EditorPage> {
  await editor.open();
  await editor.addDemoDecal("badge");
  await editor.page.evaluate(() => window.texelcast.kept());
  const other = new EditorPage(await editor.page.context().newPage());
  await other.open();
  return other;
}

test("a tab closed without saving is back as it was, and its file renders to the same bytes in Node", async ({
  editor,
  page,
}, info) => {
  await editor.open();
  await editor.openModel(squareGltf());
  await editor.addDemoDecal("badge");
  await editor.setField("spin", "12.5");
  const before = await editor.settledHash();
  const design = await editor.design();
  await page.evaluate(() => window.texelcast.kept());
  const context = page.context();
  await page.close();

  const again = new EditorPage(await context.newPage());
  await again.open();
  await expect(again.page.locator("tc-top-bar .models")).toContainText("square.gltf");
  await expect(again.notices).toContainText("square is back as you left it");
  expect(await again.settledHash()).toBe(before);
  expect(await again.design()).toEqual(design);

  const { bytes: exported } = await again.exported("Texture as PNG");
  const project = await again.savedProject();
  expect(project.name).toBe("square.texelcast");
  const bare = await again.saved(() => again.chooseOfProjects("Save without the model"));
  expect(bare.name).toBe("square (without model).texelcast");
  const [input, output] = [info.outputPath(project.name), info.outputPath("rendered.png")];
  writeFileSync(input, project.bytes);
  const run = spawnSync(process.execPath, [COMMAND_LINE, "render", input, "--out", output], { encoding: "utf8" });
  expect(run.stderr).toBe("");
  expect(readFileSync(output).equals(exported)).toBe(true);

  await again.removeAllDecals();
  await again.drop([{ name: project.name, mimeType: "application/zip", buffer: project.bytes }], { x: 300, y: 400 });
  expect(await again.settledHash()).toBe(before);
  expect(await again.design()).toEqual({ ...design, assets: (await again.design()).assets });
});

test("the open project is given another name from its own menu", async ({ editor, page }) => {
  await editor.open();
  await editor.addDemoDecal("badge");
  await page.evaluate(() => window.texelcast.kept());
  await editor.chooseOfProjects("Rename…");
  const field = page.getByRole("textbox", { name: /^Name of / });
  await expect(field).toBeFocused();
  await field.fill("Breakfast");
  await field.press("Enter");
  await expect(page.locator("tc-top-bar .projects")).toContainText("Breakfast");
  await page.keyboard.press("Escape");
  await page.reload();
  await expect(page.locator("tc-top-bar .projects")).toContainText("Breakfast");
});

test("opening a model and undoing it leaves its project the one that a reload and a new tab go on with", async ({
  editor,
  page,
}) => {
  // The page is opened three times.
  test.slow();
  await editor.open();
  await editor.addDemoDecal("badge");
  const worked = await editor.settledHash();
  // One state, and no second mark that says otherwise; what an update cost is not said unasked.
  await page.evaluate(() => window.texelcast.kept());
  await expect(page.locator("tc-status-line")).toContainText("Kept in this browser");
  await expect(page.locator("#save-design .unsaved")).toHaveCount(0);
  await expect(page.locator("tc-status-line")).not.toContainText("engine");
  await expect(page.locator("tc-status-line [title*=engine]")).toContainText("Last painted: ");
  await editor.openModel(squareGltf());
  await page.evaluate(() => window.texelcast.kept());
  await page.keyboard.press("Control+z");
  await expect(page.locator("tc-top-bar .models")).toContainText("Mug");
  expect(await editor.settledHash()).toBe(worked);
  await page.evaluate(() => window.texelcast.kept());

  await editor.reload();
  expect(await editor.settledHash()).toBe(worked);
  const context = page.context();
  await page.close();
  const again = new EditorPage(await context.newPage());
  await again.open();
  expect(await again.settledHash()).toBe(worked);
  // A look at a demo is what a reload shows again, and a new tab still goes on with the work.
  await again.page.locator("tc-top-bar .models button").first().click();
  await again.page.getByRole("menuitemradio", { name: "Skateboard" }).click();
  await expect(again.page.locator("tc-top-bar .models")).toContainText("Skateboard");
  await again.idle();
  await again.reload();
  await expect(again.page.locator("tc-top-bar .models")).toContainText("Skateboard");
});

test("a second tab has a copy, and neither overwrites the other; the list brings back what was deleted", async ({
  editor,
  page,
}) => {
  // The page is opened three times.
  test.slow();
  await editor.open();
  await editor.addDemoDecal("badge");
  await page.evaluate(() => window.texelcast.kept());
  const first = await editor.settledHash();

  const other = new EditorPage(await page.context().newPage());
  await other.open();
  await expect(other.notices).toContainText("Mug is open in another tab");
  expect(await other.settledHash()).toBe(first);
  await other.removeAllDecals();
  await other.page.evaluate(() => window.texelcast.kept());

  const list = other.page.locator("tc-projects-dialog");
  await other.chooseOfProjects("All projects");
  const rows = list.getByRole("listitem");
  await expect(rows).toHaveCount(2);
  await expect(rows.nth(0)).toContainText("Open here");
  await expect(rows.nth(1)).toContainText("Open in another tab");
  await rows.nth(0).getByRole("button", { name: "Rename" }).click();
  await list.getByRole("textbox").fill("Empty mug");
  await list.getByRole("textbox").press("Enter");
  await expect(rows.nth(0)).toContainText("Empty mug");
  await rows.nth(0).getByRole("button", { name: "Delete" }).click();
  await list.getByRole("button", { name: "Undo deleting Empty mug" }).click();
  await expect(rows.nth(0).getByRole("button", { name: "Open Empty mug" })).toBeVisible();
  await other.page.close();

  await page.goto("./?new");
  await page.waitForFunction(() => window.texelcast !== undefined);
  await page.evaluate(() => window.texelcast.ready);
  expect(await editor.settledHash()).not.toBe(first);
  expect(new URL(page.url()).search).toBe("");
  await editor.chooseOfProjects("All projects");
  await page.getByRole("button", { name: /^Open Mug (?!\(copy\))/ }).click();
  await expect(page.locator("tc-top-bar .projects")).toContainText("Mug");
  expect(await editor.settledHash()).toBe(first);
});

test("a list that is closed in one tab takes nothing for good that the list of another can bring back", async ({
  editor,
  page,
}) => {
  test.slow();
  const other = await keptAndOpenInAnother(editor);
  for (const tab of [editor, other]) {
    await tab.chooseOfProjects("All projects");
    await tab.page.getByRole("button", { name: "Duplicate Mug", exact: true }).click();
    await tab.page.getByRole("button", { name: "Delete Mug (copy)", exact: true }).click();
    await expect(tab.page.getByRole("button", { name: "Undo deleting Mug (copy)", exact: true })).toBeVisible();
  }
  await other.page.keyboard.press("Escape");
  await expect(other.page.locator("tc-projects-dialog dialog")).toBeHidden();
  await other.chooseOfProjects("All projects");
  await expect(other.page.getByRole("button", { name: /^Open Mug (?!\(copy\))/ })).toBeVisible();

  await page.getByRole("button", { name: "Undo deleting Mug (copy)", exact: true }).click();
  await expect(page.getByRole("button", { name: "Open Mug (copy)" })).toBeVisible();
  await expect(editor.notices.filter({ hasText: "could not" })).toHaveCount(0);
});

test("a tab whose project another has deleted says so when it is seen again, and keeps it if asked to", async ({
  editor,
  page,
}) => {
  test.slow();
  const other = await keptAndOpenInAnother(editor);
  await other.chooseOfProjects("All projects");
  await other.page.getByRole("button", { name: "Delete Mug", exact: true }).click();
  await expect(other.page.getByRole("button", { name: "Undo deleting Mug", exact: true })).toBeVisible();
  await other.page.close();

  // Headless, each tab counts as seen all the time.
  await page.evaluate(() => document.dispatchEvent(new Event("visibilitychange")));
  const told = editor.notices.filter({ hasText: "It was deleted in another tab, or with the browser's data" });
  await expect(told).toBeVisible();
  await told.getByRole("button", { name: "Keep it" }).click();
  await expect(told).toHaveCount(0);
  await page.evaluate(() => window.texelcast.kept());
  await expect(page.locator("tc-status-line")).toContainText("Kept in this browser");
  await editor.chooseOfProjects("All projects");
  await expect(page.locator("tc-projects-dialog").getByRole("listitem")).toContainText(["Mug"]);
});

test("where the browser keeps nothing the page says so once, works on, and offers a file", async ({ editor, page }) => {
  await page.addInitScript(() => {
    indexedDB.open = () => {
      throw new DOMException("denied", "SecurityError");
    };
  });
  await editor.open();
  await expect(editor.notices).toHaveCount(0);
  const before = await editor.hash();
  await editor.addDemoDecal("badge");
  await page.evaluate(() => window.texelcast.kept());
  await expect(editor.notices).toContainText("Your work is not being kept in this browser");
  await expect(page.locator("tc-status-line")).toContainText("Not kept");
  await expect(page.locator("#save-design .unsaved")).toBeVisible();
  await editor.addDemoDecal("smiley");
  expect(await editor.settledHash()).not.toBe(before);
  await expect(editor.notices).toHaveCount(1);
  const download = page.waitForEvent("download");
  await editor.notices.getByRole("button", { name: "Save as one file" }).click();
  expect((await download).suggestedFilename()).toBe("Mug.texelcast");
});

test.describe("in a browser with little room", () => {
  /** Opens a model that is too large for it; returns what gives it room. */
  async function openLarge(editor: EditorPage): Promise<() => Promise<unknown>> {
    const { page } = editor;
    await editor.open();
    const session = await page.context().newCDPSession(page);
    const { origin } = new URL(page.url());
    const usage = await page.evaluate(async () => (await navigator.storage.estimate()).usage ?? 0);
    await session.send("Storage.overrideQuotaForOrigin", { origin, quotaSize: usage + 4 * 2 ** 20 });
    await editor.openModel([heavyGlb("large.glb", 8 * 2 ** 20)]);
    await page.evaluate(() => window.texelcast.kept());
    await expect(editor.notices).toContainText("Your work is not being kept in this browser");
    await expect(editor.notices).toContainText("space for this page is used up");
    await expect(page.locator("#keeping")).toHaveText("Not kept");
    return () => session.send("Storage.overrideQuotaForOrigin", { origin });
  }

  async function openSmall(editor: EditorPage): Promise<void> {
    await editor.openModel([squareGlb()]);
    await editor.page.evaluate(() => window.texelcast.kept());
    await expect(editor.page.locator("#keeping")).toHaveText("Kept in this browser");
    await expect(editor.notices.filter({ hasText: "Your work is not being kept" })).toHaveCount(0);
    await expect(editor.notices.filter({ hasText: "large, which you worked on before, is not kept" })).toBeVisible();
  }

  test("a project that found no room and was left is told by its name, and leaving asks first though the open one is kept", async ({
    editor,
    page,
  }) => {
    await openLarge(editor);
    await openSmall(editor);
    const asked: string[] = [];
    page.on("dialog", (dialog) => {
      asked.push(dialog.type());
      void dialog.accept();
    });
    await page.reload();
    expect(asked).toEqual(["beforeunload"]);
  });

  test("a project that found no room and was left is saved as a file, and is kept once it is open again and there is room", async ({
    editor,
    page,
  }) => {
    // The browser is asked again after a while.
    test.slow();
    const giveRoom = await openLarge(editor);
    await openSmall(editor);
    const told = editor.notices.filter({ hasText: "large, which you worked on before" });
    const { name } = await editor.saved(() => told.getByRole("button", { name: "Save as one file" }).click());
    expect(name).toBe("large.texelcast");
    await expect(told).toHaveCount(0);

    await page.locator("#undo").click();
    await editor.idle();
    await page.evaluate(() => window.texelcast.kept());
    await expect(editor.notices.filter({ hasText: "Your work is not being kept" })).toBeVisible();
    await giveRoom();
    await expect(page.locator("#keeping")).toHaveText("Kept in this browser", { timeout: 40_000 });
    await expect(editor.notices.filter({ hasText: "Your work is not being kept" })).toHaveCount(0);
  });
});

test("a page whose data the browser has cleared says so when it is seen again, and keeps its project anew", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.addDemoDecal("badge");
  await page.evaluate(() => window.texelcast.kept());
  const session = await page.context().newCDPSession(page);
  // What is asked for while the browser clears is answered by nobody.
  const asked = page.evaluate(() => {
    const again = setInterval(() => document.dispatchEvent(new Event("visibilitychange")), 1);
    return new Promise<void>((resolve) => setTimeout(() => resolve(clearInterval(again)), 500));
  });
  await session.send("Storage.clearDataForOrigin", { origin: new URL(page.url()).origin, storageTypes: "all" });
  await asked;
  await expect(editor.notices).toContainText("This project is no longer kept in this browser");
  await expect(editor.notices).toContainText("with the browser's data for this page");
  const painted = await editor.settledHash();
  await editor.notices.getByRole("button", { name: "Keep it" }).click();
  await page.evaluate(() => window.texelcast.kept());
  await expect(page.locator("#keeping")).toHaveText("Kept in this browser");
  await editor.reload();
  expect(await editor.settledHash()).toBe(painted);
});

test("a project that the browser is too slow to give out as the page opens is offered when it has come", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.addDemoDecal("badge");
  const worked = await editor.settledHash();
  await page.evaluate(() => window.texelcast.kept());
  await page.addInitScript(() => {
    const late: (() => void)[] = [];
    let holds = true;
    const { open } = indexedDB;
    indexedDB.open = (...how: Parameters<typeof open>) => {
      const request = open.apply(indexedDB, how);
      request.addEventListener("success", (event) => {
        if (!holds) return;
        event.stopImmediatePropagation();
        late.push(() => request.dispatchEvent(new Event("success")));
      });
      return request;
    };
    Object.assign(window, {
      answer: () => {
        holds = false;
        for (const each of late) each();
      },
    });
  });
  await editor.reload();
  expect(await editor.settledHash()).not.toBe(worked);
  await page.evaluate(() => (window as unknown as { answer: () => void }).answer());
  await expect(editor.notices).toContainText("Could not open Mug");
  await editor.notices.getByRole("button", { name: "Open Mug" }).click();
  await expect(editor.notices).toContainText("Mug is back as you left it");
  expect(await editor.settledHash()).toBe(worked);
});

test("the picture of a project is read back once the GPU has drawn it, not while the page waits", async ({
  editor,
  page,
}) => {
  await page.addInitScript(() => {
    const told: string[] = Object.assign(window, { told: [] as string[] }).told;
    const context = CanvasRenderingContext2D.prototype;
    const [draw, pack] = [context.drawImage, HTMLCanvasElement.prototype.toBlob];
    const fence = WebGL2RenderingContext.prototype.getSyncParameter;
    context.drawImage = function (this: CanvasRenderingContext2D, ...args: Parameters<typeof draw>) {
      if (args[0] instanceof HTMLCanvasElement) told.push("drawn");
      draw.apply(this, args);
    } as typeof draw;
    WebGL2RenderingContext.prototype.getSyncParameter = function (...args) {
      told.push("asked");
      return fence.apply(this, args);
    };
    HTMLCanvasElement.prototype.toBlob = function (...args) {
      told.push("read");
      pack.apply(this, args);
    };
  });
  const told = (): Promise<string[]> => page.evaluate(() => (window as unknown as { told: string[] }).told);
  await editor.open();
  await editor.addDemoDecal("badge");
  await expect.poll(told).toContain("read");
  const all = await told();
  expect(all.slice(all.indexOf("drawn"), all.indexOf("read"))).toContain("asked");
});

test("the picture of a project in the list is written beside the page, which goes on meanwhile", async ({
  editor,
  page,
}) => {
  await page.addInitScript(() => {
    const { toDataURL } = HTMLCanvasElement.prototype;
    Object.assign(window, { written: 0 });
    HTMLCanvasElement.prototype.toDataURL = function (...how) {
      Reflect.set(window, "written", Reflect.get(window, "written") + 1);
      return toDataURL.apply(this, how);
    };
  });
  await editor.open();
  await editor.addDemoDecal("badge");
  await page.evaluate(() => window.texelcast.kept());
  await editor.chooseOfProjects("All projects");
  const picture = page.locator("tc-projects-dialog .picture img").first();
  await expect(picture).toHaveAttribute("src", /^data:image\/webp;base64,/);
  expect(await picture.evaluate((image: HTMLImageElement) => image.decode().then(() => image.naturalWidth))).toBe(288);
  expect(await page.evaluate(() => Reflect.get(window, "written"))).toBe(0);
});

for (const [kind, viewport] of [
  ["a desktop", { width: 1280, height: 800 }],
  ["a phone", { width: 390, height: 844 }],
] as const) {
  test.describe(`on ${kind}`, () => {
    test.use({ viewport, contextOptions: { reducedMotion: "reduce" } });

    test("the picture of a project has the model's proportions and the view's middle", async ({ editor, page }) => {
      await editor.open();
      await editor.openModel([squareGlb()]);
      // So far that none of it is cut off, and no farther: where frames are slow, the picture may be drawn with half as many pixels
      // a side, each of which is then a larger part of the square.
      const view = await editor.view.boundingBox();
      if (!view) throw new Error("The view has no place.");
      await page.mouse.move(view.x + view.width / 2, view.y + view.height / 2);
      await page.mouse.wheel(0, 240);
      const corners = await page.evaluate(() =>
        [-0.5, 0.5].flatMap((x) => [-0.5, 0.5].map((y) => window.texelcast.project(x, y, 0) ?? { x: 0, y: 0 })),
      );
      const [xs, ys] = [corners.map(({ x }) => x), corners.map(({ y }) => y)];
      const [left, right] = [Math.min(...xs), Math.max(...xs)];
      await editor.addDemoDecal("badge");
      await page.evaluate(() => window.texelcast.kept());
      await editor.chooseOfProjects("All projects");
      const picture = page.locator("tc-projects-dialog .picture img").first();
      const seen = await picture.evaluate(async (image: HTMLImageElement) => {
        await image.decode();
        const { naturalWidth: width, naturalHeight: height } = image;
        const context = new OffscreenCanvas(width, height).getContext("2d") as OffscreenCanvasRenderingContext2D;
        context.drawImage(image, 0, 0);
        const { data } = context.getImageData(0, 0, width, height);
        const box = { left: width, right: -1, top: height, bottom: -1 };
        for (let y = 0; y < height; y += 1)
          for (let x = 0; x < width; x += 1) {
            if ((data[(y * width + x) * 4 + 3] ?? 0) < 250) continue;
            box.left = Math.min(box.left, x);
            box.right = Math.max(box.right, x + 1);
            box.top = Math.min(box.top, y);
            box.bottom = Math.max(box.bottom, y + 1);
          }
        return { ...box, width, height };
      });
      const asSeen = (right - left) / (Math.max(...ys) - Math.min(...ys));
      const proportion = (seen.right - seen.left) / (seen.bottom - seen.top);
      expect(Math.abs(proportion / asSeen - 1)).toBeLessThan(0.03);
      const middle = ((left + right) / 2 - (view.x + view.width / 2)) / (right - left);
      const shown = ((seen.left + seen.right) / 2 - seen.width / 2) / (seen.right - seen.left);
      expect(Math.abs(shown - middle)).toBeLessThan(0.015);
    });
  });
}
