import type { Page } from "@playwright/test";
import { expect, type Region, test } from "./support/editor-page.ts";
import { twoSquaresGlb } from "./support/test-files.ts";

/** The texels in which the shown texture differs from the one that `window.base` holds. */
async function changedRegion(page: Page, size: { width: number; height: number }): Promise<Region> {
  return page.evaluate(async ({ width, height }) => {
    const base = (window as unknown as { base: Uint32Array }).base;
    const bytes = await window.texelcast.readTexels(0, 0, width, height);
    const now = new Uint32Array(bytes.slice().buffer);
    let [left, top, right, bottom] = [width, height, -1, -1];
    for (let at = 0; at < now.length; at += 1) {
      if (now[at] === base[at]) continue;
      const [x, y] = [at % width, Math.floor(at / width)];
      left = Math.min(left, x);
      right = Math.max(right, x);
      top = Math.min(top, y);
      bottom = Math.max(bottom, y);
    }
    return { x: left, y: top, width: right - left + 1, height: bottom - top + 1 };
  }, size);
}

async function rememberBase(page: Page, size: { width: number; height: number }): Promise<void> {
  await page.evaluate(async ({ width, height }) => {
    const bytes = await window.texelcast.readTexels(0, 0, width, height);
    (window as unknown as { base: Uint32Array }).base = new Uint32Array(bytes.slice().buffer);
  }, size);
}

test("texels change in the middle of a drag, the old place gets the base's bytes back, undo and redo are exact", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.removeAllDecals();
  const size = await editor.textureSize();
  await rememberBase(page, size);
  const base = await editor.hash();

  const id = await editor.addDemoDecal("flower");
  // Small enough to be dragged clear of its old place.
  await editor.setField("size-width", "16");
  const start = await editor.settledHash();
  const oldPlace = await changedRegion(page, size);
  expect(oldPlace.width).toBeGreaterThan(10);
  const { bakeCount, projectionCount } = await editor.stats();

  const from = await editor.pointOf(id);
  const seen = new Set([start]);
  await editor.drag(from, { x: from.x - 130, y: from.y + 20 }, 8, async () => {
    const known = seen.size;
    await expect
      .poll(async () => {
        seen.add(await editor.hash());
        return seen.size;
      })
      .toBeGreaterThan(known);
  });
  expect(seen.size).toBeGreaterThan(8);
  const moved = await editor.hash();
  expect(moved).not.toBe(start);

  const newPlace = await changedRegion(page, size);
  const apart = newPlace.x + newPlace.width <= oldPlace.x || oldPlace.x + oldPlace.width <= newPlace.x;
  expect(apart, "the decal was dragged clear of its old place").toBe(true);
  const oldTexels = await page.evaluate(
    async ({ x, y, width, height, size }) => {
      const whole = (window as unknown as { base: Uint32Array }).base;
      const part = new Uint32Array((await window.texelcast.readTexels(x, y, width, height)).slice().buffer);
      return part.every((texel, at) => texel === whole[(y + Math.floor(at / width)) * size.width + x + (at % width)]);
    },
    { ...oldPlace, size },
  );
  expect(oldTexels, "every texel of the old place is the base's again").toBe(true);

  const after = await editor.stats();
  expect(after.bakeCount, "nothing was baked again").toBe(bakeCount);
  expect(after.projectionCount).toBeGreaterThan(projectionCount);

  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(start);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(base);
  await page.keyboard.press("Control+Shift+z");
  await page.keyboard.press("Control+y");
  await page.keyboard.press("Control+y");
  expect(await editor.settledHash()).toBe(moved);
});

test("a drag is one step of the history, and Escape or undo in its middle puts the decal back", async ({
  editor,
  page,
}) => {
  await editor.open();
  const id = await editor.lowestLayer();
  const start = await editor.hash();
  const from = await editor.pointOf(id);
  for (const keys of ["Escape", "Control+z"]) {
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 40, from.y, { steps: 4 });
    await expect.poll(() => editor.hash()).not.toBe(start);
    await page.keyboard.press(keys);
    await page.mouse.up();
    expect(await editor.settledHash(), keys).toBe(start);
    await expect(page.locator("#undo")).toBeDisabled();
  }

  await editor.drag(from, { x: from.x + 40, y: from.y - 20 }, 6);
  await page.locator("#undo").click();
  expect(await editor.settledHash()).toBe(start);
  await expect(page.locator("#undo")).toBeDisabled();
});

test("the outline follows a drag without new styles, on a layer of its own, and is a path again at its end", async ({
  editor,
  page,
}) => {
  const id = await editor.openOnLowest();
  const overlays = editor.view.locator(".tcv-overlay");
  const overlay = overlays.filter({ has: page.locator("[data-handle]") });
  const path = overlay.locator("path.tcv-outline");
  const pieces = overlay.locator('polyline.tcv-outline:not([points=""])');
  await expect(overlay).toHaveCSS("will-change", "transform");
  await expect(path).toHaveAttribute("d", /^M/);
  await expect(pieces).toHaveCount(0);
  const rest = await path.boundingBox();

  const from = await editor.pointOf(id);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 20, from.y, { steps: 4 });
  await expect(pieces).not.toHaveCount(0);
  await expect(path).toHaveAttribute("d", "");
  expect(await pieces.first().evaluate((line) => getComputedStyle(line).stroke)).toBe(
    await path.evaluate((line) => getComputedStyle(line).stroke),
  );
  expect(await pieces.first().evaluate((line) => getComputedStyle(line).fill)).toBe("none");
  const seen = await overlay.evaluate((drawing) => {
    const lines = [...drawing.querySelectorAll('polyline.tcv-outline:not([points=""])')];
    return Math.min(...lines.map((line) => line.getBoundingClientRect().left));
  });
  expect(Math.abs(seen - (rest?.x ?? 0) - 20), "where the outline was, twenty pixels on").toBeLessThan(15);

  await page.keyboard.press("Escape");
  await page.mouse.up();
  await expect(path).toHaveAttribute("d", /^M/);
  await expect(pieces).toHaveCount(0);
  expect(await path.boundingBox()).toEqual(rest);
});

test("a drag that loses the pointer ends where it was, and the decal does not hang on the pointer", async ({
  editor,
  page,
}) => {
  const id = await editor.openOnLowest();
  const from = await editor.pointOf(id);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 20, from.y);
  await page.mouse.move(from.x + 30, from.y);
  // As a dialog of the browser does.
  await editor.view.evaluate((view) => {
    for (let id = 0; id < 99; id += 1) if (view.hasPointerCapture(id)) view.releasePointerCapture(id);
  });
  await page.mouse.move(from.x + 40, from.y);
  await editor.idle();
  const dropped = await editor.decal(id);
  // Let go where the view does not hear of it.
  await page.mouse.move(1200, 20);
  await page.mouse.up();
  await page.mouse.move(from.x + 80, from.y + 30);
  await page.mouse.move(from.x + 90, from.y + 40);
  await editor.idle();
  expect((await editor.decal(id)).projector).toEqual(dropped.projector);
  await page.locator("#undo").click();
  expect((await editor.decal(id)).projector).not.toEqual(dropped.projector);
});

test("the handles rotate and scale the decal", async ({ editor, page }) => {
  await editor.open();
  const id = await editor.lowestLayer();
  const start = await editor.hash();
  const before = (await editor.decal(id)).projector;

  const rotate = await editor.handle("rotate");
  const centre = await editor.pointOf(id);
  await editor.drag(rotate, { x: centre.x + (centre.y - rotate.y), y: centre.y }, 8);
  const turned = (await editor.decal(id)).projector;
  expect(turned).not.toEqual(before);
  expect("size" in turned && "size" in before && turned.size).toEqual("size" in before && before.size);
  const rotated = await editor.settledHash();
  expect(rotated).not.toBe(start);

  const corner = await editor.handle("se");
  const middle = await editor.pointOf(id);
  await editor.drag(corner, { x: (corner.x + middle.x) / 2, y: (corner.y + middle.y) / 2 }, 8);
  const scaled = (await editor.decal(id)).projector;
  if (scaled.kind !== "planar" || before.kind !== "planar") throw new Error("The decal is not planar.");
  expect(scaled.size[0]).toBeLessThan(before.size[0] * 0.9);
  expect(scaled.size[0] / scaled.size[1]).toBeCloseTo(before.size[0] / before.size[1], 5);

  await page.locator("#undo").click();
  expect(await editor.settledHash()).toBe(rotated);
  await page.locator("#undo").click();
  expect(await editor.settledHash()).toBe(start);
});

test("a demo decal is dragged from the palette onto the model, and on to another material", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([twoSquaresGlb()]);
  const at = (x: number) =>
    page.evaluate((place) => window.texelcast.project(place, 0, 0) as { x: number; y: number }, x);
  const bare = await editor.hash();
  const right = await at(0.55);
  const source = await page.locator("tc-decal-palette [data-decal=badge]").boundingBox();
  if (!source) throw new Error("The palette has no badge.");
  await editor.drag({ x: source.x + 20, y: source.y + 20 }, right, 8);
  await expect.poll(async () => (await editor.design()).layers.length).toBe(1);
  await editor.idle();
  const [layer] = (await editor.design()).layers;
  expect(layer?.material).toBe(1);
  const material = page.locator("tc-target-settings #material");
  await expect(material).toHaveValue("1");
  const painted = await editor.settledHash();
  expect(painted).not.toBe(bare);

  await editor.drag(right, await at(-0.55), 10);
  expect((await editor.decal(layer?.id ?? "")).material).toBe(0);
  await expect(material).toHaveValue("0");
  expect(await editor.settledHash()).not.toBe(bare);
  await page.keyboard.press("Control+z");
  await expect(material).toHaveValue("1");
  expect(await editor.settledHash()).toBe(painted);
});

test("a decal that is dragged over the border of two materials paints both while it is dragged", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([twoSquaresGlb()]);
  const at = (x: number) =>
    page.evaluate((place) => window.texelcast.project(place, 0, 0) as { x: number; y: number }, x);
  const hashOf = (material: number) => page.evaluate((index) => window.texelcast.engine.hash(index), material);
  const source = await page.locator("tc-decal-palette [data-decal=badge]").boundingBox();
  if (!source) throw new Error("The palette has no badge.");
  const [right, border] = [await at(0.55), await at(0.06)];
  await editor.drag({ x: source.x + 20, y: source.y + 20 }, right, 8);
  await expect.poll(async () => (await editor.design()).layers.length).toBe(1);
  await editor.idle();
  const [layer] = (await editor.design()).layers;
  const material = page.locator("tc-layer-properties #material");
  expect(layer?.material).toBe(1);
  await expect(material).toHaveValue("1");

  await page.mouse.move(right.x, right.y);
  await page.mouse.down();
  await page.mouse.move(border.x, border.y, { steps: 10 });
  await expect.poll(async () => (await editor.design()).layers[0]?.material).toEqual([0, 1]);
  await editor.idle();
  const [left, both] = [await hashOf(0), await hashOf(1)];
  await page.mouse.move(border.x, border.y - 12, { steps: 4 });
  await editor.idle();
  expect(await hashOf(0)).not.toBe(left);
  expect(await hashOf(1)).not.toBe(both);
  await page.mouse.up();
  await editor.idle();
  await expect(page.locator("tc-layer-list .row")).toHaveCount(1);
  await expect(material.locator("option:checked")).toHaveText("Left, Right");
  // The texture view stays where it was: the decal is on that material still.
  await expect(page.locator("tc-target-settings #material")).toHaveValue("1");

  // Kept to one side, it leaves the other one bare, and comes back by the choice of all.
  const crossing = await hashOf(0);
  await material.selectOption("1");
  await editor.idle();
  expect((await editor.design()).layers[0]?.material).toBe(1);
  expect(await hashOf(0)).not.toBe(crossing);
  await material.selectOption({ label: "All that it meets" });
  await editor.idle();
  expect((await editor.design()).layers[0]?.material).toEqual([0, 1]);
  expect(await hashOf(0)).toBe(crossing);
});

test("a click on a decal in the view selects it", async ({ editor, page }) => {
  await editor.open();
  const { id, name } = (await editor.design()).layers[0] ?? { id: "", name: "" };
  await page.evaluate(() => window.texelcast.select(null));
  await expect(page.locator("tc-layer-properties")).toContainText("Nothing selected");
  const at = await editor.pointOf(id);
  await page.mouse.click(at.x, at.y);
  expect(await editor.selectedName()).toBe(name);
});
