/** What a hand does on the product before the scripts that take hold of it have come: none of it is lost. */
import { expect, type Page, test } from "@playwright/test";

test.use({ hasTouch: true, reducedMotion: "reduce" });

type Element = HTMLElementTagNameMap["texelcast-editor"];

interface Look {
  /** Share of the view's picture that the product covers. */
  readonly covered: number;
  /** Of the picture. */
  readonly png: string;
}

const look = (page: Page): Promise<Look> =>
  page.evaluate(async () => {
    const editor = document.querySelector("texelcast-editor") as Element;
    const picture = await editor.snapshot("current", { width: 64, height: 64 });
    const canvas = new OffscreenCanvas(64, 64);
    const context = canvas.getContext("2d");
    context?.drawImage(await createImageBitmap(picture), 0, 0);
    const rgba = context?.getImageData(0, 0, 64, 64).data ?? new Uint8ClampedArray();
    const shown = rgba.filter((_, index) => index % 4 === 3).filter((alpha) => alpha > 0).length;
    return { covered: shown / 64 / 64, png: btoa(String.fromCharCode(...rgba)) };
  });

const place = (page: Page): Promise<readonly number[]> =>
  page.evaluate(async () => {
    const { design } = await (document.querySelector("texelcast-editor") as Element).exportDesign();
    const [layer] = design.layers;
    return layer?.type === "decal" && "position" in layer.projector ? layer.projector.position : [];
  });

interface Point {
  readonly x: number;
  readonly y: number;
}

interface HeldShop {
  /** The picture and the smiley's place, before anybody did anything. */
  readonly before: { readonly look: Look; readonly place: readonly number[] };
  /** In the page, of the view's box: 0.5, 0.5 is its middle. */
  at(right: number, down: number): Point;
  /** Scripts that somebody waits for. */
  waiting(): number;
  /** From here on scripts come again. */
  letGo(): Promise<void>;
}

/** A mug with a smiley in front, shown; whatever script is asked for from now on is held back. */
async function openHeld(page: Page): Promise<HeldShop> {
  await page.goto("element.html?loading=lazy&size=256");
  await page.evaluate(async () => {
    const editor = document.querySelector("texelcast-editor") as Element;
    editor.design = {
      format: "texelcast-design",
      version: 1,
      assets: { smiley: { type: "image/png", uri: "demo/decals/smiley.png" } },
      layers: [
        {
          type: "decal",
          id: "smiley",
          asset: "smiley",
          projector: { kind: "planar", position: [0, 0.05, 0.04], rotation: [0, 0, 0, 1], size: [0.06, 0.06, 0.04] },
        },
      ],
    };
    await editor.start();
  });
  await expect(
    page
      .locator("texelcast-editor")
      .getByRole("button", { name: /smiley/ })
      .first(),
  ).toBeVisible();
  const before = { look: await look(page), place: await place(page) };
  const held: (() => Promise<void>)[] = [];
  let holds = true;
  await page.route("**/*.js", async (route) => {
    if (holds) held.push(() => route.continue());
    else await route.continue();
  });
  const box = await page.locator("texelcast-editor").getByRole("application").boundingBox();
  if (!box) throw new Error("The view is not shown.");
  return {
    before,
    at: (right, down) => ({ x: box.x + box.width * right, y: box.y + box.height * down }),
    waiting: () => held.length,
    letGo: async () => {
      holds = false;
      for (const goOn of held) await goOn();
    },
  };
}

test("a tap chooses, a wheel comes nearer and keys move, though the hands come only after them", async ({ page }) => {
  const shop = await openHeld(page);
  const smiley = page
    .locator("texelcast-editor")
    .getByRole("button", { name: /smiley/ })
    .first();
  const { before } = shop;
  const onSmiley = shop.at(0.27, 0.5);
  await page.mouse.click(onSmiley.x, onSmiley.y);
  for (let steps = 0; steps < 3; steps += 1) await page.mouse.wheel(0, -100);
  for (let presses = 0; presses < 3; presses += 1) await page.keyboard.press("ArrowUp");
  await expect.poll(shop.waiting).toBeGreaterThan(0);
  await expect(smiley).toHaveAttribute("aria-pressed", "false");
  expect(await look(page)).toEqual(before.look);

  await shop.letGo();
  await expect(smiley).toHaveAttribute("aria-pressed", "true");
  await expect.poll(async () => (await look(page)).covered).toBeGreaterThan(before.look.covered * 1.1);
  await expect.poll(async () => ((await place(page))[1] ?? 0) - (before.place[1] ?? 0)).toBeGreaterThan(0);
});

test("two fingers that lie on the product before the hands come take hold of it as they lie", async ({ page }) => {
  const shop = await openHeld(page);
  const { before } = shop;
  const devtools = await page.context().newCDPSession(page);
  const fingers = (type: "touchStart" | "touchMove" | "touchEnd", ...points: Point[]): Promise<unknown> =>
    devtools.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(({ x, y }, id) => ({ x, y, id })) });
  // Beside the smiley, which a finger would take along.
  const apart = (share: number): Point[] => [shop.at(0.5 - share, 0.75), shop.at(0.5 + share, 0.75)];
  const [left, right] = apart(0.05) as [Point, Point];
  await fingers("touchStart", left);
  await fingers("touchStart", left, right);
  await fingers("touchMove", ...apart(0.08));
  await expect.poll(shop.waiting).toBeGreaterThan(0);
  expect(await look(page)).toEqual(before.look);

  await shop.letGo();
  await expect.poll(async () => (await look(page)).covered).toBeGreaterThan(before.look.covered * 1.1);
  // They are still down, and go on.
  for (const share of [0.1, 0.12]) await fingers("touchMove", ...apart(share));
  await expect.poll(async () => (await look(page)).covered).toBeGreaterThan(before.look.covered * 1.25);
  await fingers("touchEnd");
});
