/** A pen beside the hand that holds it, and its other end. */
import type { Page } from "@playwright/test";
import type { PaintLayer } from "../../web/editor/document/index.ts";
import { type EditorPage, expect, type Point, test } from "./support/editor-page.ts";
import { squareGlb } from "./support/test-files.ts";

test.use({ hasTouch: true });

async function strokes(editor: EditorPage): Promise<PaintLayer["strokes"]> {
  const layers = (await editor.design()).layers.filter((layer) => layer.type === "paint");
  return layers.flatMap((layer) => layer.strokes);
}

async function openForPainting(editor: EditorPage): Promise<Point> {
  await editor.open();
  await editor.openModel([squareGlb()]);
  await editor.page.keyboard.press("b");
  return editor.middleOfStage();
}

/** A hand that lies on the screen, and the pen in it. */
async function handAndPen(page: Page) {
  const cdp = await page.context().newCDPSession(page);
  const hand = (type: "touchStart" | "touchMove" | "touchEnd", ...points: Point[]) =>
    cdp.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(({ x, y }) => ({ x, y, id: 7 })) });
  const pen = (type: "mousePressed" | "mouseMoved" | "mouseReleased", { x, y }: Point) =>
    cdp.send("Input.dispatchMouseEvent", {
      ...{ type, x, y, button: "left", clickCount: 1, pointerType: "pen", force: 0.5 },
      buttons: type === "mouseReleased" ? 0 : 1,
    });
  return { hand, pen };
}

test("a pen draws though its hand lay down before it, and stays there between two strokes", async ({
  editor,
  page,
}) => {
  const middle = await openForPainting(editor);
  const corner = () => page.evaluate(() => window.texelcast.project(0.5, 0.5, 0));
  const before = await corner();
  const { hand, pen } = await handAndPen(page);
  const places = { "on the model": { x: middle.x + 60, y: middle.y + 60 }, "beside it": { x: 40, y: middle.y } };
  for (const [name, place] of Object.entries(places)) {
    const count = (await strokes(editor)).length;
    await hand("touchStart", place);
    for (const down of [-20, 20]) {
      await pen("mousePressed", { x: middle.x - 40, y: middle.y + down });
      for (let step = 1; step <= 4; step += 1) {
        await pen("mouseMoved", { x: middle.x - 40 + step * 20, y: middle.y + down });
        await hand("touchMove", { x: place.x + step, y: place.y + step });
      }
      await pen("mouseReleased", { x: middle.x + 40, y: middle.y + down });
    }
    await hand("touchEnd");
    await editor.idle();
    const drawn = (await strokes(editor)).slice(count);
    expect(drawn, `the hand lies ${name}`).toHaveLength(2);
    for (const { dabs } of drawn) expect(dabs.length, `the hand lies ${name}`).toBeGreaterThan(8);
    expect(Math.max(...drawn.flatMap(({ dabs }) => dabs.map(({ flow }) => flow)))).toBeLessThan(0.6);
  }
  expect(await corner(), "the hand turns nothing meanwhile").toEqual(before);
});

test("a pen moves a decal though its hand lay down on it before, or beside it, and though it comes down after", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const id = await editor.addDemoDecal("badge");
  const { hand, pen } = await handAndPen(page);
  const position = async (): Promise<readonly number[]> => {
    const { projector } = await editor.decal(id);
    return projector.kind === "planar" ? projector.position : [];
  };
  const corner = () => page.evaluate(() => window.texelcast.project(0.5, 0.5, 0));
  const camera = await corner();
  const start = await position();
  const middle = await editor.pointOf(id);
  const wander = async (from: Point): Promise<void> => {
    for (let step = 1; step <= 4; step += 1) await hand("touchMove", { x: from.x + step * 6, y: from.y + step * 6 });
  };
  const slide = async (whileHeld = async (): Promise<void> => {}): Promise<void> => {
    await pen("mousePressed", middle);
    for (let step = 1; step <= 4; step += 1) await pen("mouseMoved", { x: middle.x + step * 15, y: middle.y });
    await whileHeld();
    await pen("mouseReleased", { x: middle.x + 60, y: middle.y });
    await editor.idle();
  };
  await slide();
  const wanted = await position();
  expect(wanted).not.toEqual(start);
  await page.keyboard.press("Control+z");

  const on = { x: middle.x + 20, y: middle.y + 20 };
  const beside = { x: 60, y: middle.y };
  for (const [name, place] of Object.entries({ on, beside })) {
    await hand("touchStart", place);
    if (name === "on") await wander(place);
    await slide(() => wander(place));
    await hand("touchEnd");
    expect(await position(), name).toEqual(wanted);
    await page.keyboard.press("Control+z");
    expect(await position(), `${name}, as one step`).toEqual(start);
  }
  await slide(async () => {
    await hand("touchStart", on);
    await wander(on);
  });
  await hand("touchEnd");
  expect(await position(), "after the pen").toEqual(wanted);
  expect(await corner(), "the hand turns nothing").toEqual(camera);
});

test("a pen's other end erases, and leaves the tool that was chosen", async ({ editor, page }) => {
  const { x, y } = await openForPainting(editor);
  const from = { x: x - 40, y };
  const to = { x: x + 40, y };
  const bare = await editor.settledHash();
  await editor.drag(from, to, 6);
  expect(await editor.settledHash()).not.toBe(bare);
  await otherEnd(page, from, to);
  await editor.idle();
  expect((await strokes(editor)).map(({ blend }) => blend)).toEqual(["normal", "erase"]);
  await expect(page.getByRole("radio", { name: "Brush" })).toBeChecked();
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(bare);

  await page.getByRole("radio", { name: "Move" }).click();
  const badge = await editor.addDemoDecal("badge");
  const { projector } = await editor.decal(badge);
  await otherEnd(page, from, to);
  await editor.idle();
  expect(await editor.decal(badge), "of a decal it hides what it goes over").toMatchObject({
    projector,
    mask: { layers: [{ type: "stroke", blend: "erase" }] },
  });
  await expect(page.getByRole("radio", { name: "Move" })).toBeChecked();
});

test("a pen that reports no pressure at all draws as a mouse does", async ({ editor, page }) => {
  const { x, y } = await openForPainting(editor);
  const bare = await editor.settledHash();
  const cdp = await page.context().newCDPSession(page);
  const pen = (type: "mousePressed" | "mouseMoved" | "mouseReleased", across: number, force: number) =>
    cdp.send("Input.dispatchMouseEvent", {
      ...{ type, x: x + across, y, button: "left", clickCount: 1, pointerType: "pen", force },
      buttons: type === "mouseReleased" ? 0 : 1,
    });
  const draw = async (...forces: number[]): Promise<void> => {
    await pen("mousePressed", -40, forces[0] ?? 0);
    for (const [step, force] of forces.entries()) await pen("mouseMoved", -30 + step * 10, force);
    await pen("mouseReleased", 40, 0);
    await editor.idle();
  };
  await draw(0, 0, 0, 0, 0, 0, 0);
  expect(await editor.settledHash()).not.toBe(bare);
  await draw(0, 0, 0.25, 0.25, 0.25);
  const [first, second] = await strokes(editor);
  expect(new Set(first?.dabs.map(({ flow }) => flow))).toEqual(new Set([1]));
  expect(second?.dabs.at(-1)?.flow, "pressure that comes is heeded").toBe(0.25);
});

/** Playwright and the protocol have no such button: the events are made in the page, for a pointer that only they know. */
function otherEnd(page: Page, from: Point, to: Point): Promise<void> {
  return page.evaluate(
    ({ from, to }) => {
      Element.prototype.setPointerCapture = () => {};
      let target = document.elementFromPoint(from.x, from.y);
      while (target?.shadowRoot) {
        const inner = target.shadowRoot.elementFromPoint(from.x, from.y);
        if (inner === null || inner === target) break;
        target = inner;
      }
      const tell = (type: string, share: number, button: number, buttons: number): void => {
        const [clientX, clientY] = [from.x + (to.x - from.x) * share, from.y + (to.y - from.y) * share];
        const made = { bubbles: true, cancelable: true, composed: true, pointerId: 77, pointerType: "pen" };
        target?.dispatchEvent(
          new PointerEvent(type, { ...made, isPrimary: true, clientX, clientY, button, buttons, pressure: 1 }),
        );
      };
      tell("pointerdown", 0, 5, 32);
      for (let step = 1; step <= 6; step += 1) tell("pointermove", step / 6, -1, 32);
      tell("pointerup", 1, 5, 0);
      tell("lostpointercapture", 1, 0, 0);
    },
    { from, to },
  );
}
