/** What the editor asks for until it can be worked on: on a phone's line each answer that another waits for takes a sixth of a second. */
import { expect, test } from "./support/editor-page.ts";

test("the editor is there after the scripts of its page, and its engine after one of its own", async ({
  editor,
  page,
}) => {
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await editor.open();
  const scripts = asked.filter((path) => path.endsWith(".js")).map((path) => path.replace(/^.*\/|-[\w-]{8}\.js$/g, ""));
  const ofPage = await page
    .locator("script[src], link[rel=modulepreload]")
    .evaluateAll((parts) => parts.map((part) => part.getAttribute("src") ?? part.getAttribute("href") ?? ""));
  expect(ofPage.length, ofPage.join(" ")).toBeLessThan(9);
  expect(scripts.filter((name) => /worker/.test(name))).toEqual(["engine-worker"]);
  // Beside those: what shows a picture upright, asked for as the picture itself is decoded.
  expect(scripts.length, scripts.join(" ")).toBeLessThanOrEqual(ofPage.length + 2);
});

test("the list of demos is on its way while the scripts are, and asked for once", async ({ editor, page }) => {
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname.replace(/^.*\//, "")));
  await editor.open();
  expect(asked.filter((name) => name === "demo.json")).toHaveLength(1);
  expect(asked.indexOf("demo.json")).toBeLessThan(asked.findIndex((name) => name.startsWith("engine-worker")));
});
