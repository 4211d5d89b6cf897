/** A page that is open and has lost its connection: what it would only now fetch of itself is told, and asked for again. */
import { expect, test } from "@playwright/test";
import { EditorPage } from "./support/editor-page.ts";

/** The page, and a line that can be cut: what is fetched with such an address fails, as it does without a connection. */
async function openOnLine(page: EditorPage["page"]): Promise<{ editor: EditorPage; cut(what: RegExp | null): void }> {
  const editor = new EditorPage(page);
  await editor.open();
  let missing: RegExp | null = null;
  await page
    .context()
    .route("**/*", (route) =>
      missing?.test(route.request().url()) ? route.abort("internetdisconnected") : route.continue(),
    );
  const cut = (what: RegExp | null): void => {
    missing = what;
  };
  return { editor, cut };
}

const CONNECTION = "Check the connection and try again";

for (const [what, address] of [
  ["shapes words", /harfbuzz.*\.wasm/],
  ["draws them", /index_bg.*\.wasm/],
  ["their font is", /Inter_700Bold.*\.ttf/],
] as const) {
  test(`words for which what ${what} was not to be had come once it is, without loading the page again`, async ({
    page,
  }) => {
    const { editor, cut } = await openOnLine(page);
    const before = await editor.settledHash();
    cut(address);
    await editor.addLayer("Add text");
    await expect(editor.notices).toContainText(CONNECTION);
    await expect(editor.notices).not.toContainText(/Aborted|Check its address/);
    await editor.idle();
    expect(await editor.hash()).toBe(before);

    cut(null);
    await page.keyboard.press("Escape");
    await editor.addLayer("Add text");
    await expect(page.locator("tc-layer-list .row")).not.toHaveCount(2);
    await expect.poll(() => editor.settledHash()).not.toBe(before);
    await expect.poll(async () => (await editor.design()).layers.at(-1)?.type).toBe("text");
  });
}

test("words that came without what draws them are drawn with the next change, once it is to be had", async ({
  page,
}) => {
  const { editor, cut } = await openOnLine(page);
  cut(/index_bg.*\.wasm/);
  await editor.addLayer("Add text");
  await expect(editor.notices).toContainText(CONNECTION);
  await page.keyboard.press("Escape");
  const undrawn = await editor.settledHash();
  cut(null);
  const text = (await editor.design()).layers.at(-1)?.id ?? "";
  await editor.select(text);
  // Hidden and shown again it is the same design as before.
  const toggle = editor.row("Text").locator("[data-action=visible]");
  await expect
    .poll(async () => {
      await toggle.click();
      await toggle.click();
      return editor.settledHash();
    })
    .not.toBe(undrawn);
});

test("a demo whose pictures are not to be had says so, asks nobody for files, and opens once they are", async ({
  page,
}) => {
  const { editor, cut } = await openOnLine(page);
  const open = async (): Promise<void> => {
    await page.locator("tc-top-bar .models button").first().click();
    await page.getByRole("menuitemradio", { name: "Avatar" }).click();
    await editor.idle();
  };
  cut(/decals\/badge/);
  await open();
  await expect(editor.notices).toContainText("Could not open Avatar");
  await expect(editor.notices).toContainText(CONNECTION);
  cut(null);
  await open();
  await expect(page.locator("tc-stage #play")).toBeVisible();
});

test("a project that cannot be packed without a connection says what is missing, and is saved once there is one", async ({
  page,
}) => {
  const { editor, cut } = await openOnLine(page);
  cut(/project-worker/);
  await editor.chooseOfProjects("Save as one file");
  await expect(editor.notices).toContainText(CONNECTION);
  await expect(editor.notices).not.toContainText("undefined");
  cut(null);
  expect((await editor.savedProject()).bytes.length).toBeGreaterThan(10_000);
});

for (const [what, address] of [
  ["whose script", /engine-worker/],
  ["whose WebAssembly", /texelcast.*\.wasm/],
] as const) {
  test(`an engine that ended and ${what} is not to be had is waited for, and paints what was changed meanwhile by itself`, async ({
    page,
  }) => {
    const { editor, cut } = await openOnLine(page);
    const row = editor.row("Smiley").locator("[data-action=visible]");
    await row.click();
    const hidden = await editor.settledHash();
    await row.click();
    await editor.idle();
    cut(address);
    // The thread is gone, and nobody is told.
    void page
      .workers()
      .at(-1)
      ?.evaluate(() => close())
      .catch(() => undefined);
    await expect(editor.notices).toContainText("Painting waits for the connection");
    await expect(editor.notices).toHaveCount(1);
    await row.click();
    await page.getByRole("button", { name: "Export", exact: true }).click();
    await page.getByRole("menuitem", { name: "Texture as PNG" }).click();
    const refused = editor.notices.filter({ hasText: "Could not export" });
    await expect(refused).toContainText(CONNECTION);
    await expect(editor.notices.filter({ hasText: /Undo the last step|worker-src|keeps stopping/ })).toHaveCount(0);
    await expect(editor.notices).toHaveCount(2);

    cut(null);
    await expect(editor.notices.filter({ hasText: "Painting waits" })).toHaveCount(0);
    expect(await editor.settledHash()).toBe(hidden);
    expect((await editor.exported("Texture as PNG")).bytes.length).toBeGreaterThan(10_000);
  });
}
