import type { DesignLayer } from "../../web/editor/document/index.ts";
import { expect, test } from "./support/editor-page.ts";
import { squareGlb } from "./support/test-files.ts";

/** "Badge, Group(Number, Flower)": bottom to top. */
const shapeOf = (layers: readonly DesignLayer[]): string =>
  layers.map((layer) => (layer.type === "group" ? `${layer.name}(${shapeOf(layer.layers)})` : layer.name)).join(", ");

test("layers are grouped, renamed, hidden together, and dragged or moved by key into a group and out of it", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  for (const id of ["badge", "number", "flower"]) await editor.addDemoDecal(id);
  const start = await editor.settledHash();
  const shape = async () => shapeOf((await editor.design()).layers);

  await editor.row("Number 07").click();
  await editor.row("Flower").click({ modifiers: ["Shift"] });
  await page.keyboard.press("Control+g");
  expect(await shape()).toBe("Travel badge, Group(Number 07, Flower)");
  expect(await editor.settledHash(), "a group paints as its layers do").toBe(start);

  await editor.row("Group").focus();
  await page.keyboard.press("F2");
  await page.keyboard.type("Crest");
  await page.keyboard.press("Enter");
  expect(await shape()).toBe("Travel badge, Crest(Number 07, Flower)");
  await expect(editor.row("Crest")).toBeFocused();

  const drag = async (name: string, onto: string, share: number): Promise<void> => {
    const from = await editor.row(name).boundingBox();
    const to = await editor.row(onto).boundingBox();
    if (!from || !to) throw new Error("A row has no place.");
    const x = from.x + 70;
    await editor.drag({ x, y: from.y + from.height / 2 }, { x, y: to.y + to.height * share }, 6);
  };
  await drag("Travel badge", "Crest", 0.5);
  expect(await shape()).toBe("Crest(Number 07, Flower, Travel badge)");
  await drag("Flower", "Crest", 0.1);
  expect(await shape()).toBe("Crest(Number 07, Travel badge), Flower");
  await editor.row("Flower").focus();
  await page.keyboard.press("Alt+ArrowDown");
  expect(await shape(), "Alt and the arrows go into a group").toBe("Crest(Number 07, Travel badge, Flower)");

  await editor.row("Crest").focus();
  await page.keyboard.press("ArrowLeft");
  await expect(editor.row("Flower")).toHaveCount(0);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press(" ");
  expect(await editor.settledHash(), "a hidden group hides its layers").not.toBe(start);
});

test("a mask hides what it hides, a lock refuses, and the history goes to any step", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const bare = await editor.settledHash();
  await editor.addDemoDecal("badge");
  const painted = await editor.settledHash();

  await page.locator("tc-layer-list .more button").first().click();
  await page.getByRole("menuitem", { name: "Add mask that hides all" }).click();
  expect(await editor.settledHash()).toBe(bare);
  await expect(editor.row("Travel badge").locator("[data-action=mask]")).toHaveAttribute("aria-pressed", "true");

  await editor.row("Travel badge").locator("[data-action=locked]").click();
  await editor.row("Travel badge").focus();
  await page.keyboard.press("Delete");
  await expect(editor.notices).toContainText("Travel badge is locked");
  await expect(editor.row("Travel badge")).toHaveCount(1);

  await page.getByRole("tab", { name: "History" }).click();
  const steps = page.locator("tc-history-panel [role=option]");
  await expect(page.locator("tc-history-panel [aria-selected=true]")).toHaveText("Lock layer");
  await steps.filter({ hasText: "Add decal" }).click();
  expect(await editor.settledHash()).toBe(painted);
  await page.locator("tc-history-panel .list").press("End");
  expect(await editor.settledHash()).toBe(bare);
});

test("a mask begins with a gradient that handles move and greys shade, below what is painted; each is one step, and kept", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const badge = await editor.addDemoDecal("badge");
  const painted = await editor.settledHash();
  const hashes = [painted];
  const step = async (why: string): Promise<void> => {
    const hash = await editor.settledHash();
    expect(hash, why).not.toBe(hashes.at(-1));
    hashes.push(hash);
  };
  const ground = async () => {
    const lowest = (await editor.decal(badge)).mask?.layers[0];
    if (lowest?.type !== "fill") throw new Error("The mask begins with no fill.");
    return lowest;
  };
  await page.locator("tc-layer-list .more button").first().click();
  await page.getByRole("menuitem", { name: "Mask with a gradient" }).click();
  await expect(editor.row("Travel badge").locator("[data-action=mask]")).toHaveAttribute("aria-pressed", "true");
  await step("it fades the badge");
  expect(await ground()).toMatchObject({ blend: "erase", gradient: { kind: "linear" } });

  const handle = page.locator("[data-gradient-handle=second]");
  await expect(handle).toBeVisible();
  const box = await handle.boundingBox();
  if (!box) throw new Error("The gradient has no handle.");
  const from = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  await editor.drag(from, { x: from.x + 30, y: from.y + 60 }, 5);
  await step("its end was dragged");

  await expect(page.locator("tc-gradient-stops [data-field=stop-alpha]"), "a mask's greys have no opacity").toHaveCount(
    0,
  );
  await page.locator("tc-gradient-stops .handle").first().focus();
  await page.locator("tc-gradient-stops input[type=color]").fill("#808080");
  await step("its black is a grey now");
  expect((await ground()).gradient?.stops[0]?.color).toBe("#0000007f");

  await page.getByRole("radio", { name: "Eraser" }).click();
  const middle = await editor.middleOfStage();
  await editor.drag({ x: middle.x - 40, y: middle.y }, { x: middle.x + 40, y: middle.y }, 5);
  await step("the eraser hides more");
  const { mask } = await editor.decal(badge);
  expect(mask?.layers.map(({ type }) => type)).toEqual(["fill", "stroke"]);

  await page.getByRole("radio", { name: "Radial" }).check();
  await step("the gradient is round");
  await page.getByRole("radio", { name: "Nothing" }).check();
  await step("all but what is painted is hidden");

  const undone = hashes.slice(0, -1).reverse();
  for (const hash of undone) {
    await page.keyboard.press("Control+z");
    await expect.poll(() => editor.settledHash()).toBe(hash);
  }
  for (const _step of undone) await page.keyboard.press("Control+Shift+z");
  await page.keyboard.press("Control+z");
  const kept = hashes.at(-2) as string;
  await expect.poll(() => editor.settledHash()).toBe(kept);
  await page.evaluate(() => window.texelcast.kept());
  await editor.reload();
  expect(await editor.settledHash()).toBe(kept);
});

test("on an inverted mask the eraser hides what it goes over, and the brush shows it again", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const bare = await editor.settledHash();
  await editor.addDemoDecal("badge");
  const painted = await editor.settledHash();
  const choose = async (name: string): Promise<void> => {
    await page.locator("tc-layer-list .more button").first().click();
    await page.getByRole("menuitem", { name }).click();
  };
  await choose("Add mask that hides all");
  expect(await editor.settledHash()).toBe(bare);
  await choose("Invert mask");
  expect(await editor.settledHash()).toBe(painted);
  const { x, y } = await editor.middleOfStage();
  await page.keyboard.press("e");
  await editor.drag({ x: x - 40, y }, { x: x + 40, y }, 5);
  expect(await editor.settledHash(), "hidden").not.toBe(painted);
  await page.keyboard.press("b");
  await editor.setField("tool-size", "400");
  await editor.drag({ x: x - 40, y }, { x: x + 40, y }, 5);
  expect(await editor.settledHash(), "shown again").toBe(painted);
});

test("merging says what it did instead; ungrouping says first what would change, and goes on when it is told to", async ({
  editor,
  page,
}) => {
  await editor.open();
  const { layers } = await editor.design();
  await editor.row(layers[1]?.name ?? "").click();
  await page.keyboard.press("Control+e");
  await expect(editor.notices).toContainText("Put into a group instead");
  await page.locator("#undo").click();
  await expect(editor.notices, "what was worth a glance goes with the next step").toHaveCount(0);
  await editor.row(layers[0]?.name ?? "").click();
  await editor.row(layers[1]?.name ?? "").click({ modifiers: ["Shift"] });
  await page.keyboard.press("Control+g");
  await editor.idle();
  await editor.setField("opacity", "40");
  await editor.idle();
  const grouped = await editor.settledHash();
  await editor.row("Group").click();
  await page.keyboard.press("Control+Shift+g");
  const goOn = page.getByRole("button", { name: "Ungroup anyway" });
  await expect(goOn).toBeVisible();
  expect(await editor.settledHash(), "nothing was done yet").toBe(grouped);
  await goOn.click();
  await editor.idle();
  expect((await editor.design()).layers).toHaveLength(layers.length);
  await page.locator("#undo").click();
  expect(await editor.settledHash()).toBe(grouped);
});

test("a double click renames the layer that it began on, whatever was chosen before", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  for (const id of ["badge", "number", "flower", "waves"]) await editor.addDemoDecal(id);
  await page.keyboard.press("Escape");
  await expect(page.locator("tc-layer-list [aria-selected=true]")).toHaveCount(0);
  await editor.row("Number 07").getByText("Number 07").dblclick();
  await expect(page.locator("tc-layer-list input.name")).toHaveValue("Number 07");
  await page.keyboard.type("Seven");
  await page.keyboard.press("Enter");
  expect(shapeOf((await editor.design()).layers)).toContain("Travel badge, Seven, Flower");
});

test("the keyboard goes on from the row that an act has made, or that is left of those it took", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  for (const id of ["badge", "number", "flower"]) await editor.addDemoDecal(id);
  await editor.row("Number 07").click();
  await page.keyboard.press("Control+d");
  await expect(editor.row("Number 07 2")).toBeFocused();
  await page.keyboard.press("Control+g");
  await expect(editor.row("Group")).toBeFocused();
  await page.keyboard.press("Control+Shift+g");
  await expect(editor.row("Number 07 2")).toBeFocused();
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await expect(editor.row("Number 07 2")).toHaveCount(0);
  await expect(page.locator("tc-layer-list .row:focus")).toHaveCount(1);
});

test("Delete takes the layers that are chosen, also before the keyboard has come to them, or where it was led away", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  for (const id of ["badge", "number", "flower"]) await editor.addDemoDecal(id);
  for (const act of ["g", "e"]) {
    await editor.row("Number 07").click();
    await editor.row("Travel badge").click({ modifiers: ["Shift"] });
    // Without a frame between them, in which the list would have shown the group.
    await editor.row("Travel badge").evaluate((row, key) => {
      for (const init of [{ key, ctrlKey: true }, { key: "Delete" }])
        row.dispatchEvent(new KeyboardEvent("keydown", { ...init, bubbles: true, cancelable: true, composed: true }));
    }, act);
    expect(shapeOf((await editor.design()).layers)).toBe("Flower");
    for (let step = 0; step < 2; step += 1) await page.locator("#undo").click();
    expect(shapeOf((await editor.design()).layers)).toBe("Travel badge, Number 07, Flower");
  }
  await editor.row("Number 07").click();
  await page.keyboard.press("Control+ArrowDown");
  await expect(editor.row("Travel badge")).toBeFocused();
  await page.keyboard.press("Delete");
  expect(shapeOf((await editor.design()).layers)).toBe("Travel badge, Flower");
});

test("a renaming that ends with a press elsewhere leaves the keyboard there", async ({ editor, page }) => {
  await editor.open();
  await editor.row("Texelcast mark").click();
  await page.keyboard.press("F2");
  await page.keyboard.type("Crest");
  await editor.field("position-x").click();
  await expect(editor.row("Crest")).toBeVisible();
  await expect(editor.field("position-x")).toBeFocused();
});

test.describe("by a finger", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("a double tap at a name's end renames its layer, and the lock that comes with the first tap stays open", async ({
    editor,
    page,
  }) => {
    await editor.open();
    const row = editor.row("Smiley");
    const box = await row.locator(".name").boundingBox();
    const eye = await row.locator("[data-action=visible]").boundingBox();
    if (!box || !eye) throw new Error("The row has no place.");
    const y = box.y + box.height / 2;
    // Both at once: on a busy machine two that wait for each other are too far apart for a double tap.
    const twice = async (x: number): Promise<void> => {
      await Promise.all([page.touchscreen.tap(x, y), page.touchscreen.tap(x, y)]);
      await editor.idle();
    };
    // Where the lock comes to stand.
    await twice(eye.x - 20);
    expect((await editor.design()).layers.map(({ locked }) => locked)).toEqual([false, false]);
    await editor.select(await editor.lowestLayer());
    // Nearer to it, browsers take a finger's tap for one on the lock.
    await twice(box.x + box.width - 24);
    await expect(page.locator("tc-layer-list input.name")).toBeFocused();
    expect((await editor.design()).layers.map(({ locked }) => locked)).toEqual([false, false]);
  });
});
