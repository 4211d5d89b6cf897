/** What a screen reader makes of the page's parts: one name, one role and one state each. */
import type { Locator } from "@playwright/test";
import { expect, test } from "./support/editor-page.ts";
import { file } from "./support/test-files.ts";

const backgroundOf = (button: Locator): Promise<string> =>
  button.evaluate((element) => getComputedStyle(element).backgroundColor);

test("a button that lays something open says that it is open, not that it is pressed, and is seen to be", async ({
  editor,
  page,
}) => {
  await editor.openOnLowest();
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.locator("#tool-brush").click();
  for (const id of ["#more-options", "#show-palette", "#tool-tip", "#view-menu"]) {
    const button = page.locator(id);
    const closed = await backgroundOf(button);
    await expect(button).toHaveAttribute("aria-expanded", "false");
    await button.click();
    await page.mouse.move(0, 0);
    await expect(button).toHaveAttribute("aria-expanded", "true");
    await expect(button).not.toHaveAttribute("aria-pressed");
    await expect.poll(() => backgroundOf(button)).not.toBe(closed);
    await button.click();
  }
});

test("the panels of one side are one landmark, with groups of fields in it", async ({ editor, page }) => {
  await editor.openOnLowest();
  const panel = page.getByRole("complementary");
  await expect(panel.getByRole("group", { name: "Look" })).toBeVisible();
  await expect(panel.getByRole("region")).toHaveCount(0);
  await expect(page.getByRole("region", { name: "Status" })).toContainText("2048 × 2048");
});

test("the view says what its keys do with the tool in hand", async ({ editor, page }) => {
  await editor.openOnLowest();
  const decals = "Model in 3D. Arrow keys move the selected decal, or turn the view while none is selected.";
  await expect(editor.view).toHaveAccessibleName(decals);
  await page.keyboard.press("b");
  await expect(editor.view).toHaveAccessibleName(/^Model in 3D\. Brush: arrow keys move it over the surface/);
  await page.keyboard.press("v");
  await expect(editor.view).toHaveAccessibleName(decals);
});

test("what fails while the list of projects is open is told in it, and can be sent away there", async ({
  editor,
  page,
}) => {
  await editor.openOnLowest();
  await editor.drop([file("before.glb", "this is no model")], await editor.middleOfStage());
  await expect(editor.notices).toHaveCount(1);
  await page.locator("tc-top-bar .projects button").first().click();
  await page.getByRole("menuitem").first().click();
  const dialog = page.getByRole("dialog");
  await expect(dialog).toBeVisible();
  await expect(dialog.getByRole("alert"), "what was told before is not told again").toHaveCount(0);
  await editor.drop([file("knight.glb", "this is no model")], { x: 5, y: 5 });
  const alert = dialog.getByRole("alert");
  await expect(alert).toContainText("knight.glb");
  // Nothing lies over it: the pointer reaches it.
  await alert.getByRole("button", { name: "Dismiss" }).click();
  await expect(alert).toHaveCount(0);
  await expect(dialog.getByRole("button").first(), "the keyboard stays in the dialog").toBeFocused();
});

test("who asks for more contrast sees where fields end, and no word is paler than another", async ({
  editor,
  page,
}) => {
  await editor.openOnLowest();
  const colors = (): Promise<string[]> =>
    page.locator("tc-top-bar").evaluate((bar) => {
      const { borderBottomColor, color } = getComputedStyle(bar);
      const quiet = bar.shadowRoot?.querySelector("#help");
      return [borderBottomColor, color, quiet ? getComputedStyle(quiet).color : ""];
    });
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme, contrast: "no-preference", reducedMotion: "reduce" });
    const [usual, text, quiet] = await colors();
    expect(quiet).not.toBe(text);
    await page.emulateMedia({ contrast: "more" });
    await expect.poll(async () => (await colors())[2]).toBe(text);
    const [line = ""] = await colors();
    expect(line).not.toBe(usual);
  }
});

test("a decal's lines and handles stand out from a light model, in light and in dark", async ({ editor, page }) => {
  await editor.openOnLowest();
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
    const contrasts = (): Promise<{ handle: number; cream: number; told: number }> =>
      editor.view.evaluate((view) => {
        const channel = (share: number): number =>
          share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
        const light = (color: string): number => {
          const [red = 0, green = 0, blue = 0] = (color.match(/[\d.]+/g) ?? []).map((part) =>
            channel(Number(part) / 255),
          );
          return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
        };
        const between = (one: string, other: string): number => {
          const [darker = 0, lighter = 0] = [light(one), light(other)].sort((a, b) => a - b);
          return (lighter + 0.05) / (darker + 0.05);
        };
        const styleOf = (selector: string): CSSStyleDeclaration =>
          getComputedStyle(view.querySelector(selector) as Element);
        const { stroke, fill } = styleOf(".tcv-mark");
        const { color, backgroundColor } = styleOf(".tcv-readout");
        // The mug's own colour.
        return {
          handle: between(stroke, fill),
          cream: between(stroke, "rgb(235 230 222)"),
          told: between(color, backgroundColor),
        };
      });
    const { handle, cream, told } = await contrasts();
    expect(handle, `${colorScheme}: a handle's edge`).toBeGreaterThanOrEqual(3);
    expect(cream, `${colorScheme}: lines on a light model`).toBeGreaterThanOrEqual(3);
    expect(told, `${colorScheme}: what a drag tells`).toBeGreaterThanOrEqual(4.5);
  }
});
