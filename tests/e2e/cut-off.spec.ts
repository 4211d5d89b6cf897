/** Words and numbers are read whole where the page is narrowest: on a phone on its side, and on the smallest one. */
import type { Locator } from "@playwright/test";
import { expect, test } from "./support/editor-page.ts";

/** Pixels of each that are beyond its box. */
const cutOff = (boxes: Locator): Promise<number[]> =>
  boxes.evaluateAll((found) => found.map((box) => Math.max(0, box.scrollWidth - box.clientWidth)));

for (const [name, width, height] of [
  ["a phone on its side", 740, 360],
  ["a small phone on its side", 568, 320],
  ["the smallest phone", 320, 568],
] as const) {
  test.describe(`on ${name}`, () => {
    test.use({ viewport: { width, height }, hasTouch: true, isMobile: true });

    test("what the text tool asks for is read whole", async ({ editor, page }) => {
      await editor.open();
      for (const language of ["en", "de"]) {
        await page.goto(`./?lang=${language}`);
        await page.evaluate(() => window.texelcast.ready);
        await editor.idle();
        await page.locator("#tool-text").click();
        await expect(page.locator("tc-tool-options p")).toBeVisible();
        expect(await cutOff(page.locator("tc-tool-options .often, tc-tool-options p")), language).toEqual([0, 0]);
      }
    });

    test("place and opacity of a gradient's colour are read whole", async ({ editor, page }) => {
      await editor.open();
      await editor.addLayer(/^Gradient fill/);
      await page.locator("#sheet-properties").click();
      const numbers = page.locator("tc-gradient-stops tc-number");
      await expect(numbers).toHaveCount(2);
      for (let at = 0; at < 2; at += 1) {
        await numbers.nth(at).locator("input").fill("99.5");
        await numbers.nth(at).locator("input").press("Enter");
      }
      await editor.idle();
      expect(await cutOff(numbers.locator("input"))).toEqual([0, 0]);
    });
  });
}
