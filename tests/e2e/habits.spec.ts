/** What hands bring along from other editors: a copy by Alt, a menu by the right button, a double click, all of it chosen. */
import { paintPng } from "../support/png-file.ts";
import { type EditorPage, expect, test } from "./support/editor-page.ts";
import { file, ringPicture, squareGlb } from "./support/test-files.ts";

const names = async (editor: EditorPage): Promise<string[]> => (await editor.design()).layers.map(({ name }) => name);

async function openOnBadge(editor: EditorPage): Promise<string> {
  await editor.open();
  await editor.openModel([squareGlb()]);
  return editor.addDemoDecal("badge");
}

test("a decal that is dragged with Alt leaves a copy where it lay; Escape and undo leave neither", async ({
  editor,
  page,
}) => {
  const id = await openOnBadge(editor);
  const before = await editor.design();
  const start = await editor.settledHash();
  const from = await editor.pointOf(id);
  const to = { x: from.x + 60, y: from.y + 30 };

  await page.keyboard.down("Alt");
  let shown = 0;
  await editor.drag(from, to, 6, async () => {
    shown = (await editor.design()).layers.length;
  });
  await page.keyboard.up("Alt");
  expect(shown, "while it is dragged").toBe(2);
  const copied = await editor.design();
  expect(copied.layers).toMatchObject([
    { ...before.layers[0], id: expect.not.stringMatching(`^${id}$`) },
    { id, name: "Travel badge 2" },
  ]);
  expect(copied.layers[1]).not.toMatchObject({
    projector: (await editor.decal(copied.layers[0]?.id as string)).projector,
  });
  expect(await editor.selectedName()).toBe("Travel badge 2");
  expect(await editor.settledHash()).not.toBe(start);
  await page.keyboard.press("Control+z");
  await editor.idle();
  expect(await editor.design()).toEqual(before);

  await page.keyboard.down("Alt");
  await editor.drag(from, to, 6, async () => page.keyboard.press("Escape"));
  await page.keyboard.up("Alt");
  expect(await editor.design()).toEqual(before);
  expect(await editor.settledHash()).toBe(start);

  // Without it the decal itself is moved.
  await editor.drag(from, to, 6);
  expect(await names(editor)).toEqual(["Travel badge"]);
});

test("Shift holds a drag to the row or the column that it began in, in both views, for as long as it is pressed", async ({
  editor,
  page,
}) => {
  const id = await openOnBadge(editor);
  const from = await editor.pointOf(id);
  const moved = async (): Promise<number[]> => {
    await editor.idle();
    const { x, y } = await editor.pointOf(id);
    return [x - from.x, y - from.y].map((pixels) => Math.round(pixels) + 0);
  };
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 10, from.y + 9);
  await page.mouse.move(from.x + 60, from.y + 24);
  await expect.poll(moved).toEqual([60, 24]);
  await page.keyboard.down("Shift");
  await expect.poll(moved, "at once").toEqual([60, 0]);
  await page.mouse.move(from.x + 20, from.y - 50);
  await expect.poll(moved).toEqual([0, -50]);
  await page.keyboard.up("Shift");
  await expect.poll(moved).toEqual([20, -50]);
  await page.mouse.up();

  await page.locator("tc-layer-properties input[value=uv]").check({ force: true });
  const stamp = async (): Promise<readonly number[]> => {
    await editor.idle();
    const { projector } = await editor.decal(id);
    return projector.kind === "uv" ? projector.center : [];
  };
  const [u = 0, v = 0] = await stamp();
  const flat = page.locator(".tcv-texture");
  const mark = await editor.places(
    flat.locator("[data-handle=w] .tcv-mark"),
    flat.locator("[data-handle=e] .tcv-mark"),
  );
  const [x, y] = (["x", "y"] as const).map((axis) => {
    const size = axis === "x" ? "width" : "height";
    return mark.reduce((sum, place) => sum + place[axis] + place[size] / 2, 0) / 2;
  }) as [number, number];
  await page.keyboard.down("Shift");
  await editor.drag({ x, y }, { x: x + 9, y: y + 30 }, 4);
  await page.keyboard.up("Shift");
  const [atU = 0, atV = 0] = await stamp();
  expect(atU).toBeCloseTo(u, 9);
  expect(Math.abs(atV - v)).toBeGreaterThan(0.01);
});

test("the right button on the model offers what can be done with the decal there, and a drag with it moves the view", async ({
  editor,
  page,
}) => {
  const id = await openOnBadge(editor);
  const at = await editor.pointOf(id);
  await page.keyboard.press("Escape");
  const menu = page.locator("tc-model-menu [role=menu]");

  await page.mouse.click(at.x, at.y, { button: "right" });
  await expect(menu).toBeVisible();
  expect(await editor.selectedName()).toBe("Travel badge");
  await page.keyboard.press("Escape");
  await expect(menu).toBeHidden();
  await expect(editor.view).toBeFocused();
  expect(await editor.selectedName(), "closed by Escape, it leaves the choice").toBe("Travel badge");

  await page.mouse.click(at.x, at.y, { button: "right" });
  await menu.getByRole("menuitem", { name: "Duplicate" }).click();
  expect(await names(editor)).toEqual(["Travel badge", "Travel badge 2"]);

  await page.mouse.move(at.x, at.y);
  await page.mouse.down({ button: "right" });
  await page.mouse.move(at.x + 40, at.y, { steps: 4 });
  await page.mouse.up({ button: "right" });
  await expect(menu).toBeHidden();
  await expect.poll(async () => (await editor.pointOf(id)).x).toBeGreaterThan(at.x + 10);

  // Where no decal lies, what needs one is not offered.
  await page.keyboard.press("Escape");
  const [view] = await editor.places(editor.view);
  await page.mouse.click(view.x + view.width / 2, view.y + 12, { button: "right" });
  await expect(menu.getByRole("menuitem")).toHaveText(["Select all"]);
  await page.keyboard.press("Escape");

  // A brush has the pointer for itself.
  await page.keyboard.press("b");
  await page.mouse.click(at.x, at.y, { button: "right" });
  await editor.idle();
  await expect(menu).toBeHidden();
});

test("the key for it opens the chosen layers' menu over the focused model", async ({ editor, page }) => {
  const id = await openOnBadge(editor);
  await editor.addDemoDecal("number");
  await editor.select(id);
  await editor.view.focus();
  await page.keyboard.press("ContextMenu");
  const menu = page.locator("tc-model-menu [role=menu]");
  await expect(menu).toBeVisible();
  await expect(menu.getByRole("menuitem", { name: "Duplicate" })).toBeFocused();
  await page.keyboard.press("Enter");
  await expect.poll(() => names(editor)).toEqual(["Travel badge", "Travel badge 2", "Number 07"]);
});

test("a double click on words has them typed, wherever the keyboard was", async ({ editor, page }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  await page.locator("#add-text").click();
  const words = page.locator("tc-text-fields textarea");
  await expect(words).toBeFocused();
  await page.locator("tc-side-panel #tab-history").click();
  const { x, y } = await editor.middleOfStage();
  await page.mouse.dblclick(x, y);
  await expect(words).toBeFocused();
  await page.keyboard.type("Ada");
  await expect.poll(async () => (await editor.design()).layers.at(-1)).toMatchObject({ text: "Ada" });
});

test("Ctrl A chooses all layers wherever the keyboard is, and marks no words of the page", async ({ editor, page }) => {
  await openOnBadge(editor);
  await editor.addDemoDecal("number");
  await editor.view.focus();
  await page.keyboard.press("Control+a");
  await expect(page.locator("tc-layer-list .row[aria-selected=true]")).toHaveCount(2);
  expect(await page.evaluate(() => getSelection()?.toString())).toBe("");
});

test("while a row is dragged an undo ends the drag, and neither it nor Delete does more", async ({ editor, page }) => {
  await openOnBadge(editor);
  await editor.addDemoDecal("number");
  const [upper, lower] = await editor.places(editor.row("Number 07"), editor.row("Travel badge"));
  const row = ({ x, y, height }: typeof upper) => ({ x: x + 60, y: y + height / 2 });
  await editor.drag(row(upper), { ...row(lower), y: lower.y + lower.height - 2 }, 5, async () => {
    await page.keyboard.press("Delete");
    await page.keyboard.press("Control+z");
  });
  expect(await names(editor)).toEqual(["Travel badge", "Number 07"]);
});

test("a view that is worked in by pointer has no frame of the keyboard's, whatever tools are chosen by keys; the tab key's has one", async ({
  editor,
  page,
}) => {
  await openOnBadge(editor);
  const framed = (): Promise<boolean> =>
    editor.view.evaluate((view) => view.matches(":focus") && getComputedStyle(view, "::after").content !== "none");
  const at = await editor.middleOfStage();
  await page.keyboard.press("b");
  await editor.drag(at, { x: at.x + 30, y: at.y }, 3);
  await page.keyboard.press("]");
  await editor.drag(at, { x: at.x + 30, y: at.y + 20 }, 3);
  await expect(editor.view).toBeFocused();
  expect(await framed()).toBe(false);
  await page.keyboard.press("Tab");
  await page.keyboard.press("Shift+Tab");
  await expect(editor.view).toBeFocused();
  expect(await framed()).toBe(true);
});

test("a decal's picture is replaced by another one, in one step: what it is called, where it lies and how it looks stays", async ({
  editor,
  page,
}) => {
  const id = await openOnBadge(editor);
  await page.keyboard.press("5");
  await editor.setField("spin", "20");
  const before = await editor.decal(id);
  const start = await editor.settledHash();
  const replace = page.getByRole("button", { name: "Replace picture…" });

  const wide = file(
    "wide.png",
    paintPng(64, 32, () => [10, 90, 200, 255]),
    "image/png",
  );
  await editor.choose(() => replace.click(), [wide]);
  const now = await editor.decal(id);
  if (before.projector.kind !== "planar" || now.projector.kind !== "planar") throw new Error("It lies in a box.");
  const [width, height, depth] = before.projector.size;
  expect(now).toEqual({
    ...before,
    asset: "wide",
    projector: { ...before.projector, size: [width, expect.closeTo(height / 2, 9), depth] },
  });
  expect(Object.keys((await editor.design()).assets), "the other picture went").toEqual(["wide"]);
  expect(await editor.settledHash()).not.toBe(start);
  await expect(page.locator("#undo")).toHaveAttribute("aria-label", "Undo replace picture");

  // One that cannot be read leaves it as it is.
  const broken = file("broken.png", ringPicture().buffer.subarray(0, 60), "image/png");
  await editor.choose(() => replace.click(), [broken]);
  await expect(editor.notices).toContainText("Could not open broken.png");
  expect(await editor.decal(id)).toEqual(now);

  await page.keyboard.press("Control+z");
  expect(await editor.decal(id)).toEqual(before);
  expect(await editor.settledHash()).toBe(start);

  // By the menu of the row, too, and not of what has no picture or is locked.
  await editor.row("Travel badge").click({ button: "right" });
  await editor.choose(() => page.getByRole("menuitem", { name: "Replace picture…" }).click(), [wide]);
  expect((await editor.decal(id)).asset).toBe("wide");
  await page.getByRole("button", { name: "Lock Travel badge", exact: true }).click();
  await expect(replace).toHaveCount(0);
  await editor.addLayer(/^Fill /);
  await expect(replace).toHaveCount(0);
});
