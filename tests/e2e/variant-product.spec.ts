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
}
