/** What a window and the page around a view do while somebody works in it: another screen, a dialog, paper, what is selected on the page. */
import type { Locator, Page } from "@playwright/test";
import type { PlanarProjector, UvProjector } from "../../web/editor/document/index.ts";
import { expect, test } from "./support/editor-page.ts";
import { squareGlb } from "./support/test-files.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];

/** The element with a square that faces the camera, and a smiley in its middle. */
async function open(page: Page, mode: "shop" | "full"): Promise<Locator> {
  await page.route("**/square.glb", (route) => route.fulfill({ body: Buffer.from(squareGlb().buffer) }));
  await page.goto(`element.html?mode=${mode}&src=demo/square.glb&size=64&camera-orbit=0deg 90deg auto`);
  const editor = page.locator("texelcast-editor");
  await editor.evaluate(async (element: Editor) => {
    element.select(await element.addDecal("demo/decals/smiley.png", { position: [0, 0, 0], width: 0.1 }));
  });
  await expect(editor.locator(".tcv-alignment-line").first()).toBeAttached();
  return editor;
}

const viewsOf = (editor: Locator): Locator => editor.locator(".tcv-root");

async function middleOf(view: Locator): Promise<{ readonly x: number; readonly y: number }> {
  const box = await view.boundingBox();
  if (!box) throw new Error("The view has no place on the page.");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

const twoFrames = (page: Page): Promise<unknown> =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Metres to the right of the model's middle. */
const decalIn = (editor: Locator): Promise<number> =>
  editor.evaluate(async (element: Editor) => {
    const [layer] = (await element.exportDesign()).design.layers as unknown as { projector: PlanarProjector }[];
    return layer?.projector.position[0] ?? Number.NaN;
  });

/** Where the decal lies after a drag from the middle of the model's view to the left. */
async function draggedLeft(page: Page, editor: Locator): Promise<number> {
  const { x, y } = await middleOf(viewsOf(editor).first());
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 90, y, { steps: 8 });
  await page.mouse.up();
  return await decalIn(editor);
}

/** Once no frame changes it any more. */
async function orbitAtRest(view: Locator): Promise<string> {
  const mark = view.locator(".tcv-outline").first();
  let before = "";
  await expect(async () => {
    const now = (await mark.getAttribute("d")) ?? "";
    const rests = now !== "" && now === before;
    before = now;
    expect(rests).toBe(true);
  }).toPass({ intervals: [250] });
  return before;
}

for (const mode of ["shop", "full"] as const) {
  test(`in ${mode} mode views are as sharp on the screen that their window is moved to as on the one before`, async ({
    page,
  }) => {
    const editor = await open(page, mode);
    const screen = await page.context().newCDPSession(page);
    const { width, height } = page.viewportSize() ?? { width: 0, height: 0 };
    /** Of each view's canvas for one of the page's. */
    const pixels = (): Promise<number[]> =>
      viewsOf(editor)
        .locator("canvas")
        .evaluateAll((canvases: HTMLCanvasElement[]) =>
          canvases.map((canvas) => Math.round((10 * canvas.width) / canvas.clientWidth) / 10),
        );
    const views = mode === "shop" ? 1 : 2;
    await expect.poll(pixels).toEqual(Array(views).fill(1));
    for (const deviceScaleFactor of [2, 1.1, 1.5]) {
      await screen.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor, mobile: false });
      // A browser without a head asks what it is shown on when it is looked at.
      await screen.send("Page.captureScreenshot");
      await expect.poll(pixels).toEqual(Array(views).fill(deviceScaleFactor));
    }
  });

  test(`in ${mode} mode a drag is the view's own where the page around it is selected`, async ({ page }) => {
    const editor = await open(page, mode);
    await page.evaluate(() => getSelection()?.selectAllChildren(document.body));
    expect(await draggedLeft(page, editor)).toBeLessThan(-0.05);
  });

  test(`in ${mode} mode a drag is the view's own where what it stands in can be dragged itself`, async ({ page }) => {
    const editor = await open(page, mode);
    // As page builders and sorted lists have it.
    await editor.evaluate((element: Editor) => {
      (element.parentElement as HTMLElement).draggable = true;
    });
    expect(await draggedLeft(page, editor)).toBeLessThan(-0.05);
  });

  test(`in ${mode} mode the middle button is the views', and does not scroll the page`, async ({ page }) => {
    const editor = await open(page, mode);
    await page.evaluate(() => {
      const pressed: string[] = [];
      Object.assign(window, { pressed });
      addEventListener("mousedown", ({ button, defaultPrevented }) => pressed.push(`${button} ${defaultPrevented}`));
    });
    const views = await viewsOf(editor).all();
    for (const view of views) {
      const { x, y } = await middleOf(view);
      for (const button of ["middle", "left"] as const) await page.mouse.click(x, y, { button });
    }
    // A press of the left one gives the view the keyboard.
    const pressed = await page.evaluate(() => (window as unknown as { pressed: string[] }).pressed);
    expect(pressed).toEqual(views.flatMap(() => ["1 true", "0 false"]));
  });

  test(`in ${mode} mode a wheel that turns while a button is down on a view does not scroll the page`, async ({
    page,
  }) => {
    const editor = await open(page, mode);
    await page.evaluate(() => {
      document.body.style.paddingBlockEnd = "3000px";
    });
    const { x, y } = await middleOf(viewsOf(editor).first());
    for (const button of ["left", "middle", "right"] as const) {
      await page.mouse.move(x, y - 190);
      await page.mouse.down({ button });
      await page.mouse.move(x + 20, y - 190, { steps: 3 });
      await page.mouse.wheel(0, 200);
      await page.mouse.up({ button });
    }
    await twoFrames(page);
    expect(await page.evaluate(() => scrollY)).toBe(0);
  });

  test(`in ${mode} mode a decal stays where its drag has brought it when its view is hidden`, async ({ page }) => {
    const editor = await open(page, mode);
    const { x, y } = await middleOf(viewsOf(editor).first());
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 90, y, { steps: 8 });
    await expect.poll(() => decalIn(editor)).toBeLessThan(-0.05);
    const before = await decalIn(editor);
    await editor.evaluate((element: Editor) => {
      element.hidden = true;
    });
    await twoFrames(page);
    await page.mouse.move(x - 80, y, { steps: 4 });
    await page.mouse.up();
    expect(await decalIn(editor)).toBe(before);
  });

  test(`in ${mode} mode the model stays where a dialog left it that came while it was turned`, async ({ page }) => {
    const editor = await open(page, mode);
    const view = viewsOf(editor).first();
    const at = await middleOf(view);
    const mouse = await page.context().newCDPSession(page);
    const move = (x: number, buttons: number): Promise<unknown> =>
      mouse.send("Input.dispatchMouseEvent", { type: "mouseMoved", x, y: at.y - 190, button: "none", buttons });
    await page.mouse.move(at.x, at.y - 190);
    await page.mouse.down();
    await page.mouse.move(at.x + 30, at.y - 190, { steps: 4 });
    page.on("dialog", (dialog) => dialog.accept());
    await page.evaluate(() => alert("Your session has ended."));
    // Let go in the dialog.
    await move(at.x + 31, 0);
    const before = await orbitAtRest(view);
    await move(at.x + 120, 0);
    await move(at.x + 200, 0);
    expect(await orbitAtRest(view)).toBe(before);
  });
}

test("the flat texture stays where a dialog left it that came while it was moved", async ({ page }) => {
  const editor = await open(page, "full");
  await editor.evaluate(async (element: Editor) => {
    const projector = { kind: "uv", center: [0.5, 0.5], size: [0.3, 0.3], angle: 0 } as const;
    element.select(await element.addDecal("demo/decals/smiley.png", { projector }));
  });
  const flat = viewsOf(editor).nth(1);
  const box = await flat.boundingBox();
  if (!box) throw new Error("The texture has no place on the page.");
  const [x, y] = [box.x + 10, box.y + 10];
  const mouse = await page.context().newCDPSession(page);
  const move = (to: number): Promise<unknown> =>
    mouse.send("Input.dispatchMouseEvent", { type: "mouseMoved", x: to, y, button: "none", buttons: 0 });
  const first = await orbitAtRest(flat);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y, { steps: 4 });
  page.on("dialog", (dialog) => dialog.accept());
  await page.evaluate(() => alert("Your session has ended."));
  await move(x + 21);
  const before = await orbitAtRest(flat);
  expect(before).not.toBe(first);
  await move(x + 60);
  await move(x + 90);
  expect(await orbitAtRest(flat)).toBe(before);
});

test("a stamp stays where its drag has brought it when the flat texture is hidden", async ({ page }) => {
  const editor = await open(page, "full");
  await editor.evaluate(async (element: Editor) => {
    element.removeLayer(element.selected ?? "");
    const projector = { kind: "uv", center: [0.5, 0.5], size: [0.3, 0.3], angle: 0 } as const;
    element.select(await element.addDecal("demo/decals/smiley.png", { projector }));
  });
  const stamp = (): Promise<readonly number[]> =>
    editor.evaluate(async (element: Editor) => {
      const [layer] = (await element.exportDesign()).design.layers as unknown as { projector: UvProjector }[];
      return layer?.projector.center ?? [];
    });
  const flat = viewsOf(editor).nth(1);
  await orbitAtRest(flat);
  const { x, y } = await middleOf(flat);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 30, y + 40, { steps: 4 });
  const before = await stamp();
  expect(before[0]).toBeGreaterThan(0.52);
  await editor.evaluate((element: Editor) => {
    element.hidden = true;
  });
  await twoFrames(page);
  await page.mouse.move(x + 31, y + 40);
  await page.mouse.up();
  expect(await stamp()).toEqual(before);
});

test("the right button moves the model and the flat texture, and no menu of the browser's comes over them", async ({
  page,
}) => {
  const editor = await open(page, "full");
  await page.evaluate(() => {
    const menus: boolean[] = [];
    Object.assign(window, { menus });
    addEventListener("contextmenu", ({ defaultPrevented }) => menus.push(!defaultPrevented));
  });
  for (const view of await viewsOf(editor).all()) {
    const box = await view.boundingBox();
    if (!box) throw new Error("The view has no place on the page.");
    await page.mouse.move(box.x + 20, box.y + box.height - 20);
    await page.mouse.down({ button: "right" });
    await page.mouse.move(box.x + 60, box.y + box.height - 40, { steps: 4 });
    await page.mouse.up({ button: "right" });
  }
  expect(await page.evaluate(() => (window as unknown as { menus: boolean[] }).menus)).toEqual([false, false]);
});

/** Moves the pressed mouse, has a dialog come in which it is let go, and gives the way of the mouse from there on. */
async function letGoInDialog(
  page: Page,
  to: { x: number; y: number },
): Promise<(x: number, y: number) => Promise<void>> {
  const mouse = await page.context().newCDPSession(page);
  await page.mouse.move(to.x, to.y, { steps: 4 });
  page.on("dialog", (dialog) => dialog.accept());
  await page.evaluate(() => alert("Your session has ended."));
  return async (x, y) => {
    await mouse.send("Input.dispatchMouseEvent", { type: "mouseMoved", x, y, button: "none", buttons: 0 });
  };
}

test("a layer that is let go in a dialog stays where it was, and the next press is not its", async ({
  editor,
  page,
}) => {
  await editor.open();
  const names = async (): Promise<string[]> => (await editor.design()).layers.map(({ name }) => name);
  const before = await names();
  const from = await middleOf(editor.row("Smiley"));
  const to = await middleOf(editor.row("Texelcast mark"));
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  const hover = await letGoInDialog(page, { x: to.x, y: to.y + 8 });
  await hover(to.x, to.y + 10);
  await page.mouse.up();
  expect(await names()).toEqual(before);
});

test("a colour of a gradient that is let go in a dialog stays there, and keys are the page's again", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.addLayer("Gradient");
  const offsets = async (): Promise<number[]> => {
    const layer = (await editor.design()).layers.find(({ type }) => type === "fill");
    return layer?.type === "fill" ? (layer.gradient?.stops.map(({ offset }) => offset) ?? []) : [];
  };
  const count = (await editor.design()).layers.length;
  const { x, y } = await middleOf(page.locator("tc-gradient-stops .handle").first());
  await page.mouse.move(x, y);
  await page.mouse.down();
  const hover = await letGoInDialog(page, { x: x + 40, y });
  await hover(x + 41, y);
  const before = await offsets();
  expect(before[0]).toBeGreaterThan(0.05);
  // Over the colour's own handle.
  await hover(x + 45, y);
  expect(await offsets()).toEqual(before);
  await page.keyboard.press("b");
  await expect(page.getByRole("radio", { name: "Brush" })).toBeChecked();
  await page.keyboard.press("Control+z");
  await editor.idle();
  expect(await offsets()).toEqual([0, 1]);
  expect((await editor.design()).layers).toHaveLength(count);
});

test("on paper a product keeps its proportions, and no handles lie beside what they are for", async ({ page }) => {
  const editor = await open(page, "shop");
  await expect(editor.locator(".tcv-overlay .tcv-outline").first()).toBeVisible();
  await page.emulateMedia({ media: "print" });
  await expect(editor.locator(".tcv-overlay .tcv-outline").first()).toBeHidden();
  // Paper is narrower than the window; nothing draws for it.
  await expect(viewsOf(editor).locator("canvas")).toHaveCSS("object-fit", "contain");
});
