import { AxeBuilder } from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { type EditorPage, expect, test } from "./support/editor-page.ts";

/** Faults that keep someone from using the page, on all that it shows now, shadow trees included. */
async function seriousFaults(page: Page): Promise<string[]> {
  const { violations } = await new AxeBuilder({ page })
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .analyze();
  return violations
    .filter(({ impact }) => impact === "serious" || impact === "critical")
    .flatMap(({ id, nodes }) =>
      nodes.map(({ target, failureSummary }) => `${id} ${target.join(" ")}: ${failureSummary}`),
    );
}

/** Everything that opens, each with what opens it; what one opens the next one closes. */
const PLACES: readonly (readonly [string, (editor: EditorPage) => Promise<void>])[] = [
  ["the page with a demo", async () => {}],
  ["a selected box", async (editor) => editor.select((await editor.design()).layers[0]?.id ?? "")],
  [
    "a label wrapped around",
    async ({ page }) => page.locator("tc-layer-properties input[value=cylindrical]").check({ force: true }),
  ],
  ["the history", async ({ page }) => page.getByRole("tab", { name: "History" }).click()],
  [
    "the layers and the brush's options",
    async ({ page }) => {
      await page.getByRole("tab", { name: "Layers" }).click();
      await page.keyboard.press("b");
    },
  ],
  [
    "the help",
    async ({ page }) => {
      await page.keyboard.press("v");
      await page.getByRole("button", { name: "Keys and licences" }).click();
    },
  ],
  [
    "the export menu",
    async ({ page }) => {
      await page.keyboard.press("Escape");
      await page.getByRole("button", { name: "Export", exact: true }).click();
    },
  ],
];

for (const [scheme, places] of [
  ["light", PLACES],
  ["dark", PLACES.slice(0, 2)],
] as const) {
  test(`axe finds no serious fault on any panel, dialog or menu (${scheme})`, async ({ editor, page }) => {
    test.slow();
    await page.emulateMedia({ colorScheme: scheme, reducedMotion: "reduce" });
    await editor.open();
    for (const [name, open] of places) {
      await open(editor);
      await editor.idle();
      expect(await seriousFaults(page), name).toEqual([]);
    }
  });
}

test("axe finds no serious fault on a phone's panels", async ({ editor, page }) => {
  test.slow();
  await page.setViewportSize({ width: 390, height: 844 });
  await editor.open();
  for (const name of ["Layers", "Edit", "Settings"]) {
    await page.locator("tc-bottom-sheet").getByRole("button", { name, exact: true }).click();
    expect(await seriousFaults(page), name).toEqual([]);
  }
});
