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

test("two fingers zoom the flat texture also where they come down on a stamp, which stays where it is", async ({
  editor,
  page,
}) => {
  const id = await editor.openOnLowest();
  const fingers = await fingersOn(editor);
  await page.locator("#sheet-properties").tap();
  await page.locator("tc-layer-properties input[value=uv]").check({ force: true });
  await page.locator("#sheet-texture").tap();
  await editor.idle();
  const flat = page.locator(".tcv-texture");
  const mark = (corner: string) => flat.locator(`[data-handle=${corner}] .tcv-mark`);
  const marks = async () => {
    const [one, other] = await editor.places(mark("nw"), mark("se"));
    const [x, y] = [(one.x + other.x + other.width) / 2, (one.y + other.y + other.height) / 2];
    return { x, y, apart: Math.hypot(one.x - other.x, one.y - other.y) };
  };
  const before = (await editor.decal(id)).projector;
  const step = await page.locator("#undo").getAttribute("aria-label");
  for (const first of ["on it", "beside it"]) {
    const { x, y, apart } = await marks();
    const on = { x, y };
    const beside = (at: number): Point => ({ x: x - 70 - at * 30, y: y + 10 });
    const pair = (at: number): Point[] => (first === "on it" ? [on, beside(at)] : [beside(at), on]);
    await fingers("touchStart", ...pair(0).slice(0, 1));
    await fingers("touchStart", ...pair(0));
    for (let at = 1; at <= 6; at += 1) await fingers("touchMove", ...pair(at));
    await fingers("touchEnd");
    await editor.idle();
    expect((await marks()).apart, first).toBeGreaterThan(1.2 * apart);
    expect((await editor.decal(id)).projector, first).toEqual(before);
    await page.getByRole("button", { name: "Fit the texture into its panel" }).tap();
  }
  expect(await page.locator("#undo").getAttribute("aria-label")).toBe(step);
});
