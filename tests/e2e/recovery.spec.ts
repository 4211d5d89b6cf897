/** What breaks below the page while it is used: the engine's worker, and the graphics context. */
import type { UvProjector } from "../../web/editor/document/index.ts";
import { type EditorPage, expect, type Point, test } from "./support/editor-page.ts";
import { lookAlike } from "./support/look-alike.ts";
import { rendered } from "./support/rendered.ts";
import { file, squareGlb } from "./support/test-files.ts";

/** The selected decal's middle, and a place beside it on the model. */
async function dragOf(editor: EditorPage): Promise<{ id: string; from: Point; to: Point }> {
  const [layer] = (await editor.design()).layers;
  const id = layer?.id ?? "";
  await editor.select(id);
  const from = await editor.pointOf(id);
  return { id, from, to: { x: from.x + 60, y: from.y + 25 } };
}

/** What a page paints that never had a fault: the same design, opened from a file. */
async function hashOfSameDesign(editor: EditorPage): Promise<string> {
  const design = await editor.design();
  await editor.page.locator("#undo").click();
  await editor.idle();
  await editor.openDesign([file("same.design.json", JSON.stringify(design), "application/json")]);
  return editor.settledHash();
}

test("the engine's worker is ended in mid-drag: it is replaced, and the drag ends with the same texels", async ({
  editor,
  page,
}) => {
  await editor.open();
  const { id, from, to } = await dragOf(editor);
  const before = await editor.decal(id);
  // The thread is gone, and nobody is told: whether the call is still answered is a matter of luck.
  const end = (): void =>
    void page
      .workers()
      .at(-1)
      ?.evaluate(() => close())
      .catch(() => undefined);
  const next = page.waitForEvent("worker");
  let step = 0;
  await editor.drag(from, to, 8, async () => {
    step += 1;
    if (step === 4) end();
  });
  await next;
  const after = await editor.settledHash();
  expect((await editor.decal(id)).projector).not.toEqual(before.projector);
  await expect(page.locator("tc-notice-stack .error")).toHaveCount(0);
  expect(await hashOfSameDesign(editor)).toBe(after);

  // Once more while nothing is done: it is back before it is needed, and says so.
  end();
  await expect(editor.notices).toContainText("The painting engine was restarted");
  expect(await editor.settledHash()).toBe(after);
});

test("the engine's worker is ended in mid-stroke: the stroke is whole, and the command line paints the same bytes", async ({
  editor,
  page,
}) => {
  await editor.open();
  await page.keyboard.press("b");
  const middle = await editor.middleOfStage();
  const [from, to] = [
    { x: middle.x - 60, y: middle.y + 40 },
    { x: middle.x + 60, y: middle.y + 60 },
  ];
  const next = page.waitForEvent("worker");
  let step = 0;
  await editor.drag(from, to, 10, async () => {
    step += 1;
    // The thread is gone, and nobody is told.
    if (step === 5)
      void page
        .workers()
        .at(-1)
        ?.evaluate(() => close())
        .catch(() => undefined);
  });
  await next;
  const after = await editor.settledHash();
  const painted = (await editor.design()).layers.find((layer) => layer.type === "paint");
  const [stroke, ...more] = painted?.type === "paint" ? painted.strokes : [];
  expect(more).toHaveLength(0);
  const places = stroke?.dabs.flatMap((dab) => (dab.kind === "planar" ? [dab.position] : [])) ?? [];
  const ends = await Promise.all(
    [places.at(0), places.at(-1)].map((place) =>
      page.evaluate((at) => window.texelcast.project(...(at ?? [0, 0, 0])), place),
    ),
  );
  expect(Math.abs((ends[0]?.x ?? 0) - from.x), "where the stroke begins").toBeLessThan(8);
  expect(Math.abs((ends[1]?.x ?? 0) - to.x), "where it ends").toBeLessThan(8);
  await expect(page.locator("tc-notice-stack .error")).toHaveCount(0);

  const picture = await editor.exported("Texture as PNG");
  const project = await editor.savedProject();
  expect(rendered(project).equals(picture.bytes)).toBe(true);
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).not.toBe(after);
  await page.keyboard.press("Control+Shift+z");
  expect(await editor.settledHash()).toBe(after);
});

test("the graphics context is lost in mid-drag: the design goes on, and the picture is whole again", async ({
  editor,
  page,
}) => {
  await editor.open();
  const { id, from, to } = await dragOf(editor);
  const before = await editor.decal(id);
  const look = (): Promise<Buffer> => editor.stage.screenshot();
  await page.mouse.move(5, 400);
  // What comes in by itself, the light and the finest texels, has come.
  let seen = await look();
  await expect
    .poll(async () => {
      const before = seen;
      seen = await look();
      return lookAlike(seen, before);
    })
    .toBe(true);
  const lose = await page.evaluateHandle(() => {
    const canvas = document.querySelector<HTMLCanvasElement>("tc-workbench .tcv-canvas");
    return canvas?.getContext("webgl2")?.getExtension("WEBGL_lose_context") ?? null;
  });
  let step = 0;
  await editor.drag(from, to, 8, async () => {
    step += 1;
    if (step === 3) await lose.evaluate((extension) => extension?.loseContext());
  });
  expect((await editor.decal(id)).projector).not.toEqual(before.projector);
  const after = await editor.settledHash();
  await lose.evaluate((extension) => extension?.restoreContext());
  await editor.idle();
  expect(await editor.hash()).toBe(after);
  await expect(editor.notices).toHaveCount(0);

  await page.locator("#undo").click();
  await editor.idle();
  await page.mouse.move(5, 400);
  await expect.poll(async () => lookAlike(await look(), seen)).toBe(true);
});

/** A view's graphics, to be taken away and given back. */
function graphicsOf({ page }: EditorPage, view = ".tcv-root:not(.tcv-texture)") {
  return page.evaluateHandle((root) => {
    const canvas = document.querySelector<HTMLCanvasElement>(`tc-workbench ${root} .tcv-canvas`);
    return canvas?.getContext("webgl2")?.getExtension("WEBGL_lose_context") ?? null;
  }, view);
}

test("graphics that stay away are told in plain words, until they come back after all", async ({ editor }) => {
  await editor.open();
  const graphics = await graphicsOf(editor);
  await graphics.evaluate((extension) => extension?.loseContext());
  await expect(editor.notices).toContainText("The 3D view has stopped");
  await expect(editor.notices).toContainText("Nothing of your work is lost");
  await graphics.evaluate((extension) => extension?.restoreContext());
  await expect(editor.notices).toHaveCount(0);
});

test("graphics that only the texture's view has lost are told, too", async ({ editor }) => {
  await editor.open();
  const flat = await graphicsOf(editor, ".tcv-texture");
  await flat.evaluate((extension) => extension?.loseContext());
  await expect(editor.notices).toContainText("The texture’s view has stopped");
  await expect(editor.notices.getByRole("button", { name: "Load again" })).toBeVisible();
  await flat.evaluate((extension) => extension?.restoreContext());
  await expect(editor.notices).toHaveCount(0);
});

test("a page whose graphics stay away is loaded again by a button, with all of its work", async ({ editor, page }) => {
  await editor.open();
  const { id, from, to } = await dragOf(editor);
  await editor.drag(from, to, 4);
  const [moved, texels] = [await editor.decal(id), await editor.settledHash()];
  await (await graphicsOf(editor)).evaluate((extension) => extension?.loseContext());
  const again = editor.notices.getByRole("button", { name: "Load again" });
  await expect(again).toBeVisible();
  await Promise.all([page.waitForEvent("load"), again.click()]);
  await page.waitForFunction(() => window.texelcast !== undefined);
  await page.evaluate(() => window.texelcast.ready);
  expect((await editor.decal(id)).projector).toEqual(moved.projector);
  expect(await editor.settledHash()).toBe(texels);
});

test("both views lose their graphics in the midst of a stamp's drag on the flat texture and have them back in that of an export: screen and file are whole", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const id = await editor.addDemoDecal("badge");
  await page.getByRole("radio", { name: "Flat" }).check({ force: true });
  await editor.idle();
  const [flat] = await editor.places(page.locator(".tcv-texture"));
  const stampOf = async (): Promise<UvProjector> => (await editor.decal(id)).projector as UvProjector;
  const before = await stampOf();
  const side = Math.min(flat.width, flat.height) - 2 * 16;
  const from = {
    x: flat.x + flat.width / 2 + (before.center[0] - 0.5) * side,
    y: flat.y + flat.height / 2 + (before.center[1] - 0.5) * side,
  };
  const graphics = [await graphicsOf(editor), await graphicsOf(editor, ".tcv-texture")];
  let step = 0;
  await editor.drag(from, { x: from.x + 50, y: from.y + 35 }, 8, async () => {
    step += 1;
    if (step === 3) for (const each of graphics) await each.evaluate((extension) => extension?.loseContext());
  });
  expect((await stampOf()).center[0]).toBeGreaterThan(before.center[0]);
  const [file] = await Promise.all([
    editor.exported("Texture as PNG"),
    ...graphics.map((each) => each.evaluate((extension) => extension?.restoreContext())),
  ]);
  await editor.idle();
  await expect(editor.notices).toHaveCount(0);

  const views = page.locator("tc-workbench .views");
  const look = async (): Promise<Buffer> => {
    await editor.page.evaluate(() => window.texelcast.select(null));
    await page.mouse.move(5, 400);
    await editor.idle();
    return views.screenshot();
  };
  const seen = await look();
  await page.evaluate(() => window.texelcast.kept());
  await editor.reload();
  // What says that it is back.
  await editor.notices.getByRole("button", { name: "Dismiss" }).click();
  await expect.poll(async () => lookAlike(await look(), seen)).toBe(true);
  expect((await editor.exported("Texture as PNG")).bytes.equals(file.bytes)).toBe(true);
});
