/** `<texelcast-editor>` that a page moves into another document of its own: an iframe without an address, a window. */
import { expect, type Frame, type Page, test } from "@playwright/test";

type Editor = HTMLElementTagNameMap["texelcast-editor"];

/** A document beside the page's own, tall enough to work in. */
async function otherDocument(page: Page, kind: "iframe" | "window"): Promise<Frame> {
  if (kind === "window") {
    const opened = page.waitForEvent("popup");
    await page.evaluate(() => void window.open("about:blank", "other", "width=900,height=800"));
    return (await opened).mainFrame();
  }
  await page.evaluate(() => {
    const iframe = document.createElement("iframe");
    iframe.name = "other";
    Object.assign(iframe.style, { width: "900px", height: "700px", border: "0" });
    document.body.prepend(iframe);
  });
  const frame = page.frame("other");
  if (!frame) throw new Error("The iframe has no document.");
  return frame;
}

/** Takes the page's element there; what it tells from then on is its `told`. */
const moveTo = (page: Page, kind: "iframe" | "window"): Promise<void> =>
  page.evaluate((kind) => {
    const editor = document.querySelector("texelcast-editor") as Editor;
    const target = kind === "iframe" ? window.frames[0] : window.open("", "other");
    target?.document.body.append(target.document.adoptNode(editor));
  }, kind);

const look = (frame: Frame): Promise<Record<string, string | undefined>> =>
  frame.locator("texelcast-editor").evaluate((editor) => {
    const view = editor.ownerDocument.defaultView as Window;
    const submit = editor.shadowRoot?.querySelector("[data-act=submit]");
    const { display, position, contain } = view.getComputedStyle(editor);
    return {
      ...{ display, position, contain },
      rem: view.getComputedStyle(editor).getPropertyValue("--_texelcast-rem"),
      button: submit ? view.getComputedStyle(submit).backgroundColor : undefined,
      view: view.getComputedStyle(editor.shadowRoot?.querySelector(".tcv-root") as Element).overflow,
    };
  });

for (const kind of ["iframe", "window"] as const) {
  for (const mode of ["shop", "full"] as const) {
    test(`moved into another ${kind}, the ${mode} mode keeps its looks and its design, and goes on`, async ({
      page,
    }) => {
      const thrown: string[] = [];
      page.on("pageerror", (error) => thrown.push(String(error)));
      await page.goto(`element.html?loading=eager&mode=${mode}`);
      await page.locator("texelcast-editor").evaluate(async (element: Editor) => {
        await element.addDecal("demo/decals/smiley.png");
      });
      const before = await look(page.mainFrame());
      const other = await otherDocument(page, kind);
      await moveTo(page, kind);
      const editor = other.locator("texelcast-editor");
      await editor.evaluate((element: Editor) => element.start());
      await expect.poll(() => look(other)).toEqual(before);

      // The steps came along, too.
      const counts = await editor.evaluate(async (element: Editor) => {
        const layers = async (): Promise<number> => (await element.exportDesign()).design.layers.length;
        const moved = await layers();
        element.undo();
        return [moved, await layers(), element.redo(), await layers()];
      });
      expect(counts).toEqual([1, 0, true, 1]);

      // A hand finds the decal, and a key of that document takes its drag back.
      const place = async (): Promise<unknown> =>
        (await editor.evaluate((element: Editor) => element.exportDesign())).design.layers[0];
      const rested = await place();
      const { mouse, keyboard } = kind === "iframe" ? page : other.page();
      const box = await editor.locator(".tcv-canvas").first().boundingBox();
      if (!box) throw new Error("The view has no place.");
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      const drag = async (): Promise<void> => {
        await mouse.move(x, y);
        await mouse.down();
        await mouse.move(x + 20, y, { steps: 4 });
      };
      await drag();
      await keyboard.press("Escape");
      await mouse.up();
      expect(await place()).toEqual(rested);
      await drag();
      await mouse.up();
      expect(await place()).not.toEqual(rested);
      expect(thrown).toEqual([]);
    });
  }
}

for (const kind of ["iframe", "window"] as const) {
  test(`in another ${kind}, rows of the full mode's list are dragged, and keys of that document take a drag back`, async ({
    page,
  }) => {
    await page.goto("element.html?loading=eager&mode=full");
    await page.locator("texelcast-editor").evaluate(async (element: Editor) => {
      await element.addDecal("demo/decals/smiley.png", { name: "below" });
      await element.addDecal("demo/decals/smiley.png", { name: "above" });
    });
    const other = await otherDocument(page, kind);
    await moveTo(page, kind);
    const editor = other.locator("texelcast-editor");
    await editor.evaluate((element: Editor) => element.start());
    const { mouse, keyboard } = kind === "iframe" ? page : other.page();
    const layers = async (): Promise<readonly unknown[]> =>
      (await editor.evaluate((element: Editor) => element.exportDesign())).design.layers;
    const names = async (): Promise<unknown> => (await layers()).map((layer) => (layer as { name: string }).name);
    const press = async (selector: string, text?: string): Promise<{ x: number; y: number; height: number }> => {
      const place = editor.locator(selector, text === undefined ? {} : { hasText: text });
      await place.scrollIntoViewIfNeeded();
      const box = await place.boundingBox();
      if (!box) throw new Error(`There is no ${selector}.`);
      const at = { x: box.x + box.width / 2, y: box.y + box.height / 2, height: box.height };
      await mouse.move(at.x, at.y);
      await mouse.down();
      return at;
    };

    const dragDown = async (): Promise<void> => {
      const { x, y, height } = await press("tc-layer-list .row .name", "above");
      await mouse.move(x, y + 3 * height, { steps: 6 });
    };
    await dragDown();
    await keyboard.press("Escape");
    await mouse.up();
    expect(await names()).toEqual(["below", "above"]);
    await dragDown();
    await mouse.up();
    expect(await names()).toEqual(["above", "below"]);

    const rested = await layers();
    const { x, y } = await press('tc-number[data-field="position-x"] label');
    await mouse.move(x + 30, y, { steps: 3 });
    await keyboard.press("Escape");
    await mouse.up();
    expect(await layers()).toEqual(rested);
  });
}

test("a wide window that a narrow one's full mode is moved into gives it the room of a wide one", async ({ page }) => {
  await page.setViewportSize({ width: 420, height: 800 });
  await page.goto("element.html?loading=eager&mode=full&size=256&locale=en");
  await page.locator("texelcast-editor").evaluate((element: Editor) => element.start());
  const other = await otherDocument(page, "window");
  await other.page().setViewportSize({ width: 1200, height: 800 });
  await moveTo(page, "window");
  const editor = other.locator("texelcast-editor");
  await editor.evaluate((element: Editor) => element.start());
  await editor.locator("#view-menu").click();
  const panel = editor.locator("#view-panel");
  await expect(panel).toBeVisible();
  // Beside its button, towards the model: not where a window as narrow as the script's would end.
  const [button, box] = [await editor.locator("#view-menu").boundingBox(), await panel.boundingBox()];
  if (!button || !box) throw new Error("The view's settings have no place.");
  expect(box.x + box.width).toBeLessThanOrEqual(button.x);
  expect(button.x - (box.x + box.width)).toBeLessThan(10);
});
