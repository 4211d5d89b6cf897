/** When a page that asks `<texelcast-editor>` to start is told that it has. */
import { expect, test } from "@playwright/test";

test("start() of an element that was just given another product resolves when that one is shown, and tells where it cannot be", async ({
  page,
}) => {
  await page.route("**/nothing.glb", (route) => route.fulfill({ status: 404 }));
  await page.goto("element.html?loading=lazy&size=256&locale=en");
  const found = await page
    .locator("texelcast-editor")
    .evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) => {
      await element.start();
      element.src = "demo/skateboard.glb";
      await element.start();
      const shown = element.loaded;
      element.src = "demo/nothing.glb";
      const refused = await element.start().then(
        () => "shown",
        ({ code }) => code as string,
      );
      return { shown, refused };
    });
  expect(found).toEqual({ shown: true, refused: "missing-file" });
});
