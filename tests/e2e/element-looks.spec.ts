/** `<texelcast-editor>` on a page with rules of its own for everything: they stay outside. */
import { expect, type Page, test } from "@playwright/test";
import { readPng } from "./support/read-png.ts";

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

/** The shop mode with a picture and a long text in it, whose text is chosen. */
async function openShop(page: Page, text: string): Promise<void> {
  await page.goto("element.html?loading=eager&locale=de&size=256");
  await page.evaluate(async (words) => {
    const editor = document.querySelector("texelcast-editor") as HTMLElementTagNameMap["texelcast-editor"];
    await editor.start();
    await editor.addDecal("demo/decals/smiley.png");
    await editor.select(await editor.addText(words));
  }, text);
  await expect(page.locator("texelcast-editor textarea")).toBeVisible();
}

test("in a page that runs from the right the element's own words and numbers run from the left, and names as they are written", async ({
  page,
}) => {
  await page.addInitScript(() =>
    document.addEventListener("DOMContentLoaded", () => (document.documentElement.dir = "rtl")),
  );
  await openShop(page, "שלום עולם");
  const direction = (selector: string): Promise<string[]> =>
    page
      .locator(`texelcast-editor ${selector}`)
      .evaluateAll((all) => all.map((each) => getComputedStyle(each).direction));
  expect(await direction(".row .name > span:first-child")).toEqual(["rtl", "ltr"]);
  expect(new Set(await direction(".quiet, .foot, tc-number .box, .add"))).toEqual(new Set(["ltr"]));
  expect(await direction("slot[name=toolbar]"), "what stands there is the page's").toEqual(["rtl"]);
  await page.goto("element.html?loading=eager&mode=full");
  await page.evaluate(() => document.querySelector("texelcast-editor")?.start());
  expect(new Set(await direction("tc-top-bar, tc-number, tc-layer-list"))).toEqual(new Set(["ltr"]));
});

test("where the system forces its colours, a shop's buttons have an edge, and what is chosen is seen", async ({
  page,
}) => {
  await page.emulateMedia({ forcedColors: "active" });
  await openShop(page, "Moin");
  const style = (selector: string) =>
    page.locator(`texelcast-editor ${selector}`).evaluate((element) => {
      const { borderTopStyle, borderTopWidth, outlineStyle, color } = getComputedStyle(element);
      return { border: `${borderTopStyle} ${borderTopWidth}`, outline: outlineStyle, color };
    });
  for (const act of ["upload", "text", "submit"]) expect((await style(`[data-act=${act}]`)).border).toBe("solid 1px");
  expect((await style(".row[data-chosen]")).outline).toBe("solid");
  expect((await style(".row:not([data-chosen])")).outline).toBe("none");
  expect((await style("[data-act=redo]")).color).not.toBe((await style("[data-act=undo]")).color);
});

test("where the system forces its colours, a product that loads says how far it is, and the view that has the keyboard is framed", async ({
  page,
}) => {
  await page.emulateMedia({ forcedColors: "active" });
  let letGo = (): void => {};
  const held = new Promise<void>((resolve) => {
    letGo = resolve;
  });
  await page.route("**/mug.glb", async (route) => {
    await held;
    await route.continue();
  });
  await page.goto("element.html?loading=eager&size=256");
  const colorsIn = async (clip: { x: number; y: number; width: number; height: number }): Promise<number> => {
    const { rgba } = readPng(await page.screenshot({ clip, animations: "disabled" }));
    return new Set(new Uint32Array(new Uint8Array(rgba).buffer)).size;
  };
  const boxOf = async (role: "progressbar" | "application") => {
    const box = await page.locator("texelcast-editor").getByRole(role).boundingBox();
    if (!box) throw new Error(`The ${role} has no place on the page.`);
    return box;
  };
  await expect.poll(async () => colorsIn(await boxOf("progressbar")), "the bar").toBeGreaterThan(1);
  letGo();
  await page.evaluate(() => document.querySelector("texelcast-editor")?.start());
  await page.locator("texelcast-editor").getByRole("application").focus();
  await page.keyboard.press("ArrowLeft");
  const { x, y, height } = await boxOf("application");
  const edge = { x, y: y + height / 2, width: 8, height: 4 };
  await expect.poll(() => colorsIn(edge), "the view's edge").toBeGreaterThan(1);
});

test("who asks for more contrast sees in a shop where fields end, and reads all words alike", async ({ page }) => {
  await page.emulateMedia({ contrast: "more", reducedMotion: "reduce" });
  await openShop(page, "Moin");
  const color = (selector: string, property: "color" | "borderTopColor"): Promise<string> =>
    page
      .locator(`texelcast-editor ${selector}`)
      .first()
      .evaluate((element, name) => getComputedStyle(element)[name], property);
  const quiet = await color(".row .quiet", "color");
  expect(quiet).toBe(await color(".row .name", "color"));
  const edge = await color("textarea", "borderTopColor");
  expect(edge).toBe("rgb(90, 97, 108)");
  expect(await color("tc-number", "borderTopColor")).toBe(edge);
});

test("enlarged four times, a shop's list still shows whole rows, and all below it is reached", async ({ page }) => {
  await page.setViewportSize({ width: 320, height: 225 });
  await openShop(page, "Moin");
  const row = page.locator("texelcast-editor .row").first();
  const seen = (): Promise<number> =>
    row.evaluate(
      (element) =>
        new Promise<number>((resolve) => {
          const observer = new IntersectionObserver(([entry]) => {
            observer.disconnect();
            resolve(entry?.intersectionRatio ?? 0);
          });
          observer.observe(element);
        }),
    );
  await row.scrollIntoViewIfNeeded();
  expect(await seen()).toBe(1);
  const submit = page.locator("texelcast-editor [data-act=submit]");
  await submit.focus();
  await expect(submit).toBeInViewport({ ratio: 1 });
});

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

test.describe("on a tablet", () => {
  test.use({ viewport: { width: 820, height: 1180 }, hasTouch: true, isMobile: true });

  for (const [locale, names] of [
    ["en", ["Add picture", "Add text"]],
    ["de", ["Bild einfügen", "Text einfügen"]],
  ] as const) {
    test(`the buttons that add something say so in one line (${locale})`, async ({ page }) => {
      await page.goto(`element.html?loading=eager&locale=${locale}`);
      const editor = page.locator("texelcast-editor");
      await editor.evaluate((element: HTMLElementTagNameMap["texelcast-editor"]) => element.start());
      await editor.evaluate((element) => {
        element.style.width = "788px";
      });
      for (const name of names) {
        const lines = await editor.getByRole("button", { name }).evaluate((button) => {
          const words = [...button.childNodes].find((node) => node instanceof Text && node.data.trim() !== "");
          const range = document.createRange();
          range.selectNodeContents(words as Text);
          return new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size;
        });
        expect(lines, name).toBe(1);
      }
    });
  }
});
