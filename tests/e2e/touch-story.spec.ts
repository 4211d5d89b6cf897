/** The whole way of a skin on a phone, by fingers alone. */
import { readFileSync } from "node:fs";
import { type EditorPage, expect, type Point, test } from "./support/editor-page.ts";
import { readPng } from "./support/read-png.ts";

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

type Fingers = (type: "touchStart" | "touchMove" | "touchEnd", ...points: Point[]) => Promise<unknown>;

async function fingersOn({ page }: EditorPage): Promise<Fingers> {
  const devtools = await page.context().newCDPSession(page);
  return (type, ...points) =>
    devtools.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(({ x, y }, id) => ({ x, y, id })) });
}

test("on a phone a template is painted, written on, given a logo, undone by three fingers and exported", async ({
  editor,
  page,
}) => {
  await editor.open();
  const fingers = await fingersOn(editor);
  await page.locator("tc-top-bar .projects button").first().tap();
  await page.getByRole("menuitem", { name: "New project" }).tap();
  await page.locator("tc-template-dialog [data-template=block-wide]").tap();
  await editor.idle();
  const blank = await editor.settledHash();

  // One finger paints on the chest.
  await page.locator("#tool-brush").tap();
  const chest = await page.evaluate(() => window.texelcast.project(0, 1.0, 0.11));
  if (!chest) throw new Error("The figure's chest is not in view.");
  await fingers("touchStart", chest);
  for (let step = 1; step <= 4; step += 1) await fingers("touchMove", { x: chest.x - step * 4, y: chest.y + step * 3 });
  await fingers("touchEnd");
  const painted = await editor.settledHash();
  expect(painted).not.toBe(blank);

  // A tap puts words there, and the sheet opens on them.
  const text = page.locator("#tool-text");
  await text.scrollIntoViewIfNeeded();
  await text.tap();
  await expect(page.locator("tc-stage tc-tool-options")).toHaveText(/Press where the words should go/);
  await page.touchscreen.tap(chest.x, chest.y);
  const words = page.locator("tc-text-fields textarea");
  await expect(words).toBeFocused();
  await words.fill("Ada");
  await words.blur();
  const written = await editor.settledHash();
  expect(written).not.toBe(painted);

  await page.locator("#sheet-layers").tap();
  await page.locator("tc-decal-palette [data-decal=badge]").tap();
  await expect.poll(async () => (await editor.design()).layers.length).toBe(3);
  expect(await editor.settledHash()).not.toBe(written);

  // Three fingers tap: the logo is gone again. Both at once: on a busy machine what waits for their press is no tap any more.
  const taps = [0, 1, 2].map((finger) => ({ x: chest.x - 60 + finger * 60, y: chest.y }));
  await Promise.all([fingers("touchStart", ...taps), fingers("touchEnd")]);
  await expect.poll(async () => (await editor.design()).layers.length).toBe(2);
  expect(await editor.settledHash()).toBe(written);

  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page
      .locator("tc-top-bar tc-menu[alignEnd] button")
      .first()
      .tap()
      .then(() => page.getByRole("menuitem", { name: "Texture as PNG" }).tap()),
  ]);
  const picture = readPng(readFileSync(await download.path()));
  const texels = await editor.texels({ x: 0, y: 0, width: 64, height: 64 });
  expect(picture).toMatchObject({ width: 64, height: 64 });
  expect(picture.rgba.equals(texels)).toBe(true);
});

test("a pinch or a tap of several fingers that begins beside a decal leaves what is chosen, and moves no decal", async ({
  editor,
  page,
}) => {
  const id = await editor.openOnLowest();
  const fingers = await fingersOn(editor);
  const before = await editor.decal(id);
  const [view] = await editor.places(editor.view);
  const beside = { x: view.x + 20, y: view.y + 30 };
  const chosen = page.locator("tc-layer-list [aria-current=true] .name");

  // Two, of which the second comes down on the chosen decal: the camera's.
  const on = await editor.pointOf(id);
  await fingers("touchStart", beside);
  await fingers("touchStart", beside, on);
  for (let step = 1; step <= 6; step += 1) {
    await fingers("touchMove", { x: beside.x, y: beside.y - step }, { x: on.x + step * 10, y: on.y + step * 10 });
  }
  await fingers("touchEnd");
  await editor.idle();
  const after = await editor.pointOf(id);
  expect(Math.hypot(after.x - on.x, after.y - on.y), "the view came nearer").toBeGreaterThan(10);
  expect(await editor.decal(id)).toEqual(before);
  await expect(page.locator("#undo")).toBeDisabled();
  await expect(chosen).toHaveText("Texelcast mark");

  // Two that are lifted where they came down, and three that undo.
  await page.getByRole("button", { name: "Show the whole model" }).tap();
  await editor.idle();
  const taps = [0, 1, 2].map((finger) => ({ x: beside.x + finger * 40, y: beside.y }));
  await fingers("touchStart", ...taps.slice(0, 2));
  await fingers("touchEnd");
  await expect(chosen).toHaveText("Texelcast mark");
  await page.keyboard.press("5");
  expect((await editor.decal(id)).opacity).toBe(0.5);
  await Promise.all([fingers("touchStart", ...taps), fingers("touchEnd")]);
  await expect.poll(async () => (await editor.decal(id)).opacity).toBe(1);
  await expect(chosen).toHaveText("Texelcast mark");
});
