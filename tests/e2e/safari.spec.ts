/** What Safari does unlike all others, acted out: it cannot be driven here. */
import type { Locator, Page } from "@playwright/test";
import { type EditorPage, expect, type Point, test } from "./support/editor-page.ts";
import { squareGlb, twoSquaresGlb } from "./support/test-files.ts";

/** The height of a part of the mug's wall on the screen, pixels: the one that is seen in its middle at first. */
async function tallness(page: Page): Promise<number> {
  const at = async (height: number): Promise<Point> =>
    (await page.evaluate((y) => window.texelcast.project(0.017, y, 0.037), height)) ?? { x: 0, y: 0 };
  return (await at(0.04)).y - (await at(0.06)).y;
}

/** A pinch of two fingers on a trackpad, as Safari tells it. Returns whether the page itself would have been zoomed. */
const pinch = (page: Page, { x, y }: Point, ...scales: number[]): Promise<boolean> =>
  page.evaluate(
    ([clientX, clientY, steps]) => {
      // Slotted, a shadow tree's own host is what is there.
      const within = (outer: Element): Element | null => {
        const inner = outer.shadowRoot?.elementFromPoint(clientX, clientY);
        return !inner || inner === outer ? outer : within(inner);
      };
      const top = document.elementFromPoint(clientX, clientY);
      const target = top && within(top);
      const tell = (type: string, scale: number): boolean => {
        const event = new MouseEvent(type, { bubbles: true, cancelable: true, composed: true, clientX, clientY });
        return target?.dispatchEvent(Object.assign(event, { scale, rotation: 0 })) ?? true;
      };
      const heard = [tell("gesturestart", 1), ...steps.map((scale) => tell("gesturechange", scale))];
      return [...heard, tell("gestureend", steps.at(-1) ?? 1)].some((zooms) => zooms);
    },
    [x, y, scales] as const,
  );

test.beforeEach(async ({ page }) => {
  // The view goes there at once.
  await page.emulateMedia({ reducedMotion: "reduce" });
});

test("a pinch on a trackpad brings the model nearer by as much as the fingers part, whichever way the browser tells it", async ({
  editor,
  page,
}) => {
  await editor.open();
  const middle = await page.evaluate(() => window.texelcast.project(0, 0.05, 0));
  if (!middle) throw new Error("The mug is not in view.");
  const before = await tallness(page);
  await page.mouse.move(middle.x, middle.y);
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -100 * Math.log(1.5));
  await page.keyboard.up("Control");
  await expect.poll(() => tallness(page)).toBeGreaterThan(before * 1.4);
  expect(await tallness(page)).toBeLessThan(before * 1.6);
  await page.getByRole("button", { name: "Show the whole model" }).click();
  await expect.poll(async () => Math.abs((await tallness(page)) / before - 1)).toBeLessThan(0.01);

  expect(await pinch(page, middle, 1.1, 1.3, 1.5)).toBe(false);
  await expect.poll(() => tallness(page)).toBeGreaterThan(before * 1.4);
  expect(await tallness(page)).toBeLessThan(before * 1.6);
});

test("a pinch on a trackpad goes into the flat view", async ({ editor, page }) => {
  await editor.open();
  const box = await page.locator("tc-texture-panel .view").boundingBox();
  if (!box) throw new Error("There is no flat view.");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const texel = async (right: number): Promise<number> => {
    await page.mouse.move(x + right - 1, y);
    await page.mouse.move(x + right, y);
    return Number((await page.locator("tc-texture-panel #texel").textContent())?.split(",")[0]);
  };
  const [middle, right] = [await texel(0), await texel(40)];
  expect(await pinch(page, { x, y }, 1.4, 2)).toBe(false);
  await expect.poll(async () => Math.abs((right - middle) / ((await texel(40)) - middle) - 2)).toBeLessThan(0.1);
});

test.describe("on a screen that is touched", () => {
  test.use({ hasTouch: true });

  test("fingers, which make a trackpad's events too, pinch once", async ({ editor, page }) => {
    await editor.open();
    const middle = await page.evaluate(() => window.texelcast.project(0, 0.05, 0));
    if (!middle) throw new Error("The mug is not in view.");
    const before = await tallness(page);
    const devtools = await page.context().newCDPSession(page);
    const touchPoints = [{ x: middle.x, y: middle.y, id: 0 }];
    await devtools.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints });
    expect(await pinch(page, middle, 2), "the page is not zoomed").toBe(false);
    await devtools.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    expect(await tallness(page)).toBeCloseTo(before, 1);
    await pinch(page, middle, 2);
    await expect.poll(() => tallness(page)).toBeGreaterThan(before * 1.5);
  });
});

/** A press by the mouse, from which the browser keeps the keyboard. */
async function pressAsInSafari(editor: EditorPage, button: Locator): Promise<void> {
  const { page } = editor;
  const [box] = await editor.places(button);
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.evaluate(() => {
    let focused = document.activeElement;
    while (focused?.shadowRoot?.activeElement) focused = focused.shadowRoot.activeElement;
    (focused as HTMLElement | null)?.blur();
  });
  await page.mouse.up();
}

test("what is pressed takes the keyboard where the browser does not give it", async ({ editor, page }) => {
  await editor.openOnLowest();
  const frame = page.getByRole("button", { name: "Show the whole model" });
  await pressAsInSafari(editor, frame);
  await expect(frame).toBeFocused();
});

test("a decal that was dropped from the palette is taken hold of by the first press, which is told as a move", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([twoSquaresGlb()]);
  await page.evaluate(() => {
    let dropped = false;
    addEventListener("dragend", () => {
      dropped = true;
    });
    const withhold = (event: Event): void => {
      if (dropped && event.isTrusted) event.stopImmediatePropagation();
    };
    addEventListener("pointerdown", withhold, { capture: true });
  });
  const at = (x: number) => page.evaluate((place) => window.texelcast.project(place, 0, 0) as Point, x);
  const [badge] = await editor.places(page.locator("tc-decal-palette [data-decal=badge]"));
  const right = await at(0.55);
  await editor.drag({ x: badge.x + 20, y: badge.y + 20 }, right, 8);
  await expect.poll(async () => (await editor.design()).layers.length).toBe(1);
  await editor.drag(right, await at(-0.55), 10);
  await expect.poll(async () => (await editor.design()).layers[0]?.material).toBe(0);
});

test("a menu is closed by a second press on its button, wherever the keyboard would have gone", async ({
  editor,
  page,
}) => {
  await editor.open();
  const opener = page.locator("tc-top-bar .models button").first();
  await opener.click();
  const held = page.locator("tc-top-bar .models [role^=menuitem]:focus");
  await expect(held).toHaveCount(1);
  await opener.hover();
  await page.mouse.down();
  await expect(held, "until the press is over").toHaveCount(1);
  await page.mouse.up();
  await expect(page.getByRole("menu")).toHaveCount(0);
  await expect(opener).toBeFocused();
});

test("a dialog's input stays in the page until it is answered", async ({ editor, page }) => {
  await editor.open();
  const open = async () => {
    const asked = page.waitForEvent("filechooser");
    await page.locator("tc-top-bar .models button").first().click();
    await page.getByRole("menuitem", { name: "Open model…" }).click();
    return asked;
  };
  const inputs = page.locator("body > input[type=file]");
  await open();
  await expect(inputs).toHaveCount(1);
  const second = await open();
  await expect(inputs, "one that was never answered goes").toHaveCount(1);
  await second.setFiles([squareGlb()]);
  await editor.idle();
  await expect(inputs).toHaveCount(0);
  await expect(page.locator("tc-top-bar .models")).toContainText("square");
});

test.describe("on an iPhone", () => {
  test.use({ userAgent: "Mozilla/5.0 (iPhone; CPU iPhone OS 18_5 like Mac OS X) AppleWebKit/605.1.15 Mobile/15E148" });

  test("models are asked for among all files, pictures among pictures", async ({ editor, page }) => {
    await editor.open();
    const accepted = async (open: () => Promise<void>): Promise<string> => {
      const [chooser] = await Promise.all([page.waitForEvent("filechooser"), open()]);
      return chooser.element().evaluate((input) => (input as HTMLInputElement).accept);
    };
    const models = await accepted(async () => {
      await page.locator("tc-top-bar .models button").first().click();
      await page.getByRole("menuitem", { name: "Open model…" }).click();
    });
    expect(models).toBe("");
    const pictures = await accepted(async () => {
      await page.locator("tc-layer-list tc-menu.add button").first().click();
      await page.getByRole("menuitem", { name: /Picture/ }).click();
    });
    expect(pictures).toContain("image/png");
  });
});
