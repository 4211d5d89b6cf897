/** `<texelcast-editor>` in a part of the page that is scaled, as page builders and opening dialogs do it. */
import { expect, type Locator, type Page, test } from "@playwright/test";
import type { PlanarProjector } from "../../web/editor/document/index.ts";
import { squareGlb } from "./support/test-files.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];
type Place = readonly [x: number, y: number];

/** Rules, and how large they make a pixel. */
const SCALES = {
  "as it is": ["", 1],
  "made smaller by transform": ["transform: scale(0.6)", 0.6],
  "made larger by zoom": ["zoom: 1.3", 1.3],
} as const;

/** The element in so many of its own pixels, whatever the page makes of them; the site's policy lets no style stand in the page. */
const layOut = (page: Page, scaled: string): Promise<void> =>
  page.evaluate(async (text) => {
    document.adoptedStyleSheets.push(await new CSSStyleSheet().replace(text));
  }, `body { ${scaled}; transform-origin: 0 0 } texelcast-editor { width: 900px; --texelcast-height: 520px }`);

test("a decal follows the pointer in a part of the page that is scaled, as it does elsewhere", async ({ page }) => {
  await page.route("**/square.glb", (route) => route.fulfill({ body: Buffer.from(squareGlb().buffer) }));
  /** Where a decal is after it was dragged by so many pixels of the element's own. */
  const dragged = async (scaled: string, scale: number): Promise<Place> => {
    await page.goto("element.html?mode=shop&src=demo/square.glb&size=64&camera-orbit=0deg 90deg auto");
    await layOut(page, scaled);
    const editor = page.locator("texelcast-editor");
    await editor.evaluate(async (element: Editor) => {
      await element.addDecal("demo/decals/smiley.png", { position: [0, 0, 0], width: 0.1 });
    });
    await expect(editor.locator(".tcv-alignment-line")).toBeAttached();
    const box = await editor.getByRole("application").boundingBox();
    if (!box) throw new Error("The view has no place on the page.");
    const middle = [box.x + box.width / 2, box.y + box.height / 2] as const;
    await page.mouse.move(...middle);
    await page.mouse.down();
    await page.mouse.move(middle[0] - 100 * scale, middle[1] - 70 * scale, { steps: 6 });
    await page.mouse.up();
    return await editor.evaluate(async (element: Editor) => {
      const [layer] = (await element.exportDesign()).design.layers as unknown as { projector: PlanarProjector }[];
      const [x = Number.NaN, y = Number.NaN] = layer?.projector.position ?? [];
      return [x, y] as const;
    });
  };
  const places: Record<string, readonly string[]> = {};
  for (const [where, [scaled, scale]] of Object.entries(SCALES)) {
    places[where] = (await dragged(scaled, scale)).map((metres) => metres.toFixed(2));
  }
  const elsewhere = places["as it is"];
  expect(Number(elsewhere?.[0])).toBeLessThan(-0.1);
  expect(places).toEqual(Object.fromEntries(Object.keys(SCALES).map((where) => [where, elsewhere])));
});

test("the flat texture, too, is zoomed about the pointer and its stamp follows it in a part of the page that is scaled", async ({
  page,
}) => {
  await page.setViewportSize({ width: 1600, height: 1000 });
  /** Where the stamp's first corner is in the view, its own pixels: after a wheel's step, and after a drag. */
  const worked = async (scaled: string, scale: number): Promise<readonly number[]> => {
    await page.goto("element.html?mode=full&src=demo/mug.glb&size=64");
    await layOut(page, scaled);
    const editor = page.locator("texelcast-editor");
    await editor.evaluate(async (element: Editor) => {
      const projector = { kind: "uv", center: [0.5, 0.5], size: [0.3, 0.3], angle: 0 } as const;
      element.select(await element.addDecal("demo/decals/smiley.png", { projector }));
    });
    const flat = editor.getByRole("application", { name: "Flat texture" });
    const outline = flat.locator("path.tcv-outline");
    await expect(outline).toHaveAttribute("d", /M/);
    const box = await flat.boundingBox();
    if (!box) throw new Error("The texture has no place on the page.");
    await page.mouse.move(box.x + box.width * 0.4, box.y + box.height * 0.4);
    await page.mouse.wheel(0, -100);
    const zoomed = await firstAtRest(outline);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.keyboard.down("Control");
    await page.mouse.move(box.x + box.width / 2 + 30 * scale, box.y + box.height / 2 - 20 * scale, { steps: 4 });
    await page.mouse.up();
    await page.keyboard.up("Control");
    return [...zoomed, ...(await firstAtRest(outline))];
  };
  const elsewhere = await worked(...SCALES["as it is"]);
  const [x = 0, y = 0, draggedX = 0, draggedY = 0] = elsewhere;
  expect([draggedX - x, draggedY - y].map(Math.round)).toEqual([30, -20]);
  for (const where of ["made smaller by transform", "made larger by zoom"] as const) {
    const [scaled, scale] = SCALES[where];
    const apart = (await worked(scaled, scale)).map((length, index) => Math.abs(length - (elsewhere[index] ?? 0)));
    expect(Math.max(...apart), where).toBeLessThan(1.5);
  }
});

/** The first point of what is drawn, once that no longer changes. */
async function firstAtRest(line: Locator): Promise<readonly number[]> {
  let drawn = "";
  await expect
    .poll(async () => {
      const before = drawn;
      drawn = (await line.getAttribute("d")) ?? "";
      return drawn === before;
    })
    .toBe(true);
  return (
    drawn
      .match(/[\d.]+/g)
      ?.slice(0, 2)
      .map(Number) ?? []
  );
}
