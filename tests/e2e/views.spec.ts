import { readFileSync } from "node:fs";
import type { Locator, Page } from "@playwright/test";
import { type EditorPage, expect, type Point, test } from "./support/editor-page.ts";
import { lookAlike } from "./support/look-alike.ts";
import { file } from "./support/test-files.ts";

const TEMPLATE = new URL("../../build/public/demo/block-wide.glb", import.meta.url);
const blockFigure = () => file("block-wide.glb", readFileSync(TEMPLATE));

/** Pixels of the figure, metres: 1.8 m are 32 of them. */
const px = (count: number): number => (count * 1.8) / 32;

async function openTemplate(page: Page, id: string): Promise<void> {
  await page.locator("tc-top-bar .models button").first().click();
  await page.getByRole("menuitem", { name: "New from template…" }).click();
  await page.locator(`[data-template=${id}]`).click();
}

test("a wheel beside the model comes nearer to it, and does not lose it", async ({ editor, page }) => {
  // The view goes there at once.
  await page.emulateMedia({ reducedMotion: "reduce" });
  await editor.open();
  const view = await editor.view.boundingBox();
  if (!view) throw new Error("The page shows no model.");
  const mug = async (height = 0.05): Promise<Point> =>
    (await page.evaluate((y) => window.texelcast.project(0, y, 0), height)) ?? view;
  const tallness = async (): Promise<number> => (await mug(0)).y - (await mug(0.09)).y;
  const before = await tallness();
  await page.mouse.move(view.x + view.width - 30, view.y + view.height - 15);
  for (let step = 0; step < 4; step += 1) await page.mouse.wheel(0, -200);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const seen = await mug();
  expect(seen.x).toBeGreaterThan(view.x);
  expect(seen.x).toBeLessThan(view.x + view.width);
  expect(seen.y).toBeGreaterThan(view.y);
  expect(seen.y).toBeLessThan(view.y + view.height);
  expect(await tallness()).toBeGreaterThan(before * 1.5);
});

test("a wheel on the model comes near to its surface, and not through it", async ({ editor, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await editor.open();
  const view = await editor.view.boundingBox();
  if (!view) throw new Error("The page shows no model.");
  const onWall = () => page.evaluate(() => window.texelcast.project(0.017, 0.05, 0.037));
  const before = await onWall();
  if (!before) throw new Error("The mug is not in view.");
  await page.mouse.move(before.x, before.y);
  for (let step = 0; step < 40; step += 1) await page.mouse.wheel(0, -300);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  // From within the mug it would lie behind the camera.
  const near = await onWall();
  expect(Math.hypot((near?.x ?? 0) - before.x, (near?.y ?? 0) - before.y)).toBeLessThan(60);
  await page.keyboard.press("f");
  await expect
    .poll(() => page.evaluate(() => window.texelcast.project(0, 0, 0)?.y ?? 0))
    .toBeLessThan(view.y + view.height);
});

test("a template opens at 64 × 64, its outer layer hidden, with a guide of its parts", async ({ editor, page }) => {
  await editor.open();
  await openTemplate(page, "block-slim");
  await expect(page.locator("tc-top-bar .models")).toContainText("Block figure, slim arms");
  await editor.idle();
  expect(await editor.textureSize()).toEqual({ width: 64, height: 64 });
  expect((await editor.design()).layers).toEqual([]);
  await page.locator("tc-texture-panel #guide").check();
  await expect(page.locator(".tcv-guide-names text.tcv-part", { hasText: /^Torso$/ })).toBeVisible();
  await expect(page.locator("tc-parts-list li.off")).toHaveCount(6);
  await page.locator("tc-parts-list [data-group=Overlay]").click();
  await expect(page.locator("tc-parts-list li.off")).toHaveCount(0);
});

test("the pointer's chart lights up in both views, and the flat view says which texel it is on", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([blockFigure()]);
  const flat = page.locator("tc-texture-panel .view");
  const before = await flat.screenshot();
  const face = await page.evaluate((at) => window.texelcast.project(...at), [0, px(28), px(4)] as const);
  if (!face) throw new Error("The figure's face is not in view.");
  const model = await editor.stage.screenshot();
  await page.mouse.move(face.x, face.y);
  await expect.poll(async () => lookAlike(await flat.screenshot(), before)).toBe(false);
  await expect.poll(async () => lookAlike(await editor.stage.screenshot(), model)).toBe(false);
  const box = await flat.boundingBox();
  if (!box) throw new Error("There is no flat view.");
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await expect(page.locator("tc-texture-panel #texel")).toHaveText(/^3[12], 3[12]$/);
});

test("unlit, the model shows its texels' own colours", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([blockFigure()]);
  await page.locator("#view-menu").click();
  await page.locator("tc-view-menu input[value=unlit]").check();
  await page.locator("#view-menu").click();
  await page.locator("#view-menu").click();
  await page.keyboard.press("Escape");
  await expect(page.locator("#view-panel"), "Escape closes it from its button, too").toHaveCount(0);
  await expect(page.locator("#view-menu")).toBeFocused();
  await page.mouse.move(4, 300);
  const [red, green, blue] = await editor.texels({ x: 23, y: 26, width: 1, height: 1 });
  const chest = await page.evaluate((at) => window.texelcast.project(...at), [0, px(17.5), px(2)] as const);
  if (!chest) throw new Error("The figure's chest is not in view.");
  await expect
    .poll(async () => {
      const clip = { x: Math.round(chest.x) - 2, y: Math.round(chest.y) - 2, width: 4, height: 4 };
      const png = (await page.screenshot({ clip })).toString("base64");
      return page.evaluate(async (data) => {
        const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
        const canvas = new OffscreenCanvas(4, 4).getContext("2d");
        canvas?.drawImage(image, 0, 0);
        return [...(canvas?.getImageData(1, 1, 1, 1).data.slice(0, 3) ?? [])];
      }, png);
    })
    .toEqual([red, green, blue]);
});

test("a part that is hidden lets the pointer through to what is behind it", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([blockFigure()]);
  const placed = async (): Promise<readonly number[]> => {
    const id = await editor.addDemoDecal("smiley");
    const { projector } = await editor.decal(id);
    await page.locator("#undo").click();
    await editor.idle();
    return projector.kind === "planar" ? projector.position : [];
  };
  const on = await placed();
  await page.getByRole("button", { name: "Hide Torso", exact: true }).click();
  const before = await editor.hash();
  const through = await placed();
  expect(Math.hypot(...on.map((value, axis) => value - (through[axis] ?? 0)))).toBeGreaterThan(px(2));
  expect(await editor.hash(), "hiding paints nothing").toBe(before);
  await page.locator("#show-all-parts").click();
});

/** The block figure with its hand raised; returns the bar of its animations. */
async function pauseInMidWave(editor: EditorPage, page: Page, { hint = false } = {}): Promise<Locator> {
  await editor.open({ hint });
  await editor.openModel([blockFigure()]);
  await page.locator("#play").click();
  const bar = page.locator("tc-animation-bar");
  await bar.locator("#clip").selectOption({ label: "Wave" });
  await bar.locator("#play").click();
  await bar.locator("#scrub").fill("60");
  return bar;
}

test("a model that moves stands above its bar, in a window and on a phone", async ({ editor, page }) => {
  await pauseInMidWave(editor, page);
  for (const [width, height] of [
    [1280, 800],
    [390, 844],
    [844, 390],
    [375, 667],
  ] as const) {
    await editor.resize(width, height);
    const [view, bar] = await editor.places(editor.view, page.locator("tc-animation-bar .bar"));
    expect(bar.y, `${width} × ${height}`).toBeGreaterThanOrEqual(view.y + view.height);
  }
});

test("the first steps stand above the bar of a model that moves", async ({ editor, page }) => {
  await pauseInMidWave(editor, page, { hint: true });
  const [hint, bar] = await editor.places(page.locator("tc-first-hint section"), page.locator("tc-animation-bar .bar"));
  expect(hint.y + hint.height).toBeLessThanOrEqual(bar.y);
});

test("a decal that is placed on a posed model lies on the same place of the resting one", async ({ editor, page }) => {
  const bar = await pauseInMidWave(editor, page);
  // The front of the raised right hand, where it is seen, and where the arm hangs at rest.
  const hand = [px(-6), px(14), px(2)] as const;
  const seen = await page.evaluate((at) => window.texelcast.project(...at), hand);
  if (!seen) throw new Error("The hand is not in view.");
  await editor.drop(
    [
      file(
        "ring.png",
        readFileSync(new URL("../../build/public/demo/decals/smiley.png", import.meta.url)),
        "image/png",
      ),
    ],
    seen,
  );
  const [layer] = (await editor.design()).layers;
  if (layer?.type !== "decal" || layer.projector.kind !== "planar") throw new Error("No decal was placed.");
  const [x, y, z] = layer.projector.position;
  expect(Math.hypot(x - hand[0], y - hand[1])).toBeLessThan(px(0.6));
  expect(Math.abs(z - hand[2])).toBeLessThan(px(2));
  await bar.locator("#rest").click();
  await expect(bar.locator("#scrub")).toHaveCount(0);
  const resting = await page.evaluate((at) => window.texelcast.project(...at), hand);
  expect(Math.hypot((resting?.x ?? 0) - seen.x, (resting?.y ?? 0) - seen.y)).toBeGreaterThan(60);
});

test("on a posed model a decal is moved as it is seen, by keys and by the mouse, and the pose stays", async ({
  editor,
  page,
}) => {
  const bar = await pauseInMidWave(editor, page);
  const seenAt = async (at: readonly [number, number, number]) => {
    const point = await page.evaluate((place) => window.texelcast.project(...place), at);
    if (!point) throw new Error("The place is not in view.");
    return point;
  };
  const ring = readFileSync(new URL("../../build/public/demo/decals/smiley.png", import.meta.url));
  // The middle of the lower arm's front.
  await editor.drop([file("ring.png", ring, "image/png")], await seenAt([px(-6), px(16), px(2)]));
  const place = async (): Promise<{ x: number; y: number }> => {
    const [layer] = (await editor.design()).layers;
    if (layer?.type !== "decal" || layer.projector.kind !== "planar") throw new Error("No decal was placed.");
    return seenAt(layer.projector.position);
  };
  const placed = await place();
  await bar.locator("#scrub").blur();
  for (let step = 0; step < 3; step++) await page.keyboard.press("ArrowUp");
  await editor.idle();
  const raised = await place();
  expect(placed.y - raised.y, "up on the screen").toBeGreaterThan(3);
  expect(Math.abs(raised.x - placed.x)).toBeLessThan((placed.y - raised.y) / 2);
  await editor.drag(raised, { x: placed.x, y: placed.y }, 5);
  const dragged = await place();
  expect(Math.hypot(dragged.x - placed.x, dragged.y - placed.y)).toBeLessThan(4);
  const [from, before] = [await editor.handle("ne"), await editor.design()];
  await editor.drag(from, { x: from.x + (from.x - dragged.x) / 2, y: from.y + (from.y - dragged.y) / 2 }, 5);
  const widthOf = ({ layers: [layer] }: typeof before): number =>
    layer?.type === "decal" && layer.projector.kind === "planar" ? layer.projector.size[0] : 0;
  expect(widthOf(await editor.design()) / widthOf(before), "a corner pulled out by half").toBeCloseTo(1.25, 1);
  await expect(bar.locator("#scrub"), "the model keeps its pose").toHaveValue("60");
});

test("the views are chosen by keys, and on a phone the flat texture takes the model's place", async ({
  editor,
  page,
}) => {
  await editor.open();
  await page.keyboard.press("Alt+3");
  await expect(page.locator("tc-stage")).toHaveCount(0);
  await page.keyboard.press("Alt+1");
  await expect(page.locator("tc-texture-panel")).toHaveCount(0);
  await page.keyboard.press("Alt+2");
  await expect(page.locator("tc-texture-panel")).toBeVisible();
  await editor.resize(390, 844);
  await page.locator("#swap-views").click();
  const [flat, sheet] = await editor.places(page.locator("tc-texture-panel"), page.locator("tc-bottom-sheet"));
  expect(flat.height).toBeGreaterThan(844 * 0.35);
  expect(flat.y + flat.height).toBeLessThanOrEqual(sheet.y + 1);
  await page.locator("#swap-views").click();
  await expect(page.locator("tc-stage")).toBeVisible();
});
