/** A shop's product whose materials have variants: the page chooses the look, and what the customer made goes along. */
import { expect, test } from "@playwright/test";
import { buildModel, plane } from "../support/model-builder.ts";
import { solidPng } from "../support/png-file.ts";
import { glbWithVariants } from "../support/variant-model.ts";
import { readPng } from "./support/read-png.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];

const RED = [200, 0, 0, 255] as const;
const BLUE = [0, 0, 200, 255] as const;

/** A square of a metre, red by its own look and blue in a variant of another material. */
function square(): Buffer {
  const model = buildModel({
    meshes: [{ ...plane(1, 0), material: 0 }],
    materials: [0, 1].map((index) => ({ pbrMetallicRoughness: { baseColorTexture: { index } } })),
    textures: [{ source: 0 }, { source: 1 }],
    images: [RED, BLUE].map((color) => ({ bytes: solidPng(64, 64, color), mimeType: "image/png" })),
  });
  return Buffer.from(glbWithVariants(model, ["red", "blue wave"], [[{ material: 1, variants: [1] }]]));
}

for (const mode of ["shop", "full"] as const) {
  test(`in ${mode} mode a product is shown in the look behind the #, and in another one with the same design`, async ({
    page,
  }) => {
    await page.route("**/looks.glb", (route) => route.fulfill({ body: square() }));
    await page.goto(`element.html?mode=${mode}&loading=lazy&size=64`);
    const outcome = await page.locator("texelcast-editor").evaluate(async (editor: Editor) => {
      const show = async (src: string) => {
        editor.src = src;
        await editor.updateComplete;
        return await editor.start().then(
          () => null,
          ({ code, message }: { code: string; message: string }) => ({ code, message }),
        );
      };
      const made = async () => {
        const { bytes } = await editor.exportTexture({ base: "model" });
        const { design } = await editor.exportDesign();
        return { texture: [...bytes], layers: JSON.stringify(design.layers), canUndo: editor.canUndo };
      };
      await show("demo/looks.glb#variant=blue%20wave");
      await editor.addDecal("demo/decals/smiley.png", { width: 0.4 });
      const blue = await made();
      await show("demo/looks.glb");
      const red = await made();
      const unknown = await show("demo/looks.glb#variant=green");
      await show("demo/looks.glb#variant=blue wave");
      return { blue, red, unknown, again: await made() };
    });
    const { blue, red, unknown, again } = outcome;
    const corner = ({ texture }: typeof blue) => [...readPng(Buffer.from(texture)).rgba.subarray(0, 4)];
    expect(corner(blue)).toEqual(BLUE);
    expect(corner(red)).toEqual(RED);
    expect(red.layers).toBe(blue.layers);
    expect(red.canUndo).toBe(true);
    expect(unknown).toEqual({
      code: "bad-model",
      message: "“looks.glb” has no variant “green”, but “red”, “blue wave”.",
    });
    expect(again).toEqual(blue);
  });

  test(`in ${mode} mode the customer's view of it and what is chosen stay in another look, and not for another product`, async ({
    page,
  }) => {
    await page.route("**/looks.glb", (route) => route.fulfill({ body: square() }));
    await page.goto(`element.html?mode=${mode}&loading=lazy&size=64`);
    const editor = page.locator("texelcast-editor");
    const show = (src: string) =>
      editor.evaluate(async (element: Editor, to) => {
        element.src = to;
        await element.updateComplete;
        await element.start();
      }, src);
    /** What the product covers of the view, as the customer sees it. */
    const outline = async () => {
      const bytes = await editor.evaluate(async (element: Editor) => [
        ...new Uint8Array(await (await element.snapshot("current", { width: 100, height: 100 })).arrayBuffer()),
      ]);
      const { rgba } = readPng(Buffer.from(bytes));
      return Array.from({ length: 100 * 100 }, (_, pixel) => (rgba[pixel * 4 + 3] ?? 0) > 127);
    };
    const differing = (a: readonly boolean[], b: readonly boolean[]) =>
      a.filter((inside, pixel) => inside !== b[pixel]).length;
    /** The camera goes on for a moment after its key. */
    const atRest = async () => {
      let before: readonly boolean[] = [];
      await expect
        .poll(async () => {
          const last = before;
          before = await outline();
          return differing(before, last);
        })
        .toBe(0);
      return before;
    };

    await show("demo/looks.glb#variant=red");
    const first = await outline();
    const id = await editor.evaluate((element: Editor) => element.addDecal("demo/decals/smiley.png", { width: 0.4 }));
    const view = editor.getByRole("application").first();
    await view.focus();
    await view.press("Escape");
    for (let i = 0; i < 4; i++) await view.press("ArrowRight");
    await editor.evaluate((element: Editor, layer) => element.select(layer), id);
    await expect.poll(async () => differing(await outline(), first)).toBeGreaterThan(400);
    const turned = await atRest();

    await show("demo/looks.glb#variant=blue wave");
    expect(differing(await outline(), turned)).toBeLessThan(30);
    expect(await editor.evaluate((element: Editor) => element.selected)).toBe(id);
    await editor.evaluate((element: Editor) => element.restart());
    expect(differing(await outline(), turned)).toBeLessThan(30);
    await show("demo/mug.glb");
    await show("demo/looks.glb");
    expect(differing(await outline(), first)).toBeLessThan(30);
  });
}
