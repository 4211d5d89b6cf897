/** Handles of a decal that is small on the screen, by a finger and by a mouse. */
import type { Locator } from "@playwright/test";
import type { DecalLayer } from "../../web/editor/document/index.ts";
import { type EditorPage, expect, type Point, test } from "./support/editor-page.ts";

/** Of a box: width, height and depth in metres. */
function sizeOf({ projector }: DecalLayer): readonly number[] {
  return projector.kind === "planar" ? projector.size : [];
}

/** Once a view that was just opened has been drawn at its size. */
async function expectWhole(mark: Locator, view: Locator): Promise<void> {
  await expect(async () => {
    const [inner, outer] = [await mark.boundingBox(), await view.boundingBox()];
    if (!inner || !outer) throw new Error("The view shows no such handle.");
    expect(inner.x).toBeGreaterThanOrEqual(outer.x);
    expect(inner.y).toBeGreaterThanOrEqual(outer.y);
    expect(inner.x + inner.width).toBeLessThanOrEqual(outer.x + outer.width);
    expect(inner.y + inner.height).toBeLessThanOrEqual(outer.y + outer.height);
  }).toPass({ timeout: 10_000 });
}

/** Opens the page on its mug, whose decal is seen from the side, and selects that. */
async function selected(editor: EditorPage): Promise<string> {
  const id = await editor.openOnLowest();
  await editor.idle();
  return id;
}

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("a finger in the middle of a decal moves it and leaves its size and depth alone, however small it is shown", async ({
    editor,
    page,
  }) => {
    const id = await selected(editor);
    const devtools = await page.context().newCDPSession(page);
    const touch = (type: "touchStart" | "touchMove" | "touchEnd", ...touchPoints: Point[]) =>
      devtools.send("Input.dispatchTouchEvent", { type, touchPoints });

    for (let zoom = 0; zoom < 4; zoom += 1) {
      for (const [x, y] of [
        [0, 0],
        [-14, 0],
        [0, 14],
        [-10, 10],
      ] as const) {
        await editor.idle();
        const before = await editor.decal(id);
        const middle = await editor.pointOf(id);
        const from = { x: middle.x + x, y: middle.y + y };
        await touch("touchStart", from);
        for (let step = 1; step <= 5; step += 1)
          await touch("touchMove", { x: from.x + 5 * step, y: from.y - 2 * step });
        await touch("touchEnd");
        await editor.idle();
        const after = await editor.decal(id);
        const claim = `${zoom} times zoomed out, pressed ${x}, ${y} from the middle`;
        expect(sizeOf(after), claim).toEqual(sizeOf(before));
        expect(after.projector, claim).not.toEqual(before.projector);
        await page.keyboard.press("Control+z");
      }
      await page.mouse.move(195, 330);
      await page.mouse.wheel(0, 240);
    }
  });
});

test.describe("on a phone, too,", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("the label of a drag stands above the finger and within the view, wherever that is", async ({
    editor,
    page,
  }) => {
    await selected(editor);
    const devtools = await page.context().newCDPSession(page);
    const touch = (type: "touchStart" | "touchMove" | "touchEnd", ...touchPoints: Point[]) =>
      devtools.send("Input.dispatchTouchEvent", { type, touchPoints });
    const view = editor.view;
    const box = await view.boundingBox();
    if (!box) throw new Error("The page shows no model.");
    const label = view.locator(".tcv-readout");
    await touch("touchStart", await editor.handle("se"));
    for (const x of [box.x + 6, box.x + box.width / 2, box.x + box.width - 6]) {
      const finger = { x, y: box.y + box.height - 30 };
      await touch("touchMove", finger);
      await expect(label).toBeVisible();
      await editor.idle();
      await expectWhole(label, view);
      const text = await label.boundingBox();
      expect((text?.y ?? 0) + (text?.height ?? 0)).toBeLessThan(finger.y - 22);
    }
    await touch("touchEnd");
    await expect(label).toBeHidden();
  });

  test("the handle that turns a stamp stands in the texture's view whole", async ({ editor, page }) => {
    await selected(editor);
    await page.locator("#sheet-properties").tap();
    await page.locator("tc-layer-properties input[value=uv]").check({ force: true });
    await page.locator("#sheet-texture").tap();
    await editor.idle();
    const knob = page.locator(".tcv-texture [data-handle=rotate] .tcv-mark");
    await expect(knob).toBeVisible();
    await expectWhole(knob, page.locator(".tcv-texture"));
  });
});

test.describe("in a low window", () => {
  test.use({ viewport: { width: 720, height: 450 } });

  test("the handle that turns stands in the view whole, and turns", async ({ editor }) => {
    const id = await selected(editor);
    const view = editor.view;
    await expectWhole(view.locator("[data-handle=rotate] .tcv-mark"), view);
    const before = await editor.decal(id);
    const from = await editor.handle("rotate");
    await editor.drag(from, { x: from.x - 20, y: from.y + 25 }, 6);
    const after = await editor.decal(id);
    expect(sizeOf(after)).toEqual(sizeOf(before));
    expect(after.projector).not.toEqual(before.projector);
  });

  test("a mouse in the middle of a decal moves it and leaves its size and depth alone", async ({ editor, page }) => {
    const id = await selected(editor);
    const before = await editor.decal(id);
    const middle = await editor.pointOf(id);
    for (const [x, y] of [
      [0, 0],
      [-8, 4],
      [8, -4],
    ] as const) {
      await editor.drag({ x: middle.x + x, y: middle.y + y }, { x: middle.x + x + 12, y: middle.y + y }, 4);
      const after = await editor.decal(id);
      expect(sizeOf(after)).toEqual(sizeOf(before));
      expect(after.projector).not.toEqual(before.projector);
      await page.keyboard.press("Control+z");
      await editor.idle();
    }
  });
});
