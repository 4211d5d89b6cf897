/** Landmarks and headings: the page's own, and those of a page that an editor is embedded in, which has its own already. */
import { expect, test } from "./support/editor-page.ts";
import { outlineFaults } from "./support/page-faults.ts";

for (const [device, width, height] of [
  ["a desktop", 1280, 800],
  ["a phone", 390, 844],
  ["a phone held sideways", 844, 390],
] as const) {
  test(`on ${device} everything on the page is in a landmark, and the headings go down step by step`, async ({
    editor,
    page,
  }) => {
    await page.setViewportSize({ width, height });
    await editor.open({ hint: true });
    expect(await outlineFaults(page)).toEqual([]);
  });

  for (const mode of ["full", "shop"]) {
    test(`on ${device} an editor in ${mode} mode adds no banner and no main part to its page's own`, async ({
      page,
    }) => {
      await page.setViewportSize({ width, height });
      await page.goto(`element.html?mode=${mode}&loading=eager&size=512`);
      await page.evaluate(() => document.querySelector("texelcast-editor")?.start());
      expect(await outlineFaults(page)).toEqual([]);
    });
  }
}
