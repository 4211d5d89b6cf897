/** How wide `<texelcast-editor>` is where the page does not say: beside other things, and in boxes that are as wide as what is in them. */
import { expect, type Page, test } from "@playwright/test";

/** The element's width in a body with these rules, pixels, and whether the page is wider than its window. */
async function roomIn(page: Page, rules: string): Promise<{ width: number; isTooWide: boolean }> {
  await page.goto("element.html?loading=lazy");
  return await page.evaluate(async (text) => {
    document.adoptedStyleSheets = [await new CSSStyleSheet().replace(text)];
    const editor = document.querySelector("texelcast-editor") as HTMLElement;
    // Nothing of the test page's own: the element and a neighbour, in a box.
    const box = document.createElement("section");
    const neighbour = document.createElement("aside");
    neighbour.textContent = "Mug, 14.90 €";
    box.append(editor, neighbour);
    document.body.replaceChildren(box);
    document.querySelectorAll("style, link[rel=stylesheet]").forEach((sheet) => void sheet.remove());
    const { scrollWidth, clientWidth } = document.documentElement;
    return { width: editor.getBoundingClientRect().width, isTooWide: scrollWidth > clientWidth };
  }, rules);
}

const BOXES = {
  "a row": "section { display: flex }",
  "a box as wide as what is in it": "section { display: inline-block }",
  "a column that puts things in its middle": "section { display: flex; flex-direction: column; align-items: center }",
  "a grid's column that is as wide as what is in it":
    "section { display: inline-grid; grid-template-columns: auto auto }",
  "a box that floats": "section { float: left }",
};

for (const [where, rules] of Object.entries(BOXES)) {
  test(`the element has room in ${where}, on a desk and on a phone`, async ({ page }) => {
    const wide = await roomIn(page, rules);
    expect(wide.width).toBeGreaterThan(600);
    expect(wide.isTooWide).toBe(false);
    await page.setViewportSize({ width: 390, height: 844 });
    expect((await roomIn(page, rules)).width).toBeGreaterThan(240);
  });
}

test("the element takes the room that its neighbours leave, however little", async ({ page }) => {
  for (const rules of [
    "section { display: flex } texelcast-editor { flex: 1 } aside { flex: none; width: 200px }",
    "section { display: grid; grid-template-columns: 1fr 200px }",
    "section { display: flex } aside { flex: none; width: 200px }",
  ]) {
    await page.setViewportSize({ width: 460, height: 844 });
    const { width, isTooWide } = await roomIn(page, rules);
    expect(width, rules).toBeLessThan(260);
    expect(width, rules).toBeGreaterThan(200);
    expect(isTooWide, rules).toBe(false);
  }
});
