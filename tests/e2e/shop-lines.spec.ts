/** In the shop's mode, too, what is dragged comes into line with what is near. */
import { expect, test } from "@playwright/test";
import type { PlanarProjector } from "../../web/editor/document/index.ts";
import { squareGlb } from "./support/test-files.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];
type Point = readonly [x: number, y: number];

/** A place of print, aside of the square's middle, which is (0.2, 0.15) either way. */
const SHAPES = {
  box: { kind: "box", position: [0.2, 0.15, 0], rotation: [0, 0, 0, 1], size: [0.3, 0.3, 0.5] },
  polygon: {
    kind: "uv",
    polygon: [
      [0.55, 0.25],
      [0.85, 0.25],
      [0.85, 0.45],
      [0.55, 0.45],
    ],
  },
};
const zonesOf = (shape: object): object => ({
  texelcastZones: 1,
  zones: [{ id: "chest", name: "Chest", material: 0, shape }],
});

test.beforeEach(async ({ page }) => {
  const square = squareGlb();
  await page.route("**/square.glb", (route) => route.fulfill({ body: Buffer.from(square.buffer) }));
});

for (const [kind, shape] of Object.entries(SHAPES)) {
  test(`a customer's decal comes into the product's middle, that of a print zone that is a ${kind}, and under another decal, unless Ctrl is held`, async ({
    page,
  }) => {
    await page.goto("element.html?mode=shop&src=demo/square.glb&size=64&camera-orbit=0deg 90deg auto");
    const editor = page.locator("texelcast-editor");
    const view = editor.getByRole("application");
    const id = await editor.evaluate(async (element: Editor, zones) => {
      element.zones = zones;
      return await element.addDecal("demo/decals/smiley.png", { position: [0, 0, 0], width: 0.1 });
    }, zonesOf(shape));
    const line = editor.locator(".tcv-alignment-line");
    await expect(line).toBeAttached();
    const box = await view.boundingBox();
    if (!box) throw new Error("The view has no place on the page.");
    const middle: Point = [box.x + box.width / 2, box.y + box.height / 2];
    const placeOf = (layer: string): Promise<Point> =>
      editor.evaluate(async (element: Editor, wanted) => {
        const { design } = await element.exportDesign();
        const found = design.layers.find((each) => each.id === wanted) as { projector: PlanarProjector } | undefined;
        const [x = Number.NaN, y = Number.NaN] = found?.projector.position ?? [];
        return [x, y] as const;
      }, layer);
    const drawn = async (): Promise<string> => (await line.getAttribute("d")) ?? "";
    /** From where it is by so many pixels; gives the lines that are shown before the button is let go. */
    const drag = async ([x, y]: Point, [right, down]: Point): Promise<number> => {
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + right, y + down, { steps: 6 });
      const shown = await drawn();
      await page.mouse.up();
      await expect.poll(drawn).toBe("");
      return shown.split("M").length - 1;
    };

    // The view looks straight at it, so that pixels are lengths.
    expect(await drag(middle, [-100, -70])).toBe(0);
    const [left, up] = await placeOf(id);
    const metres = -left / 100;
    expect(up / metres).toBeCloseTo(70, 0);
    const pixelsAt = ([x, y]: Point): Point => [middle[0] + x / metres, middle[1] - y / metres];

    expect(await drag(pixelsAt([left, up]), [103, 66])).toBe(2);
    expect((await placeOf(id)).map((metre) => Math.abs(metre) < 1e-6)).toEqual([true, true]);

    expect(await drag(middle, [0.2 / metres + 4, -0.15 / metres - 3])).toBe(2);
    const [x, y] = await placeOf(id);
    expect(x).toBeCloseTo(0.2, 6);
    expect(y).toBeCloseTo(0.15, 6);

    const other = await editor.evaluate((element: Editor) =>
      element.addDecal("demo/decals/smiley.png", { position: [-0.3, 0.3, 0], width: 0.1 }),
    );
    await page.keyboard.down("Control");
    expect(await drag(pixelsAt([x, y]), [-0.5 / metres + 4, 0.5 / metres])).toBe(0);
    await page.keyboard.up("Control");
    const aside = await placeOf(id);
    expect(Math.abs(aside[0] - (await placeOf(other))[0])).toBeGreaterThan(2 * metres);
    expect(await drag(pixelsAt(aside), [-1, 10])).toBe(1);
    expect((await placeOf(id))[0]).toBeCloseTo((await placeOf(other))[0], 6);
  });
}
