/** What somebody reads whose page's own scripts do not come: a line that broke, an old page after a new release, a file from a disk. */
import { fileURLToPath } from "node:url";
import { expect, type Page, test } from "@playwright/test";

const PAGE = fileURLToPath(new URL("../../build/site/index.html", import.meta.url));

/** Does not wait as long as people would: the page's own animations, which all of it goes by, end at once. */
const afterAWhile = (page: Page): Promise<void> =>
  page.evaluate(() => {
    for (const { effect } of document.getAnimations()) effect?.updateTiming({ delay: 0, duration: 1, iterations: 1 });
  });

for (const [what, address, answer] of [
  ["breaks off", "./", { abort: "connectionreset" }],
  ["is another release's", "./", { status: 404 }],
  ["is somebody else's page", "./", { contentType: "text/html", body: "<!doctype html>" }],
  ["is opened as a file", `file://${PAGE}`, null],
] as const) {
  test(`a page whose script ${what} says in both languages what to do, instead of coming for ever`, async ({
    page,
  }) => {
    await page.route(/\/assets\/index-.*\.js$/, (route) =>
      answer === null || "abort" in answer ? route.abort() : route.fulfill(answer),
    );
    await page.goto(address);
    const told = page.getByRole("alert");
    await expect(page.getByRole("status")).toHaveText("Texelcast");
    await expect(told).toHaveCount(0);
    await afterAWhile(page);
    await expect(told).toContainText("Check the connection, and load the page again.");
    await expect(told.locator("[lang=de]")).toContainText("Prüfe die Verbindung, und lade die Seite neu.");
  });
}

test("a page whose scripts come tells nobody that they do not", async ({ page }) => {
  await page.goto("./");
  await page.evaluate(() => window.texelcast.ready);
  await expect(page.getByText("load the page again")).toHaveCount(0);
});
