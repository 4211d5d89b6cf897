/** `<texelcast-editor>` on a page with rules of its own for everything: they stay outside. */
import { expect, type Page, test } from "@playwright/test";

/** A page's resets as they are met in shops, and some that are worse. */
const PAGE_RULES = `
  html { font-size: 62.5%; }
  * { font-size: 9px; font-family: serif; font-style: italic; line-height: 3; letter-spacing: 4px; word-spacing: 9px; }
  * { text-align: right; text-indent: 2em; text-transform: uppercase; text-shadow: 0 0 2px red; white-space: pre; }
  * { word-break: break-all; }
`;

/** As a style sheet of the page's would; the site's policy lets none stand in it. */
const addRules = (page: Page, rules: string): Promise<void> =>
  page.evaluate(async (text) => {
    document.adoptedStyleSheets.push(await new CSSStyleSheet().replace(text));
  }, rules);

/** What is inherited, and what is measured in it, of every element of the house's own inside, by where it stands. */
const looks = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const names = [
      ...[
        "fontSize",
        "fontFamily",
        "fontStyle",
        "lineHeight",
        "letterSpacing",
        "wordSpacing",
        "textAlign",
        "textIndent",
      ],
      ...[
        "textTransform",
        "textShadow",
        "whiteSpace",
        "wordBreak",
        "padding",
        "gap",
        "minHeight",
        "borderRadius",
        "width",
      ],
    ] as const;
    const found: string[] = [];
    const visit = (root: ParentNode, path: string, inOwn: boolean): void => {
      for (const [index, element] of [...root.children].entries()) {
        const place = `${path} > ${element.localName}:${index}`;
        const style = getComputedStyle(element) as unknown as Record<string, string>;
        // What is drawn has no words.
        if (element.localName === "svg" || element.localName === "style") continue;
        const own = inOwn || element.classList.contains("own");
        if (own) found.push([place, ...names.map((name) => `${name}: ${style[name]}`)].join("; "));
        visit(element.shadowRoot ?? element, place, own);
      }
    };
    const { shadowRoot } = document.querySelector("texelcast-editor") as Element;
    if (shadowRoot) visit(shadowRoot, "", false);
    return found;
  });

for (const mode of ["shop", "full"]) {
  test(`a page's rules for all elements and for its own size of type do not reach into the ${mode} mode`, async ({
    page,
  }) => {
    await page.goto(`element.html?mode=${mode}&loading=eager`);
    // The box is the page's matter.
    await addRules(page, "texelcast-editor { width: 900px; height: 700px }");
    await page.evaluate(async () => {
      const editor = document.querySelector("texelcast-editor") as HTMLElementTagNameMap["texelcast-editor"];
      await editor.start();
      await editor.addText("Moin");
    });
    let before: string[] = [];
    const settled = async (): Promise<boolean> => {
      const seen = before;
      before = await looks(page);
      return before.length > 20 && before.join() === seen.join();
    };
    // Further apart than two changes of the status line's figures.
    await expect.poll(settled, { intervals: [1000] }).toBe(true);
    await addRules(page, PAGE_RULES);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const after = await looks(page);
    expect(after.filter((look, index) => look !== before[index])).toEqual([]);
    expect(after).toHaveLength(before.length);
  });
}

test("what a page puts into the element keeps the page's type", async ({ page }) => {
  await page.goto("element.html?loading=eager");
  await addRules(page, "body { font: italic 13px serif; letter-spacing: 2px }");
  const style = await page.evaluate(async () => {
    const editor = document.querySelector("texelcast-editor") as HTMLElementTagNameMap["texelcast-editor"];
    const help = document.createElement("a");
    help.slot = "toolbar";
    editor.append(help);
    await editor.start();
    const { fontSize, fontFamily, fontStyle, letterSpacing } = getComputedStyle(help);
    return { fontSize, fontFamily, fontStyle, letterSpacing };
  });
  expect(style).toEqual({ fontSize: "13px", fontFamily: "serif", fontStyle: "italic", letterSpacing: "2px" });
});
