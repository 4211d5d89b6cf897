/** What a shop's customer reads where a part of the shop's own set-up does not come, and what the shop's page is told of it. */
import { expect, type Locator, type Page, test } from "@playwright/test";
import { emptyDesign, type TextLayer } from "../../web/editor/document/design.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];
const LANGUAGES = { en: /went wrong/, de: /Fehler aufgetreten/ };
/** What only those who made the page can do anything about. */
const DEVELOPERS = /http|worker-src|\.wasm|\.ttf|404|address|Adresse|glTF|\.glb/;

const TEXT = {
  ...{ type: "text", id: "words", name: "Words", text: "Ada", font: "hand", fontSize: 1 },
  projector: { kind: "planar", position: [0, 0.05, 0.04], rotation: [0, 0, 0, 1], size: [0.05, 0.05, 0.04] },
} as unknown as TextLayer;
const DESIGN = {
  ...emptyDesign(),
  assets: { hand: { type: "font/ttf", uri: "texelcast:fonts/lobster-400" } },
  layers: [TEXT],
};

/** Opens the mug with that design; what the page is told is in `window.told`. */
async function openShop(page: Page, locale: string, design: object | null = null): Promise<Locator> {
  await page.goto(`element.html?mode=shop&loading=lazy&src=demo/mug.glb&locale=${locale}`);
  const editor = page.locator("texelcast-editor");
  await editor.evaluate((element: Editor, design) => {
    const told: object[] = [];
    Object.assign(window, { told });
    element.addEventListener("error", ({ detail }) => told.push(detail));
    element.design = design as never;
    element.start().catch(() => undefined);
  }, design);
  return editor;
}

const toldOf = (page: Page): Promise<string> =>
  page.evaluate(() => JSON.stringify((window as { told?: object[] }).told));

for (const [locale, calm] of Object.entries(LANGUAGES)) {
  test(`a design's font that does not come is told to the customer in calm words, and to the page whole (${locale})`, async ({
    page,
  }) => {
    await page.route(/Lobster/, (route) => route.fulfill({ status: 404 }));
    const editor = await openShop(page, locale, DESIGN);
    const notice = editor.getByRole("alert");
    await expect(notice).toContainText(calm);
    await expect(notice).not.toContainText(DEVELOPERS);
    expect(await toldOf(page)).toMatch(/"not-loaded".*Lobster|Lobster.*"not-loaded"/);
  });

  test(`a product in whose place a server sends a page is told to the customer in calm words, and to the page by its name (${locale})`, async ({
    page,
  }) => {
    await page.route(/\/demo\/mug\.glb$/, (route) =>
      route.fulfill({ contentType: "text/html", body: "<!doctype html>" }),
    );
    const notice = (await openShop(page, locale)).getByRole("alert");
    await expect(notice).toContainText(calm);
    await expect(notice).not.toContainText(DEVELOPERS);
    expect(await toldOf(page)).toMatch(/"bad-container".*mug\.glb/);
  });

  test(`an engine that does not come is told to the customer in calm words, and to the page whole (${locale})`, async ({
    page,
  }) => {
    await page.route(/\.wasm/, (route) => route.fulfill({ status: 404 }));
    const notice = (await openShop(page, locale)).getByRole("alert");
    await expect(notice).toContainText(calm);
    await expect(notice).not.toContainText(DEVELOPERS);
    expect(await toldOf(page)).toMatch(/\.wasm/);
  });

  test(`a worker that may not begin is told to the customer in calm words, and to the page whole (${locale})`, async ({
    page,
  }) => {
    await page.route(/engine-worker/, (route) => route.abort());
    const notice = (await openShop(page, locale)).getByRole("alert");
    await expect(notice).toBeVisible();
    await expect(notice).not.toContainText(DEVELOPERS);
    expect(await toldOf(page)).toMatch(/engine-crashed|engine-halted/);
  });
}
