/** What the editor asks for until it can be worked on: on a phone's line each answer that another waits for takes a sixth of a second. */
import { expect, test } from "./support/editor-page.ts";

test("the editor is there after few scripts, and its engine after one", async ({ editor, page }) => {
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await editor.open();
  const scripts = asked.filter((path) => path.endsWith(".js")).map((path) => path.replace(/^.*\/|-[\w-]{8}\.js$/g, ""));
  // There were 79.
  expect(scripts.length, scripts.join(" ")).toBeLessThan(21);
  expect(scripts.filter((name) => /worker/.test(name))).toEqual(["engine-worker"]);
});

test("the list of demos is on its way while the scripts are, and asked for once", async ({ editor, page }) => {
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname.replace(/^.*\//, "")));
  await editor.open();
  expect(asked.filter((name) => name === "demo.json")).toHaveLength(1);
  expect(asked.indexOf("demo.json")).toBeLessThan(asked.findIndex((name) => name.startsWith("engine-worker")));
});

for (const mode of ["shop", "full"]) {
  test(`an element in ${mode} mode runs nothing of the editor's own page, whose parts it shares`, async ({ page }) => {
    await page.goto(`element.html?mode=${mode}&loading=eager`);
    await page.locator("texelcast-editor").evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) => {
      await element.addDecal("demo/decals/smiley.png");
      await element.exportTexture();
      await element.snapshot();
    });
    expect(await page.evaluate(() => "texelcast" in window)).toBe(false);
    await expect(page.locator("body > tc-workbench")).toHaveCount(0);
  });
}
