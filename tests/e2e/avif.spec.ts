import { createEngineHost } from "../../web/engine/engine-host.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { type AvifPart, avifFile, avifModel, makeAvif, mirrorBox, partsOf, turnBox } from "../support/avif-file.ts";
import { softPicture } from "../support/ktx2-file.ts";
import { expect, test } from "./support/editor-page.ts";
import { rendered } from "./support/rendered.ts";
import { file, squareGlb } from "./support/test-files.ts";

test("an AVIF picture that is dropped is painted, and the command line paints the same", async ({ editor, page }) => {
  const decoders: string[] = [];
  page.on("request", (request) => {
    if (/avif/.test(request.url())) decoders.push(request.url());
  });
  await editor.open();
  await editor.openModel([squareGlb()]);
  await editor.removeAllDecals();
  expect(decoders, "nobody loads the decoder before a picture needs it").toEqual([]);
  const bare = await editor.settledHash();
  const photo = file("photo.avif", await avifFile(softPicture(96, 64), 80), "image/avif");
  await editor.drop([photo], await editor.middleOfStage());
  await expect(editor.row("photo")).toHaveCount(1);
  const painted = await editor.settledHash();
  expect(painted).not.toBe(bare);
  expect(decoders.length).toBeGreaterThan(0);
  const { assets } = await editor.design();
  expect(Object.values(assets).map(({ type }) => type)).toEqual(["image/avif"]);

  const broken = file("broken.avif", photo.buffer.subarray(0, 400), "image/avif");
  await editor.drop([broken], await editor.middleOfStage());
  await expect(editor.notices).toContainText("broken.avif");
  await expect(editor.notices).toHaveAttribute("data-code", "bad-picture");
  expect(await editor.settledHash(), "and nothing is lost").toBe(painted);

  const project = await editor.savedProject();
  const picture = await editor.exported("Texture as PNG");
  expect(rendered(project).equals(picture.bytes)).toBe(true);
});

test("a model whose textures are AVIF alone is painted on the texels that Node reads", async ({ editor, page }) => {
  const bytes = avifModel(await avifFile(softPicture(256, 128), 70));
  await editor.open();
  await editor.openModel([{ name: "a.glb", mimeType: "model/gltf-binary", buffer: Buffer.from(bytes) }]);
  const engine = createEngineHost();
  await engine.loadModel({ name: "a.glb", bytes });
  await engine.openTarget({ material: 0 });
  expect(await page.evaluate(() => window.texelcast.engine.hash(0))).toBe(await engine.hash(0));
  engine.dispose();
});

test("an AVIF picture is turned and mirrored as the browser itself does it", async ({ editor, page }) => {
  const rgba = Uint8Array.from({ length: 12 * 8 * 4 }, (_, i) => [(i >> 2) * 2, 0, 0, 255][i % 4] ?? 0);
  const part = partsOf(await avifFile({ width: 12, height: 8, rgba }))[0] as AvifPart;
  await editor.open();
  for (const boxes of [0, 1, 2, 3].flatMap((turns) => [
    [turnBox(turns)],
    [turnBox(turns), mirrorBox(0)],
    [turnBox(turns), mirrorBox(1)],
  ])) {
    const avif = makeAvif({ parts: [{ ...part, properties: [...(part.properties ?? []), ...boxes] }] });
    const shown = await page.evaluate(
      async (bytes) => {
        const image = await createImageBitmap(new Blob([Uint8Array.from(bytes)], { type: "image/avif" }));
        const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
        context?.drawImage(image, 0, 0);
        const data = [...(context?.getImageData(0, 0, image.width, image.height).data ?? [])];
        return { width: image.width, reds: data.filter((_, i) => i % 4 === 0) };
      },
      [...avif],
    );
    const read = await decodePicture(avif, "turned.avif");
    expect({ width: read.width, reds: [...read.rgba].filter((_, i) => i % 4 === 0) }).toEqual(shown);
  }
});
