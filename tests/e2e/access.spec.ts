/** Every panel, dialog and menu: axe's serious faults in light and dark, and targets that can be hit. */
import type { Page } from "@playwright/test";
import { type EditorPage, expect, test } from "./support/editor-page.ts";
import { seriousFaults, smallTargets } from "./support/page-faults.ts";
import { file } from "./support/test-files.ts";

// A place that cannot be reached is told by its name, and soon.
test.use({ actionTimeout: 20_000 });

type Place = readonly [string, (editor: EditorPage) => Promise<unknown>];

const press =
  (...keys: string[]) =>
  async ({ page }: EditorPage): Promise<void> => {
    for (const key of keys) await page.keyboard.press(key);
  };

const click =
  (...selectors: string[]) =>
  async ({ page }: EditorPage): Promise<void> => {
    for (const selector of selectors) await page.locator(selector).first().click();
  };

const check =
  (selector: string) =>
  ({ page }: EditorPage): Promise<void> =>
    page.locator(selector).check({ force: true });

async function dropBrokenModel(editor: EditorPage): Promise<void> {
  await editor.drop([file("knight.glb", "this is no model")], await editor.middleOfStage());
  await expect(editor.notices).toHaveCount(1);
}

async function openTemplate(editor: EditorPage): Promise<void> {
  await click("tc-template-dialog [data-template=block-wide]")(editor);
  await editor.idle();
  await dismissNotices(editor.page);
}

async function dismissNotices(page: Page): Promise<void> {
  const dismiss = page.locator("tc-notice-stack .dismiss");
  while ((await dismiss.count()) > 0) await dismiss.first().click();
}

/** What opens one closes the one before. */
const ON_A_DESKTOP: readonly Place[] = [
  ["the page with its first hint", async () => {}],
  ["a selected box", async (editor) => editor.select((await editor.design()).layers[0]?.id ?? "")],
  ["a picture from the view", check("tc-layer-properties input[value=perspective]")],
  ["a label wrapped around", check("tc-layer-properties input[value=cylindrical]")],
  ["a stamp", check("tc-layer-properties input[value=uv]")],
  ["a text with an outline", (editor) => addText(editor).then(() => check("tc-text-fields #outline")(editor))],
  ["the fonts", click("tc-text-fields #font button")],
  [
    "the menu of new layers",
    (editor) => press("Escape")(editor).then(() => click("tc-layer-list .add button")(editor)),
  ],
  ["a gradient", click("tc-layer-list .add [role=menuitem] >> nth=2")],
  ["a masked group", (editor) => press("Control+g")(editor).then(() => click("[data-action=add-mask]")(editor))],
  ["a mask that fades", check("tc-layer-properties input[name=mask-start][value=linear]")],
  ["several layers", press("Control+a")],
  ["layers that are hidden", click("tc-layer-list .row [data-action=visible]")],
  ["more to do with layers", click("tc-layer-list .more button")],
  ["the history", (editor) => press("Escape")(editor).then(() => click("#tab-history")(editor))],
  ["the brush’s seldom used fields", click("#tab-layers", "#tool-brush", "#more-options")],
  ["the palette", click("#show-palette")],
  ["the view’s menu", click("#show-palette", "#view-menu")],
  ["a map of the texture alone", click("#view-menu", "#layout-texture", "tc-texture-panel #tab-overlap")],
  ["the projects’ menu", click("#layout-both", "tc-top-bar .projects button")],
  ["the projects", click("tc-top-bar .projects [role=menuitem] >> nth=0")],
  [
    "a project that was deleted",
    click("tc-projects-dialog [data-action=duplicate]", "tc-projects-dialog [data-action=delete]"),
  ],
  ["the models’ menu", (editor) => press("Escape")(editor).then(() => click("tc-top-bar .models button")(editor))],
  ["the export’s menu", (editor) => press("Escape")(editor).then(() => click("tc-menu[alignEnd] button")(editor))],
  ["the help", press("Escape", "?")],
  ["a notice of a fault", (editor) => press("Escape")(editor).then(() => dropBrokenModel(editor))],
  ["the templates", (editor) => dismissNotices(editor.page).then(() => openTemplates(editor))],
  ["a skin with its parts, posed", (editor) => openTemplate(editor).then(() => click("tc-stage #play")(editor))],
  ["the pencil’s options", click("#rest", "#tool-pencil")],
];

const ON_A_PHONE: readonly Place[] = [
  ["the page with its first hint", async () => {}],
  ["a selected box", click("tc-first-hint #dismiss", "#sheet-properties")],
  [
    "a text with an outline",
    (editor) =>
      click("#sheet-layers")(editor)
        .then(() => addText(editor))
        .then(() => check("tc-text-fields #outline")(editor)),
  ],
  ["the menu of new layers", click("#sheet-layers", "tc-layer-list .add button")],
  ["a gradient", click("tc-layer-list .add [role=menuitem] >> nth=2", "#sheet-properties")],
  ["the history", click("#sheet-history")],
  ["the texture", click("#sheet-texture")],
  ["the settings and parts", click("#sheet-target")],
  ["the brush’s seldom used fields", click("#tool-brush", "#more-options")],
  ["the palette", click("#show-palette")],
  ["the view’s menu", click("#close-tool", "#view-menu")],
  ["the texture in the model’s place", click("#view-menu", "#swap-views")],
  ["the help", click("#swap-views", "#help")],
  ["a notice of a fault", (editor) => press("Escape")(editor).then(() => dropBrokenModel(editor))],
  ["the templates", (editor) => dismissNotices(editor.page).then(() => openTemplates(editor))],
  ["the pencil’s options", (editor) => openTemplate(editor).then(() => click("#tool-pencil")(editor))],
  ["the projects", click("tc-top-bar .projects button", "tc-top-bar .projects [role=menuitem] >> nth=0")],
];

async function addText(editor: EditorPage): Promise<void> {
  await editor.page.locator("#add-text").click();
  await expect(editor.page.locator("tc-text-fields textarea")).toBeVisible();
  await editor.idle();
}

async function openTemplates(editor: EditorPage): Promise<void> {
  await click("tc-top-bar .projects button", 'tc-top-bar .projects [role=menuitem]:has-text("New project")')(editor);
  await editor.page.locator("tc-template-dialog [data-template]").first().waitFor();
}

async function expectNoFault(editor: EditorPage, places: readonly Place[], leastTarget: number): Promise<void> {
  await eachPlace(editor, places, async (name) => {
    expect.soft(await seriousFaults(editor.page), name).toEqual([]);
    expect.soft(await smallTargets(editor.page, leastTarget), name).toEqual([]);
  });
}

async function eachPlace(
  editor: EditorPage,
  places: readonly Place[],
  look: (name: string) => Promise<void>,
): Promise<void> {
  await editor.page.emulateMedia({ reducedMotion: "reduce" });
  await editor.open({ hint: true });
  for (const [name, open] of places) {
    await open(editor);
    await editor.idle();
    await look(name);
  }
}

test("axe finds no serious fault on any panel, dialog or menu, in light and dark", async ({ editor }) => {
  test.slow();
  await expectNoFault(editor, ON_A_DESKTOP, 24);
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("axe finds no serious fault on any panel either, and all is large enough for fingers", async ({ editor }) => {
    test.slow();
    await expectNoFault(editor, ON_A_PHONE, 44);
  });
});

for (const [device, width, height, places] of [
  ["a tablet", 1024, 768, ON_A_DESKTOP],
  ["a phone held sideways", 844, 390, ON_A_PHONE],
] as const) {
  test.describe(`on ${device}`, () => {
    test.use({ viewport: { width, height }, hasTouch: true, isMobile: true });

    test("all is large enough for fingers as well", async ({ editor }) => {
      test.slow();
      await eachPlace(editor, places, async (name) => {
        expect.soft(await smallTargets(editor.page, 44), name).toEqual([]);
      });
    });
  });
}
