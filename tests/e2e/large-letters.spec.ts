/** The page with all of it or its letters made larger by the browser: at 400 %, and with letters twice as large (WCAG 1.4.4, 1.4.10). */
import { expect, test } from "./support/editor-page.ts";

for (const [width, height] of [
  [320, 256],
  [360, 225],
] as const) {
  test.describe(`on a desktop's page at 400 %, of ${width} × ${height}`, () => {
    test.use({ viewport: { width, height } });

    test("the panel of the texture shows some of it", async ({ editor, page }) => {
      await editor.open();
      await page.locator("#sheet-texture").click();
      const view = page.locator(".tcv-texture");
      await view.scrollIntoViewIfNeeded();
      await expect(view).toBeInViewport();
      expect((await view.boundingBox())?.height).toBeGreaterThan(100);
      await page.locator("#outlines").click();
      await expect(page.locator("#outlines")).not.toBeChecked();
    });

    test("a page that is scrolled is worked in where the pointer is", async ({ editor, page }) => {
      await editor.open();
      await page.locator("#sheet-layers").click();
      await page.evaluate(() => scrollTo(0, 1000));
      const id = await editor.lowestLayer();
      const before = await editor.decal(id);
      const from = await editor.pointOf(id);
      await editor.drag(from, { x: from.x + 8, y: from.y }, 4);
      const after = await editor.decal(id);
      const moved = await editor.pointOf(id);
      expect(after.projector).not.toEqual(before.projector);
      expect(Math.abs(moved.x - from.x - 8)).toBeLessThan(3);
    });

    test("no button lies over another, with a tool's settings too, and the layers are scrolled to", async ({
      editor,
      page,
    }) => {
      await editor.open();
      const covered = (): Promise<string[]> =>
        page.locator("tc-tool-rail button, tc-stage .tools button, tc-tool-options button").evaluateAll((buttons) =>
          buttons.flatMap((button) => {
            const { x, y, width, height } = button.getBoundingClientRect();
            // What has given way is not shown.
            if (width === 0) return [];
            return [0.1, 0.5, 0.9].flatMap((share) => {
              let top = document.elementFromPoint(x + width * share, y + height / 2);
              while (top?.shadowRoot) {
                const inner = top.shadowRoot.elementFromPoint(x + width * share, y + height / 2);
                if (!inner || inner === top) break;
                top = inner;
              }
              return top && button.contains(top) ? [] : [`${button.getAttribute("aria-label")} at ${share}`];
            });
          }),
        );
      for (const tool of ["#tool-move", "#tool-brush"]) {
        await page.locator(tool).click();
        await expect.poll(covered, tool).toEqual([]);
      }
      const row = page.locator("tc-layer-list .row").last();
      await row.scrollIntoViewIfNeeded();
      await row.click();
      await expect(row).toHaveAttribute("aria-current", "true");
    });
  });
}

test.describe("with letters twice as large as usual", () => {
  test.use({ viewport: { width: 390, height: 844 } });

  test("nothing of the sheet or of a menu lies beyond the page's side", async ({ editor, page }) => {
    const session = await page.context().newCDPSession(page);
    await session.send("Page.setFontSizes", { fontSizes: { standard: 32 } });
    await editor.open();
    // The shelf of decals is scrolled to the side.
    const SHEET = "tc-bottom-sheet :is(button:not([data-decal]), input, select)";
    /** What of these ends beyond the page. */
    const beyond = (controls: string): Promise<string[]> =>
      page.locator(controls).evaluateAll((all) =>
        all.flatMap((control) => {
          const { left, right, width } = control.getBoundingClientRect();
          return width > 0 && (left < 0 || right > innerWidth) ? [control.outerHTML.slice(0, 80)] : [];
        }),
      );
    for (const tab of ["properties", "history", "texture", "target", "layers"]) {
      await page.locator(`#sheet-${tab}`).click();
      await expect.poll(() => beyond(SHEET), tab).toEqual([]);
    }
    await page.locator("#sheet-target").click();
    const material = await page.locator("tc-target-settings #material").boundingBox();
    expect(material?.width, "the material's name is read").toBeGreaterThan(250);
    await page.locator("#sheet-layers").click();
    const blend = await page.locator("tc-layer-list [data-action=blend]").boundingBox();
    expect(blend?.width, "the mode of blending is read").toBeGreaterThan(120);
    await page.locator("#view-menu").click();
    await expect(page.locator("tc-bottom-sheet tc-view-settings")).toBeVisible();
    await expect.poll(() => beyond(SHEET)).toEqual([]);
    const lying = await page.locator("tc-view-settings").evaluate((settings) => {
      const parts = [...(settings.shadowRoot?.children ?? [])].filter((part) => part.clientHeight > 0);
      return parts.filter((part) => part.scrollHeight > part.clientHeight + 1).map((part) => part.textContent?.trim());
    });
    expect(lying, "what lies over the next").toEqual([]);
    await page.locator("tc-top-bar .projects button").first().click();
    await expect.poll(() => beyond("tc-top-bar [role=menuitem]")).toEqual([]);
  });
});
