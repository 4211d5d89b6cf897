/** Keys that are held down for long: their steps end where a design's lengths do. */
import { parseDesign } from "../../web/editor/document/index.ts";
import { expect, test } from "./support/editor-page.ts";
import { file, ringPicture } from "./support/test-files.ts";

for (const [key, side] of [
  ["-", 2e-9],
  ["+", 5e8],
] as const) {
  test(`pictures are no larger or smaller than a design may have them, however long ${key} is held`, async ({
    editor,
    page,
  }) => {
    const decal = { type: "decal", asset: "ring" };
    const place = { position: [0, 0.05, 0.04], rotation: [0, 0, 0, 1] };
    const projectors = [
      { kind: "planar", ...place, size: [side, side, 0.03] },
      { kind: "cylindrical", ...place, radius: 0.04, height: side, arc: 90, depth: 0.01 },
      { kind: "uv", center: [0.5, 0.5], size: [side, side], angle: 20 },
    ];
    const design = {
      ...{ format: "texelcast-design", version: 1 },
      assets: { ring: { type: "image/png", uri: "pictures/ring.png" } },
      layers: projectors.map((projector, at) => ({ ...decal, id: `${at}`, name: projector.kind, projector })),
    };
    await editor.open();
    await editor.openDesign([file("at-the-limit.design.json", JSON.stringify(design)), ringPicture()]);
    for (const { id } of (await editor.design()).layers) {
      await editor.select(id);
      await page.evaluate((held) => {
        for (let step = 0; step < 100; step += 1) dispatchEvent(new KeyboardEvent("keydown", { key: held }));
      }, key);
    }
    await editor.idle();
    const { bytes } = await editor.saveDesign();
    const { layers } = parseDesign(bytes.toString(), "saved.design.json");
    expect(layers.map(({ id }) => id)).toEqual(["0", "1", "2"]);
    // They came near to it before.
    const [planar] = layers;
    const reached = planar?.type === "decal" && planar.projector.kind === "planar" ? planar.projector.size[0] : side;
    expect(Math.abs(Math.log(reached / side))).toBeGreaterThan(0.6);
  });
}
