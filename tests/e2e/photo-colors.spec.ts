import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { curves, iccChunk, PRIMARIES, rgbProfile, rowPng, SRGB_FORMULA } from "../support/icc-profile.ts";
import { makePng } from "../support/png-file.ts";
import { expect, test } from "./support/editor-page.ts";
import { rendered } from "./support/rendered.ts";
import { file, squareGlb } from "./support/test-files.ts";

const DISPLAY_P3 = iccChunk(rgbProfile(PRIMARIES.displayP3, SRGB_FORMULA));

/** A grid over all colours, and all greys. */
const COLORS = [
  ...Array.from({ length: 9 ** 3 }, (_, i) =>
    [i % 9, Math.floor(i / 9) % 9, Math.floor(i / 81)].map((step) => Math.min(step * 32, 255)),
  ),
  ...Array.from({ length: 256 }, (_, i) => [i, i, i]),
];

test("a picture with a colour profile has the colours that the browser itself shows", async ({ editor, page }) => {
  await editor.open();
  const photos = [
    DISPLAY_P3,
    iccChunk(rgbProfile(PRIMARIES.adobeRgb, curves.gamma(2.19921875))),
    iccChunk(rgbProfile(PRIMARIES.srgb, curves.gamma(1.8))),
    ["cICP", Uint8Array.of(12, 13, 0, 1)],
  ] as const;
  for (const photo of photos) {
    const png = rowPng(COLORS, [photo]);
    const shown = await page.evaluate(
      async (bytes) => {
        const image = await createImageBitmap(new Blob([Uint8Array.from(bytes)], { type: "image/png" }));
        const context = new OffscreenCanvas(image.width, 1).getContext("2d");
        context?.drawImage(image, 0, 0);
        return [...(context?.getImageData(0, 0, image.width, 1).data ?? [])];
      },
      [...png],
    );
    const { rgba } = await decodePicture(png, "photo.png", { asSeen: true });
    // The browser's own curves are good to a step.
    const differences = shown.map((value, i) => Math.abs(value - (rgba[i] as number)));
    expect(Math.max(...differences)).toBeLessThanOrEqual(1);
  }
});

test("a photo in Display P3 that is dropped is painted in its colours, and the command line paints the same bytes", async ({
  editor,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  await editor.removeAllDecals();
  // sRGB's red.
  const flat = {
    width: 32,
    height: 32,
    rows: Array.from({ length: 32 }, () => new Array(32).fill([234, 51, 35]).flat()),
  };
  const red = makePng({ ...flat, bitDepth: 8, colorType: 2, extra: [DISPLAY_P3] });
  await editor.drop([file("photo.png", red, "image/png")], await editor.middleOfStage());
  await expect(editor.row("photo")).toHaveCount(1);
  const project = await editor.savedProject();
  const picture = await editor.exported("Texture as PNG");
  expect(rendered(project).equals(picture.bytes)).toBe(true);
  const { rgba } = await decodePicture(picture.bytes, "painted.png");
  const painted = new Set(
    Array.from({ length: rgba.length / 4 }, (_, i) => [...rgba.subarray(i * 4, i * 4 + 3)].join()),
  );
  expect(painted).toContain("255,0,0");
  expect(painted).not.toContain("234,51,35");
});
