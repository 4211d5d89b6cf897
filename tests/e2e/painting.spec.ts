import type { CDPSession, Page } from "@playwright/test";
import type { PaintLayer } from "../../web/editor/document/index.ts";
import { type EditorPage, expect, type Point, test } from "./support/editor-page.ts";
import { rendered } from "./support/rendered.ts";
import { ringPicture, seamedGlb, twoSquaresGlb } from "./support/test-files.ts";

/** Of the 1024 texels of a row through the middle, how many are not as they were. */
async function paintedAcross(editor: EditorPage, before: Buffer): Promise<{ left: number; right: number }> {
  const now = await middleRow(editor);
  const changed = Array.from(
    { length: now.length / 4 },
    (_, x) => !now.subarray(x * 4, x * 4 + 4).equals(before.subarray(x * 4, x * 4 + 4)),
  );
  const half = changed.length / 2;
  return { left: changed.slice(0, half).filter(Boolean).length, right: changed.slice(half).filter(Boolean).length };
}

const middleRow = (editor: EditorPage): Promise<Buffer> => editor.texels({ x: 0, y: 512, width: 1024, height: 1 });

async function clientPoint(page: Page, x: number, y: number, z = 0): Promise<Point> {
  const point = await page.evaluate((at) => window.texelcast.project(...at) ?? null, [x, y, z] as const);
  if (!point) throw new Error("The place is not in view.");
  return point;
}

async function paintLayers(editor: EditorPage): Promise<PaintLayer[]> {
  return (await editor.design()).layers.filter((layer) => layer.type === "paint");
}

test("a stroke over a seam paints both charts as one step, Escape or undo gives one up, and the eraser takes it away", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([seamedGlb()]);
  const bare = await editor.settledHash();
  const before = await middleRow(editor);
  const [from, to] = [await clientPoint(page, -0.2, 0), await clientPoint(page, 0.2, 0)];

  await page.keyboard.press("b");
  await expect(page.getByRole("radio", { name: "Brush" })).toBeChecked();
  await editor.drag(from, to, 6);
  const painted = await paintedAcross(editor, before);
  expect(painted.left, "texels of the left chart").toBeGreaterThan(100);
  expect(painted.right, "texels of the right chart").toBeGreaterThan(100);
  const [layer] = await paintLayers(editor);
  expect(layer?.strokes).toHaveLength(1);

  const whole = await editor.settledHash();
  const waysOut: Record<string, () => Promise<void>> = {
    Escape: () => page.keyboard.press("Escape"),
    "Control+z": () => page.keyboard.press("Control+z"),
    // As a second finger presses it, while the first one paints.
    "the undo button": () => page.locator("#undo").dispatchEvent("click"),
  };
  for (const [name, giveUp] of Object.entries(waysOut)) {
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x, from.y - 60, { steps: 4 });
    await giveUp();
    await page.mouse.move(from.x, from.y - 90, { steps: 4 });
    await page.mouse.up();
    expect(await editor.settledHash(), `a stroke that was given up by ${name} leaves nothing, and all before it`).toBe(
      whole,
    );
  }

  await page.keyboard.press("e");
  await page.keyboard.press("Shift+BracketRight");
  await page.keyboard.press("Shift+BracketRight");
  for (let step = 0; step < 4; step += 1) await page.keyboard.press("BracketRight");
  await editor.drag(from, to, 6);
  expect(await paintedAcross(editor, before)).toEqual({ left: 0, right: 0 });
  expect((await paintLayers(editor))[0]?.strokes.map(({ blend }) => blend)).toEqual(["normal", "erase"]);

  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(whole);
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(bare);
  await expect(editor.notices).toHaveCount(0);
});

test("the clone tool copies what lies at its source to where it paints, and the command line copies the same bytes", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([seamedGlb()]);
  const bare = await middleRow(editor);
  await page.keyboard.press("b");
  await editor.drag(await clientPoint(page, -0.35, 0), await clientPoint(page, -0.25, 0), 4);
  expect((await paintedAcross(editor, bare)).right).toBe(0);

  await page.keyboard.press("s");
  for (let step = 0; step < 10; step += 1) await page.keyboard.press("BracketRight");
  const source = await clientPoint(page, -0.3, 0);
  await page.mouse.click(source.x, source.y);
  await expect(page.locator("#clone-source")).toHaveAttribute("aria-pressed", "false");
  await editor.drag(await clientPoint(page, 0.2, 0), await clientPoint(page, 0.26, 0), 4);
  await expect
    .poll(async () => (await editor.design()).layers.at(-1))
    .toMatchObject({ type: "group", layers: [{ type: "decal", mask: { invert: true } }] });
  await expect.poll(async () => JSON.stringify((await editor.design()).assets).includes("live:")).toBe(false);
  await editor.idle();
  const { left, right } = await paintedAcross(editor, bare);
  expect(right, "texels of the right chart").toBeGreaterThan(0.9 * left);
  expect(right).toBeLessThan(1.1 * left);

  const picture = await editor.exported("Texture as PNG");
  expect(rendered(await editor.savedProject()).equals(picture.bytes)).toBe(true);
  await page.keyboard.press("Control+z");
  await editor.idle();
  expect((await paintedAcross(editor, bare)).right).toBe(0);

  // Right after its release a stroke is still being written: undo means it all the same, and no step before it.
  const steps = async (): Promise<string[]> => (await editor.design()).layers.map(({ type }) => type);
  expect(await steps()).toEqual(["paint"]);
  const from = await clientPoint(page, 0.2, 0);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 30, from.y, { steps: 4 });
  await page.mouse.up();
  await page.keyboard.press("Control+z");
  await editor.idle();
  expect(await steps()).toEqual(["paint"]);
  await expect(page.locator("#redo")).toBeEnabled();
  await page.keyboard.press("Control+Shift+z");
  await editor.idle();
  expect(await steps()).toEqual(["paint", "group"]);
  await expect(editor.notices).toHaveCount(0);
});

test("a page that is left while what was cloned is still being written asks first", async ({ editor, page }) => {
  await editor.open();
  const asked: string[] = [];
  page.on("dialog", (dialog) => {
    asked.push(dialog.type());
    void dialog.accept();
  });
  await page.keyboard.press("s");
  const middle = await editor.middleOfStage();
  await page.keyboard.down("Alt");
  await page.mouse.click(middle.x, middle.y);
  await page.keyboard.up("Alt");
  await page.evaluate(() => window.texelcast.kept());
  await editor.reload();
  expect(asked, "nothing is under way").toEqual([]);

  await page.keyboard.press("s");
  await page.keyboard.down("Alt");
  await page.mouse.click(middle.x, middle.y);
  await page.keyboard.up("Alt");
  await page.evaluate(() => {
    window.texelcast.engine.setAsset = () => new Promise(() => {});
  });
  await page.mouse.move(middle.x, middle.y + 40);
  await page.mouse.down();
  await page.mouse.move(middle.x + 30, middle.y + 40, { steps: 4 });
  await page.mouse.up();
  await editor.reload();
  expect(asked).toEqual(["beforeunload"]);
});

test("a gradient's end is dragged over the model as one step, given up by Escape, and moved by keys; its colours are added", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([seamedGlb()]);
  await editor.addLayer(/gradient/i);
  const ends = async () => {
    const [layer] = (await editor.design()).layers;
    return layer?.type === "fill" && layer.gradient?.kind === "linear" ? layer.gradient : null;
  };
  const before = await ends();
  const handle = page.locator("[data-gradient-handle=second]");
  await expect(handle).toBeVisible();
  const box = await handle.boundingBox();
  if (!box) throw new Error("The gradient has no handle.");
  const from = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  await editor.drag(from, await clientPoint(page, 0.3, 0.1), 5);
  const dragged = await ends();
  const at = await clientPoint(page, 0.3, 0.1);
  const end = await clientPoint(page, ...(dragged?.to ?? ([0, 0, 0] as const)));
  expect(Math.hypot(end.x - at.x, end.y - at.y), "pixels from where it was let go").toBeLessThan(1);
  expect(dragged?.from).toEqual(before?.from);

  await editor.drag(at, { x: at.x + 40, y: at.y }, 1, () => page.keyboard.press("Escape"));
  expect(await ends()).toEqual(dragged);
  await handle.focus();
  await page.keyboard.press("Shift+ArrowUp");
  expect((await ends())?.to[1]).toBeGreaterThan(dragged?.to[1] as number);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  expect(await ends()).toEqual(before);

  const add = page.getByRole("button", { name: "Add a colour" });
  await add.click();
  await add.click();
  expect((await ends())?.stops).toHaveLength(4);
  await page.keyboard.press("Control+z");
  expect((await ends())?.stops, "each colour is a step, however soon it follows").toHaveLength(3);
});

/** Opens the first demo and adds a gradient; returns how its colours are read. */
async function openOnGradient(editor: EditorPage) {
  await editor.open();
  await editor.addLayer(/gradient/i);
  return async () => {
    const layer = (await editor.design()).layers.find(({ type }) => type === "fill");
    return layer?.type === "fill" ? layer.gradient?.stops : undefined;
  };
}

/** The middle of the first of its colours, in its panel. */
async function firstColor({ page }: EditorPage): Promise<Point> {
  const box = await page.locator("tc-gradient-stops .handle").first().boundingBox();
  if (!box) throw new Error("The gradient has no colours.");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

test("a gradient's colour that is dragged goes back by Escape and by undo, and stays chosen", async ({
  editor,
  page,
}) => {
  const stops = await openOnGradient(editor);
  const before = await stops();
  const bare = await editor.settledHash();
  const from = await firstColor(editor);
  for (const key of ["Escape", "Control+z"]) {
    let shown: typeof before;
    await editor.drag(from, { x: from.x + 60, y: from.y }, 2, async () => {
      if (shown) return;
      shown = await stops();
      await page.keyboard.press(key);
    });
    expect(shown, "what the drag shows").not.toEqual(before);
    expect(await stops(), key).toEqual(before);
    expect(await editor.settledHash(), key).toBe(bare);
    await expect(page.locator("tc-gradient-stops")).toBeVisible();
  }
});

test("a colour that is deleted while it is dragged is gone as one step, and the layer stays", async ({
  editor,
  page,
}) => {
  const stops = await openOnGradient(editor);
  await page.getByRole("button", { name: "Add a colour" }).click();
  const handles = page.locator("tc-gradient-stops .handle");
  await expect(handles).toHaveCount(3);
  const before = await stops();
  const from = await firstColor(editor);
  // Past its neighbour, and then deleted; the moves after that mean nothing any more.
  let step = 0;
  await editor.drag(from, { x: from.x + 160, y: from.y }, 4, async () => {
    step += 1;
    if (step === 3) await page.keyboard.press("Delete");
  });
  expect(await stops()).toEqual(before?.slice(1));
  await expect(page.locator("tc-gradient-stops .handle[aria-current=true]")).toBeFocused();
  await page.keyboard.press("Control+z");
  expect(await stops()).toEqual(before);
  expect((await editor.design()).layers).toHaveLength(3);
});

test("a gradient's colours keep the focus by keys: past each other, and deleted down to two, never the layer", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.addLayer(/gradient/i);
  const add = page.getByRole("button", { name: "Add a colour" });
  for (let colors = 3; colors <= 4; colors += 1) {
    await add.click();
    await expect(page.locator("tc-gradient-stops .handle")).toHaveCount(colors);
  }
  // Over its neighbour by keys: the one that moved keeps the focus.
  const handles = page.locator("tc-gradient-stops .handle");
  await handles.first().focus();
  const stop = (): Promise<string | null> =>
    page.locator("tc-gradient-stops .handle:focus").getAttribute("aria-valuetext");
  const color = (await stop())?.split(", ")[1];
  for (let step = 1; step <= 6; step += 1) {
    await page.keyboard.press("Shift+ArrowRight");
    await expect.poll(stop).toBe(`${step * 10} %, ${color}`);
  }
  await handles.last().focus();
  for (const left of [3, 2, 2, 2]) {
    await page.keyboard.press("Delete");
    await expect(page.locator("tc-gradient-stops .handle")).toHaveCount(left);
    await expect(page.locator("tc-gradient-stops .handle[aria-current=true]")).toBeFocused();
  }
  expect((await editor.design()).layers).toHaveLength(3);
});

test("a stroke over the border of two materials paints both", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([twoSquaresGlb()]);
  await page.keyboard.press("b");
  for (let step = 0; step < 6; step += 1) await page.keyboard.press("BracketRight");
  await editor.drag(await clientPoint(page, -0.3, 0), await clientPoint(page, 0.3, 0), 6);
  const [layer] = await paintLayers(editor);
  expect(layer?.strokes[0]?.material).toEqual([0, 1]);
});

test("a mirror that is chosen for a decal, or for what was painted, reaches the material that its twin lies on", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([twoSquaresGlb()]);
  const shown = async (): Promise<unknown> => (await editor.design()).layers.at(-1);
  const mirrorBy = (axis: "x" | "none") =>
    page
      .locator("tc-layer-properties label")
      .filter({ has: page.locator(`[name=mirror][value=${axis}]`) })
      .click();
  await page.keyboard.press("b");
  await editor.drag(await clientPoint(page, -0.6, 0.3), await clientPoint(page, -0.4, 0.3), 4);
  expect(await shown()).toMatchObject({ type: "paint", strokes: [{ material: 0 }] });
  await mirrorBy("x");
  expect(await shown()).toMatchObject({ mirror: { axis: "x" }, strokes: [{ material: [0, 1] }] });

  // From the choice that has the keyboard now: it takes arrows, and no letters.
  await page.keyboard.press("v");
  await expect(page.getByRole("radio", { name: "Move" })).toBeChecked();
  await editor.drop([ringPicture()], await clientPoint(page, -0.6, 0));
  await expect.poll(shown).toMatchObject({ type: "decal", material: 0 });
  const ring = (await editor.design()).layers.at(-1)?.id as string;
  await mirrorBy("x");
  expect((await editor.decal(ring)).material).toEqual([0, 1]);
  await editor.drag(await editor.pointOf(ring), await clientPoint(page, -0.5, -0.2), 4);
  expect((await editor.decal(ring)).material, "it goes on to").toEqual([0, 1]);
  const picture = await editor.exported("Texture as PNG");
  expect(rendered(await editor.savedProject()).equals(picture.bytes)).toBe(true);
  await mirrorBy("none");
  await expect.poll(async () => (await editor.decal(ring)).mirror).toBeNull();
  expect((await editor.decal(ring)).material).toBe(0);
});

test("Shift and a press draws from where the stroke before ended, and on another model begins anew", async ({
  editor,
  page,
}) => {
  await editor.open();
  await page.keyboard.press("b");
  const middle = await editor.middleOfStage();
  await editor.drag(middle, { x: middle.x - 20, y: middle.y }, 2);
  await editor.openModel([seamedGlb()]);
  const press = async (x: number): Promise<number> => {
    const at = await clientPoint(page, x, 0.1);
    await page.keyboard.down("Shift");
    await page.mouse.click(at.x, at.y);
    await page.keyboard.up("Shift");
    await editor.idle();
    return (await paintLayers(editor))[0]?.strokes.at(-1)?.dabs.length ?? 0;
  };
  expect(await press(-0.3), "dabs of the first press").toBe(1);
  expect(await press(-0.1)).toBeGreaterThan(3);
});

test("a stroke ends where the view is given another size, without a streak to its new place", async ({
  editor,
  page,
}) => {
  await editor.open();
  await page.keyboard.press("b");
  const from = await editor.middleOfStage();
  await page.mouse.move(from.x - 60, from.y + 80);
  await page.mouse.down();
  await page.mouse.move(from.x - 40, from.y + 80, { steps: 4 });
  const dabs = async () => (await paintLayers(editor))[0]?.strokes[0]?.dabs.length;
  await expect.poll(dabs).toBeGreaterThan(2);
  const before = await dabs();
  await editor.resize(1000, 640);
  await expect.poll(async () => (await editor.stage.boundingBox())?.height).toBeLessThan(600);
  await expect(page.locator("#undo")).toBeEnabled();
  const to = await editor.middleOfStage();
  await page.mouse.move(to.x - 20, to.y + 40, { steps: 4 });
  await page.mouse.up();
  await editor.idle();
  expect(await dabs()).toBe(before);
  expect((await paintLayers(editor))[0]?.strokes).toHaveLength(1);
});

test("a pen's pressure reaches the dabs", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([seamedGlb()]);
  await page.keyboard.press("b");
  const pen = await page.context().newCDPSession(page);
  const at = await clientPoint(page, -0.3, 0.1);
  const touch = (type: "mousePressed" | "mouseMoved" | "mouseReleased", x: number, force: number) =>
    pen.send("Input.dispatchMouseEvent", {
      type,
      x,
      y: at.y,
      button: "left",
      buttons: type === "mouseReleased" ? 0 : 1,
      clickCount: 1,
      pointerType: "pen",
      force,
    });
  await touch("mousePressed", at.x, 0.1);
  for (let step = 1; step <= 8; step += 1) await touch("mouseMoved", at.x + step * 12, 0.1 + step * 0.1);
  await touch("mouseReleased", at.x + 96, 0);
  await editor.idle();
  const dabs = (await paintLayers(editor))[0]?.strokes[0]?.dabs ?? [];
  expect(dabs.length).toBeGreaterThan(4);
  expect(dabs[0]?.flow).toBeCloseTo(0.1, 1);
  expect(Math.max(...dabs.map(({ flow }) => flow))).toBeGreaterThan(0.7);
});

test("the flat texture is painted with dabs that lie on the model, and keys paint where their cursor is", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([seamedGlb()]);
  const before = await middleRow(editor);
  await page.keyboard.press("b");
  const view = await page.locator("tc-texture-panel .view").boundingBox();
  if (!view) throw new Error("The texture is not shown.");
  const middle = { x: view.x + view.width / 2, y: view.y + view.height / 2 };
  await editor.drag({ x: middle.x - view.width / 4, y: middle.y }, { x: middle.x - view.width / 8, y: middle.y }, 4);
  const flat = await paintedAcross(editor, before);
  expect(flat.left).toBeGreaterThan(50);
  expect(flat.right).toBe(0);
  expect((await paintLayers(editor))[0]?.strokes[0]?.dabs[0]).toMatchObject({ kind: "planar" });

  await page.getByRole("application", { name: /Model in 3D/ }).focus();
  for (const key of ["ArrowRight", "Enter"]) await page.keyboard.press(key);
  await page.keyboard.down("Enter");
  for (let step = 0; step < 3; step += 1) await page.keyboard.press("ArrowRight");
  await page.keyboard.up("Enter");
  await editor.idle();
  const strokes = (await paintLayers(editor))[0]?.strokes ?? [];
  expect(strokes).toHaveLength(3);
  expect(strokes[2]?.dabs.length).toBeGreaterThan(strokes[1]?.dabs.length ?? 0);
});

test("a picture that is a brush's tip keeps its proportions", async ({ editor, page }) => {
  await editor.open();
  await page.keyboard.press("b");
  await page.locator("#tool-tip").click();
  const tile = page.locator("tc-tip-picker [data-demo=waves]");
  const { width, height } = await tile.locator("img").evaluate((element) => {
    const image = element as HTMLImageElement;
    return { width: image.naturalWidth, height: image.naturalHeight };
  });
  expect(width).toBeGreaterThan(height);
  await tile.click();
  await expect(page.locator("tc-tip-picker [data-tip=Waves]")).toHaveAttribute("aria-pressed", "true");
  await page.keyboard.press("Escape");
  const middle = await editor.middleOfStage();
  await page.mouse.click(middle.x - 60, middle.y + 60);
  await editor.idle();
  const [dab] = (await paintLayers(editor))[0]?.strokes[0]?.dabs ?? [];
  if (dab?.kind !== "planar") throw new Error("Nothing was painted.");
  expect(dab.size[0] / dab.size[1]).toBeCloseTo(width / height, 4);
});

test("a fill's parts and a colour are picked by keys too", async ({ editor, page }) => {
  await editor.open();
  await editor.addLayer("Fill One colour");
  await page.locator("input[name=parts][value=charts]").check();
  const charts = async () => {
    const layer = (await editor.design()).layers.find(({ type }) => type === "fill");
    return layer?.type === "fill" && layer.parts?.kind === "charts" ? layer.parts.charts : null;
  };
  expect(await charts()).toEqual([]);
  const view = page.getByRole("application", { name: /Model in 3D/ });
  await view.focus();
  for (const key of ["ArrowLeft", "ArrowLeft", "Enter"]) await page.keyboard.press(key);
  await expect.poll(charts).toHaveLength(1);
  await editor.idle();
  // Without the fill there are no parts, and the next press must not paint.
  await page.keyboard.press("Escape");
  await expect(page.getByRole("radio", { name: "Move" })).toBeChecked();

  await page.keyboard.press("i");
  for (const key of ["ArrowLeft", "ArrowLeft", " "]) await page.keyboard.press(key);
  await expect(page.locator("#tool-color")).toHaveValue("#7c86c4");
  await page.keyboard.press("v");
  await expect(page.locator(".tcv-marker").first()).toBeHidden();
});

test.describe("on a touch screen", () => {
  test.use({ hasTouch: true });

  const fingers = (cdp: CDPSession, type: "touchStart" | "touchMove" | "touchEnd", ...points: Point[]) =>
    cdp.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(({ x, y }, id) => ({ x, y, id })) });

  test("one finger on the model paints, two turn it and paint nothing", async ({ editor, page }) => {
    await editor.open();
    await editor.openModel([seamedGlb()]);
    await page.locator("[data-tool=brush]").tap();
    const cdp = await page.context().newCDPSession(page);
    const at = await clientPoint(page, 0, 0);
    await fingers(cdp, "touchStart", at);
    for (let step = 1; step <= 4; step += 1) await fingers(cdp, "touchMove", { x: at.x + step * 10, y: at.y });
    await fingers(cdp, "touchEnd");
    await editor.idle();
    expect((await paintLayers(editor))[0]?.strokes).toHaveLength(1);

    const corner = await clientPoint(page, 0.5, 0.5);
    const beside = { x: at.x + 60, y: at.y };
    await fingers(cdp, "touchStart", at);
    await fingers(cdp, "touchStart", at, beside);
    for (let step = 1; step <= 6; step += 1) {
      const away = step * 12;
      await fingers(cdp, "touchMove", { x: at.x + away, y: at.y }, { x: beside.x + away, y: beside.y });
    }
    await fingers(cdp, "touchEnd");
    await editor.idle();
    await expect
      .poll(async () => {
        const now = await clientPoint(page, 0.5, 0.5);
        return Math.hypot(now.x - corner.x, now.y - corner.y);
      })
      .toBeGreaterThan(10);
    expect((await paintLayers(editor))[0]?.strokes).toHaveLength(1);
  });
});
