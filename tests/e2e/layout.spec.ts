import { expect, test } from "./support/editor-page.ts";
import { lookAlike } from "./support/look-alike.ts";
import { readPng } from "./support/read-png.ts";
import { file, squareGlb } from "./support/test-files.ts";

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("the model stays in sight whatever panel is open", async ({ editor, page }) => {
    await editor.open();
    const sheet = page.locator("tc-bottom-sheet");
    for (const tab of ["layers", "properties", "history", "texture", "target"]) {
      const button = page.locator(`#sheet-${tab}`);
      if ((await button.getAttribute("aria-expanded")) !== "true") await button.tap();
      await expect(button).toHaveAttribute("aria-expanded", "true");
      const stage = await editor.stage.boundingBox();
      const panel = await sheet.boundingBox();
      if (!stage || !panel) throw new Error("A part of the page has no place.");
      expect(stage.height).toBeGreaterThan(844 * 0.35);
      expect(stage.y + stage.height, "the sheet does not cover the view").toBeLessThanOrEqual(panel.y + 1);
    }
    const id = await editor.lowestLayer();
    const at = await editor.pointOf(id);
    const stage = await editor.stage.boundingBox();
    expect(at.y, "the decal itself is in sight").toBeLessThan((stage?.y ?? 0) + (stage?.height ?? 0));
    await page.locator("#sheet-target").tap();
    await expect(page.locator("tc-bottom-sheet .panel")).toBeHidden();
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  });

  test("the views change places while the view's menu is open", async ({ editor, page }) => {
    await editor.open();
    await page.locator("#sheet-texture").tap();
    await page.locator("#view-menu").tap();
    await expect(page.locator("tc-bottom-sheet tc-view-settings")).toBeVisible();
    await page.locator("#swap-views").tap();
    await expect(editor.stage).toHaveCount(0);
    await expect(page.locator("tc-texture-panel canvas, .tcv-texture canvas").first()).toBeVisible();
    await expect(page.locator("tc-view-settings"), "they are the model's").toHaveCount(0);
  });

  test("the texture takes no room on the GPU before it is looked at, and is there when it is", async ({
    editor,
    page,
  }) => {
    await page.addInitScript(() => {
      const stored: string[] = [];
      Object.assign(window, { stored });
      const { texStorage2D } = WebGL2RenderingContext.prototype;
      WebGL2RenderingContext.prototype.texStorage2D = function (kind, levels, format, width, height) {
        if ((this.canvas as HTMLCanvasElement).closest(".tcv-texture")) stored.push(`${width} × ${height}`);
        texStorage2D.call(this, kind, levels, format, width, height);
      };
    });
    await editor.open();
    const stored = () => page.evaluate(() => Reflect.get(window, "stored"));
    expect(await stored()).toEqual([]);
    // The inside of the mug.
    const [red = 0, green = 0, blue = 0] = await editor.texels({ x: 600, y: 1000, width: 1, height: 1 });
    expect(red - blue).toBeGreaterThan(100);
    await page.locator("#sheet-texture").tap();
    const flat = page.locator(".tcv-texture canvas");
    // They tint what lies between them.
    await page.getByLabel("UV outlines").tap();
    await expect
      .poll(async () => {
        const { rgba } = readPng(await flat.screenshot());
        let found = 0;
        for (let at = 0; at < rgba.length; at += 4) {
          const [r = 0, g = 0, b = 0] = rgba.subarray(at, at + 3);
          if (Math.abs(r - red) + Math.abs(g - green) + Math.abs(b - blue) < 9) found += 1;
        }
        return found / (rgba.length / 4);
      }, "the share of the view that shows the inside's colour")
      .toBeGreaterThan(0.05);
    expect(await stored()).toEqual(["2048 × 2048"]);
  });

  test("the view's settings stand in the sheet, so that what they change is in sight", async ({ editor, page }) => {
    await editor.open();
    const opener = page.locator("#view-menu");
    const settings = page.locator("tc-view-settings");
    await opener.tap();
    const [view, panel] = await editor.places(editor.view, settings);
    expect(view.height).toBeGreaterThan(844 * 0.2);
    expect(panel.y).toBeGreaterThanOrEqual(view.y + view.height);
    const before = await editor.stage.screenshot();
    await settings.locator("#wireframe").tap();
    await expect.poll(async () => lookAlike(await editor.stage.screenshot(), before)).toBe(false);
    await page.keyboard.press("Escape");
    await expect(settings).toHaveCount(0);
    await expect(opener).toBeFocused();
    await opener.tap();
    await page.locator("#close-tool").tap();
    await expect(settings).toHaveCount(0);
    await opener.tap();
    await editor.resize(1180, 820);
    await expect(page.locator("#view-panel"), "where there is no sheet they stand beside their button").toBeVisible();
    await editor.resize(390, 844);
    await expect(page.locator("tc-bottom-sheet tc-view-settings")).toBeVisible();
    await expect(settings).toHaveCount(1);
  });

  test("what a finger has tapped looks as what was chosen without one", async ({ editor, page }) => {
    await editor.open();
    const look = (id: string) =>
      page.locator(id).evaluate((button) => {
        const { backgroundColor, color } = getComputedStyle(button);
        return { backgroundColor, color };
      });
    await page.emulateMedia({ reducedMotion: "reduce" });
    const [chosen, other] = [await look("#tool-move"), await look("#tool-eraser")];
    await page.locator("#tool-eraser").tap();
    await expect.poll(() => look("#tool-eraser")).toEqual(chosen);
    await page.locator("#tool-move").tap();
    await expect.poll(() => look("#tool-eraser")).toEqual(other);
  });
});

test.describe("on a phone held sideways", () => {
  test.use({ viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true });

  test("every tool is reached by scrolling, and the view's settings stand beside the model", async ({
    editor,
    page,
  }) => {
    await editor.open();
    const text = page.locator("#tool-text");
    await text.scrollIntoViewIfNeeded();
    await text.tap();
    await expect(text).toHaveAttribute("aria-checked", "true");
    const [tool, stage] = [await text.boundingBox(), await editor.stage.boundingBox()];
    if (!tool || !stage) throw new Error("A part of the page has no place.");
    expect(Math.min(tool.width, tool.height)).toBeGreaterThanOrEqual(43.5);
    expect(tool.y + tool.height).toBeLessThanOrEqual(stage.y + stage.height);
    await page.locator("#view-menu").tap();
    const [view, panel] = await editor.places(editor.view, page.locator("tc-view-settings"));
    expect(panel.x).toBeGreaterThanOrEqual(view.x + view.width);
    expect(panel.x + panel.width).toBeLessThanOrEqual(844);
    expect(panel.y + panel.height).toBeLessThanOrEqual(390);
  });
});

test.describe("on a low tablet", () => {
  test.use({ viewport: { width: 1024, height: 500 }, hasTouch: true, isMobile: true });

  test("the layers are in sight, what is below them is scrolled to, and the texture's own button is there", async ({
    editor,
    page,
  }) => {
    await editor.open();
    for (const name of ["Smiley", "Texelcast mark"]) {
      await expect(editor.row(name)).toBeInViewport({ ratio: 1 });
    }
    const fit = page.getByRole("button", { name: "Fit the texture into its panel" });
    await fit.scrollIntoViewIfNeeded();
    await expect(fit).toBeInViewport({ ratio: 1 });
    await page.locator("#tool-brush").tap();
    await page.locator("#more-options").tap();
    const side = page.locator("tc-side-panel");
    await expect.poll(() => side.evaluate((panel) => panel.scrollTop)).toBeGreaterThan(0);
    await expect(side.locator(".tool header")).toBeInViewport({ ratio: 1 });
  });
});

/** Every way to hold or to size it in which a sheet below the view would leave the model no room. */
for (const [name, width, height, hasTouch] of [
  ["a phone held sideways", 844, 390, true],
  ["a small phone held sideways", 667, 375, true],
  ["a low and narrow window", 720, 450, false],
] as const) {
  test.describe(`on ${name}`, () => {
    test.use({ viewport: { width, height }, hasTouch, isMobile: hasTouch });

    test("the model has the page's height, the sheet stands beside it, and gives it all of the width when closed", async ({
      editor,
      page,
    }) => {
      await editor.open();
      const view = editor.view;
      const box = async () => (await view.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
      for (const tab of ["layers", "properties", "history", "texture", "target"]) {
        const button = page.locator(`#sheet-${tab}`);
        if ((await button.getAttribute("aria-expanded")) !== "true") await button.click();
        await expect(button).toHaveAttribute("aria-expanded", "true");
        const panel = await page.locator("tc-bottom-sheet .panel").boundingBox();
        expect((await box()).height).toBeGreaterThan(height * 0.6);
        expect((await box()).width).toBeGreaterThan(width * 0.3);
        expect(panel?.x, "it does not cover the view").toBeGreaterThanOrEqual((await box()).x + (await box()).width);
      }
      const before = (await box()).width;
      await page.locator("#sheet-target").click();
      await expect(page.locator("tc-bottom-sheet .panel")).toBeHidden();
      expect((await box()).width).toBeGreaterThan(before + width * 0.3);
      await page.locator("#sheet-layers").click();
      for (const layer of ["Smiley", "Texelcast mark"]) await expect(editor.row(layer)).toBeInViewport({ ratio: 1 });
      await page.locator("#tool-brush").click();
      await page.locator("#more-options").click();
      await expect(page.locator("tc-bottom-sheet .tool header")).toBeInViewport({ ratio: 1 });
      await editor.drop([file("knight.glb", "this is no model")], await editor.middleOfStage());
      const notice = await editor.notices.boundingBox();
      expect(notice?.x, "a notice lies over the sheet").toBeGreaterThanOrEqual((await box()).x + (await box()).width);
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width);
    });
  });
}

test.describe("on the smallest phone", () => {
  test.use({ viewport: { width: 320, height: 568 }, hasTouch: true, isMobile: true });

  test("the model's menu shows its sign, as there is no width for its name, which a wider one shows", async ({
    editor,
    page,
  }) => {
    await editor.open();
    const menu = page.locator("tc-top-bar .models");
    await expect(menu.getByText("Mug")).toBeHidden();
    await expect(menu.locator("tc-icon").first()).toBeVisible();
    await expect(menu.getByRole("button")).toHaveAccessibleName(/Mug/);
    await editor.resize(390, 844);
    await expect(menu.getByText("Mug")).toBeVisible();
    await expect(menu.locator("tc-icon").first()).toBeHidden();
  });
});

test.describe("the first steps", () => {
  for (const [name, width, height] of [
    ["a small laptop", 1280, 640],
    ["a low window", 1024, 500],
    ["a tablet held upright", 768, 1024],
    ["a small phone", 360, 640],
    ["a low and narrow window", 720, 450],
  ] as const) {
    test(`stand beside the model on ${name}, and leave the layers in sight`, async ({ editor, page }) => {
      await page.setViewportSize({ width, height });
      await editor.open({ hint: true });
      for (let step = 0; step < 3; step += 1) {
        const [view, hint] = await editor.places(editor.view, page.locator("tc-first-hint section"));
        const beside = hint.y >= view.y + view.height || hint.x >= view.x + view.width;
        expect(beside, `step ${step}`).toBe(true);
        expect(hint.y + hint.height, `step ${step}`).toBeLessThanOrEqual(height);
        await expect(page.locator("tc-layer-list [aria-current=true]")).toBeInViewport({ ratio: 0.5 });
        await page.locator("tc-first-hint #next").click();
      }
      await expect(page.locator("tc-first-hint section")).toHaveCount(0);
    });
  }
});

test("the first steps go on by themselves with what is done, and wait for what is not", async ({ editor, page }) => {
  await editor.open({ hint: true });
  const title = page.locator("tc-first-hint h2");
  await expect(title).toHaveText("Choose a picture");
  const lowest = await editor.lowestLayer();
  const moved = async (id: string): Promise<void> => {
    const from = await editor.pointOf(id);
    await editor.drag(from, { x: from.x - 20, y: from.y - 20 }, 4);
  };
  await moved(lowest);
  await expect(title, "what was there is no picture of one's own choice").toHaveText("Choose a picture");
  await page.keyboard.press("Control+z");
  const flower = await editor.addDemoDecal("flower");
  await expect(title).toHaveText("Drag it where it should go");
  await editor.openModel([squareGlb()]);
  await expect(title, "where nothing is to be dragged").toHaveText("Choose a picture");
  await page.keyboard.press("Control+z");
  await expect(title).toHaveText("Drag it where it should go");
  await moved(flower);
  await expect(title).toHaveText("Take it with you");
  await page.keyboard.press("Control+z");
  await expect(title, "and do not go back").toHaveText("Take it with you");
});

test("a notice has the place of the first steps' card to itself, which is back when it is closed", async ({
  editor,
  page,
}) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await editor.open({ hint: true });
  const card = page.locator("tc-first-hint section");
  await expect(card).toBeVisible();
  await editor.drop([file("knight.glb", "this is no model")], await editor.middleOfStage());
  await expect(editor.notices).toBeVisible();
  await expect(card).toBeHidden();
  await editor.notices.locator(".dismiss").click();
  await expect(card).toBeVisible();
});

test("several notices leave most of a phone free, and are read one after the other", async ({ editor, page }) => {
  await editor.open();
  await page.setViewportSize({ width: 390, height: 844 });
  for (const name of ["one.glb", "two.glb", "three.glb"]) {
    await editor.drop([file(name, "this is no model")], { x: 200, y: 200 });
    await expect(editor.notices.filter({ hasText: name })).toHaveCount(1);
  }
  const read = (name: string) => editor.notices.filter({ hasText: name }).locator("p").first();
  const [all] = await editor.places(page.locator("tc-notice-stack .alerts"));
  expect(all.height).toBeLessThan(844 / 3);
  await expect(read("three.glb")).toBeVisible();
  await expect(read("two.glb")).toBeHidden();
  await editor.notices.filter({ hasText: "three.glb" }).locator(".dismiss").click();
  await expect(read("two.glb")).toBeVisible();
  await expect(read("one.glb")).toBeHidden();
});

test.describe("on a tablet", () => {
  test.use({ viewport: { width: 820, height: 1180 }, hasTouch: true, isMobile: true });

  test("the examples fill their rows, each as large as a finger", async ({ editor, page }) => {
    await editor.open();
    const tiles = await editor.places(...(await page.locator("tc-decal-palette [data-decal]").all()));
    const rows = [...new Set(tiles.map(({ y }) => y))].map((top) => tiles.filter(({ y }) => y === top).length);
    expect(new Set(rows).size, `tiles in the rows: ${rows}`).toBe(1);
    for (const { width, height } of tiles) expect(Math.min(width, height)).toBeGreaterThanOrEqual(44);
  });
});

test.describe("in German, whose words are long,", () => {
  test.use({ locale: "de-DE" });

  test("the texture's maps are all in sight beside the model", async ({ editor, page }) => {
    await page.setViewportSize({ width: 1440, height: 900 });
    await editor.open();
    const tabs = page.locator("tc-texture-panel [role=tablist]");
    await expect(tabs).toContainText("Überlappung");
    expect(await tabs.evaluate((list) => list.scrollWidth - list.clientWidth)).toBe(0);
  });

  test.describe("on a small phone", () => {
    test.use({ viewport: { width: 375, height: 667 }, hasTouch: true, isMobile: true });

    test("the texture's maps are all in sight in the sheet, too", async ({ editor, page }) => {
      await editor.open();
      await page.locator("#sheet-texture").tap();
      const tabs = page.locator("tc-texture-panel [role=tablist]");
      await expect(tabs).toContainText("Überlappung");
      expect(await tabs.evaluate((list) => list.scrollWidth - list.clientWidth)).toBe(0);
      await editor.resize(844, 390);
      const [list, ...each] = await editor.places(tabs, ...(await tabs.getByRole("tab").all()));
      for (const tab of each) expect(tab.x + tab.width).toBeLessThanOrEqual(list.x + list.width);
      expect(new Set(each.map(({ y }) => y)).size, "on its side, in one row").toBe(1);
    });

    test("a tablet on its side gives the model three fifths of the views, and the maps are chosen from a list", async ({
      editor,
      page,
    }) => {
      await editor.open();
      const tabs = page.locator("tc-texture-panel [role=tablist]");
      const maps = page.locator("tc-texture-panel").getByRole("combobox", { name: "Textur" });
      for (const [width, height] of [
        [1024, 768],
        [1180, 820],
      ] as const) {
        await editor.resize(width, height);
        await expect(tabs).toBeHidden();
        const [stage, texture, list, fit] = await editor.places(
          editor.stage,
          page.locator("tc-texture-panel"),
          maps,
          page.getByRole("button", { name: "Die Textur in ihr Feld einpassen" }),
        );
        expect(stage.width / (stage.width + texture.width), `${width} × ${height}`).toBeGreaterThan(0.6);
        expect(fit.y + fit.height / 2, "beside each other").toBeCloseTo(list.y + list.height / 2, 0);
        expect(Math.min(fit.width, fit.height, list.height)).toBeGreaterThanOrEqual(44);
        const overflow = await page
          .locator("tc-texture-panel footer")
          .evaluate((footer) => footer.scrollWidth - footer.clientWidth);
        expect(overflow, `the words below, ${width} × ${height}`).toBe(0);
      }
      await maps.selectOption("positions");
      await expect(page.locator("tc-texture-panel #tab-positions"), "the tabs of a wider panel").toHaveAttribute(
        "aria-selected",
        "true",
      );
    });

    test("on the smallest phone the panels' names stand apart, and what keys do has the width for its words", async ({
      editor,
      page,
    }) => {
      await page.setViewportSize({ width: 320, height: 568 });
      await editor.open();
      await page.locator("#sheet-properties").tap();
      const words = await page.locator("tc-bottom-sheet nav button").evaluateAll((tabs) =>
        tabs.map((tab) => {
          const range = document.createRange();
          range.selectNodeContents(tab);
          const { left, right } = range.getBoundingClientRect();
          return [left, right] as const;
        }),
      );
      const gaps = words.slice(1).map(([left], index) => left - (words[index]?.[1] ?? 0));
      expect(Math.min(...gaps)).toBeGreaterThanOrEqual(4);
      await page.locator("#help").tap();
      const meaning = await page.locator("tc-help-dialog dd").first().boundingBox();
      expect(meaning?.width).toBeGreaterThan(200);
    });

    test("a tablet held upright shows of what the two menus are", async ({ editor, page }) => {
      await page.setViewportSize({ width: 768, height: 1024 });
      await editor.open();
      const names = page.locator("tc-top-bar :is(.projects, .models) .opener").getByText("Tasse");
      await expect(names).toHaveCount(2);
      const cut = names.evaluateAll((all) => all.map((name) => name.scrollWidth - name.clientWidth));
      expect(await cut).toEqual([0, 0]);
    });

    test("a fault's exact words, which only German folds away, are unfolded by a finger", async ({ editor }) => {
      await editor.open();
      await editor.drop([file("knight.glb", "this is no model")], await editor.middleOfStage());
      const fold = editor.notices.locator("summary");
      await expect(fold).toBeVisible();
      expect((await fold.boundingBox())?.height).toBeGreaterThanOrEqual(43.5);
      await fold.tap();
      await expect(editor.notices.locator("details")).toHaveAttribute("open");
    });

    test("the brush's size is read whole", async ({ editor, page }) => {
      await editor.open();
      await page.locator("#tool-brush").tap();
      const size = editor.field("tool-size");
      for (const number of ["8,7", "12,5"]) {
        await size.fill(number);
        await size.press("Enter");
        await expect(size).toHaveValue(number);
        expect(await size.evaluate((field) => field.scrollWidth - field.clientWidth), number).toBe(0);
      }
    });
  });
});

test("tools and buttons stand beside the model's view, so that no handle lies under them", async ({ editor, page }) => {
  await editor.open();
  const rail = page.locator("tc-tool-rail [role=radiogroup]");
  for (const width of [1440, 1100]) {
    await editor.resize(width, 900);
    const [view, tools, buttons] = await editor.places(editor.view, rail, page.locator("tc-stage .tools"));
    expect(view.x).toBeGreaterThanOrEqual(tools.x + tools.width);
    expect(view.x + view.width).toBeLessThanOrEqual(buttons.x);
  }
});

for (const [name, width, height] of [
  ["a phone", 390, 844],
  ["a small phone", 360, 640],
  ["a phone held sideways", 844, 390],
] as const) {
  test(`on ${name} the model has the width up to the stage's end, and all of a decal's handles are in sight and under no button`, async ({
    editor,
    page,
  }) => {
    await page.setViewportSize({ width, height });
    await editor.openOnLowest();
    const [view, stage, buttons] = await editor.places(editor.view, editor.stage, page.locator("tc-stage .tools"));
    expect(view.x + view.width).toBe(stage.x + stage.width);
    expect(view.y).toBeGreaterThanOrEqual(buttons.y + buttons.height);
    for (const handle of ["nw", "se", "rotate", "depth"]) {
      const at = await editor.handle(handle);
      expect(at.x, handle).toBeGreaterThan(view.x);
      expect(at.x, handle).toBeLessThan(view.x + view.width);
    }
  });
}

test("of two menus that are named alike is read what each is of", async ({ editor, page }) => {
  await editor.open();
  await expect(page.locator("tc-top-bar .projects .opener")).toHaveText(/^\s*Project\s*Mug\s*$/);
  await expect(page.locator("tc-top-bar .models .opener")).toHaveText(/^\s*Model\s*Mug\s*$/);
});

test("every control has a name, and the keyboard reaches the views and the panels", async ({ editor, page }) => {
  await editor.open();
  const nameless = await page.evaluate(() => {
    const faults: string[] = [];
    const visit = (root: ParentNode): void => {
      for (const element of root.querySelectorAll<HTMLElement>("*")) {
        if (element.shadowRoot) visit(element.shadowRoot);
        if (!element.matches("button, input, select, [role=tab], [role=separator], [role=application]")) continue;
        if (element.hidden) continue;
        const labelled = (element as HTMLInputElement).labels?.length ?? 0;
        const name = element.getAttribute("aria-label") ?? element.textContent?.trim() ?? "";
        if (!name && labelled === 0) faults.push(element.outerHTML.slice(0, 120));
      }
    };
    visit(document);
    return faults;
  });
  expect(nameless).toEqual([]);
});

test("where the system forces its colours, what is chosen is marked, and what shows a colour keeps it", async ({
  editor,
  page,
}) => {
  await page.emulateMedia({ forcedColors: "active", reducedMotion: "reduce" });
  await editor.open();
  await page.locator("#tool-brush").click();
  await page.locator("#show-palette").click();
  const back = (selector: string): Promise<string> =>
    page
      .locator(selector)
      .first()
      .evaluate((element) => getComputedStyle(element).backgroundColor);
  const plain = await back("#tool-eraser");
  for (const chosen of ["#tool-brush", "#show-palette", "#layout-both", "#tab-texture", "#tab-layers"]) {
    expect.soft(await back(chosen), chosen).not.toBe(plain);
  }
  const swatch = page.locator("[data-color]").nth(9);
  const [, ...hex] = /^#(..)(..)(..)$/.exec((await swatch.getAttribute("data-color")) ?? "") ?? [];
  await expect(swatch).toHaveCSS("background-color", `rgb(${hex.map((pair) => Number.parseInt(pair, 16)).join(", ")})`);
});

test("a menu that is open stays at its button and in the window, whatever that becomes", async ({ editor, page }) => {
  await editor.open();
  await page.getByRole("button", { name: "Export", exact: true }).click();
  for (const [width, height] of [
    [900, 800],
    [390, 844],
    [844, 390],
    [1280, 800],
  ] as const) {
    await editor.resize(width, height);
    const [menu, button] = await editor.places(
      page.locator("tc-top-bar [role=menu]"),
      page.locator("tc-top-bar tc-menu[alignEnd] button").first(),
    );
    expect(menu.x).toBeGreaterThanOrEqual(0);
    expect(menu.x + menu.width).toBeLessThanOrEqual(width);
    expect(menu.y + menu.height).toBeLessThanOrEqual(height);
    expect(Math.abs(menu.x + menu.width - button.x - button.width), `${width} wide`).toBeLessThan(2);
    await expect(page.locator("tc-top-bar [role=menu] [role=menuitem]:focus")).toHaveCount(1);
  }
});

test("the splitter is moved by pointer and by keyboard", async ({ editor, page }) => {
  await editor.open();
  await expect(page.locator("#tab-overlap"), "the texture's maps are all in sight").toBeInViewport({ ratio: 1 });
  const width = async () => (await editor.stage.boundingBox())?.width ?? 0;
  const before = await width();
  const bar = page.locator("tc-splitter [role=separator]");
  const box = await bar.boundingBox();
  if (!box) throw new Error("There is no splitter.");
  // By its last pixel, which lies over the texture.
  await editor.drag({ x: box.x + box.width - 1, y: 300 }, { x: box.x - 95, y: 300 }, 4);
  const dragged = await width();
  expect(before - dragged).toBeGreaterThan(80);
  await bar.focus();
  await page.keyboard.press("ArrowRight");
  expect(await width()).toBeGreaterThan(dragged);
  await page.locator("#tool-brush").click();
  await bar.press("Home");
  await page.locator("#more-options").click();
  const options = page.locator("tc-stage tc-tool-options");
  for (const part of await options.locator(".often > *, .drop > *").all()) {
    const inside = await part.boundingBox();
    expect(inside?.x, "nothing of the brush is cut off where the model has little room").toBeGreaterThanOrEqual(0);
    expect((inside?.x ?? 0) + (inside?.width ?? 0)).toBeLessThanOrEqual(await width());
  }
  await expect(options.locator(".drop [data-field=tool-size]")).toBeVisible();
});

test("long work shows its progress and can be cancelled, which leaves everything as it was", async ({
  editor,
  page,
}) => {
  await editor.open();
  const before = await editor.textureSize();
  await page.locator("tc-target-settings #size").selectOption("8192");
  const cancel = page.getByRole("button", { name: "Cancel" });
  await expect(cancel).toBeVisible();
  // By its key: a click waits until the notice has come to rest, and the work may be over by then.
  await cancel.press("Enter");
  await expect(cancel).toHaveCount(0);
  await editor.idle();
  expect(await editor.textureSize()).toEqual(before);
  await expect(page.locator("tc-target-settings #size")).toHaveValue("");
  await expect(editor.notices).toHaveCount(0);
});
