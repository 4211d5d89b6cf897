/** Several decals, or a group of them, moved as one: by a drag of any, by keys; chosen on the model itself. */
import type { GroupLayer, PlanarProjector } from "../../web/editor/document/index.ts";
import { type EditorPage, expect, type Point, test } from "./support/editor-page.ts";
import { squareGlb } from "./support/test-files.ts";

/** A badge and a number on the square, apart from each other; the number is chosen. */
async function openOnTwo(editor: EditorPage): Promise<{ badge: string; number: string }> {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const badge = await editor.addDemoDecal("badge");
  const at = await editor.pointOf(badge);
  await editor.drag(at, { x: at.x - 90, y: at.y - 60 }, 4);
  const number = await editor.addDemoDecal("number");
  return { badge, number };
}

const chosen = (editor: EditorPage): Promise<string[]> =>
  editor.page.locator("tc-layer-list .row[aria-selected=true] .name").allTextContents();

/** Where the decals are, those in groups too, by name. */
async function projectors(editor: EditorPage): Promise<Record<string, PlanarProjector>> {
  const { layers } = await editor.design();
  const flat = layers.flatMap((layer) => (layer.type === "group" ? layer.layers : [layer]));
  return Object.fromEntries(
    flat.flatMap((each) => (each.type === "decal" ? [[each.name, each.projector]] : [])),
  ) as Record<string, PlanarProjector>;
}

async function wayOf(editor: EditorPage, before: Record<string, PlanarProjector>): Promise<Record<string, number[]>> {
  const now = await projectors(editor);
  return Object.fromEntries(
    Object.entries(before).map(([name, { position }]) => [
      name,
      position.map((part, axis) => Math.round(((now[name]?.position[axis] ?? 0) - part) * 1e6) / 1e6 + 0),
    ]),
  );
}

async function shiftClick({ page }: EditorPage, { x, y }: Point): Promise<void> {
  await page.keyboard.down("Shift");
  await page.mouse.click(x, y);
  await page.keyboard.up("Shift");
}

test("Shift and a click on the model takes a decal into the choice and out of it; all of them are dragged by any", async ({
  editor,
  page,
}) => {
  const { badge, number } = await openOnTwo(editor);
  await shiftClick(editor, await editor.pointOf(badge));
  await expect.poll(() => chosen(editor)).toEqual(["Number 07", "Travel badge"]);
  await expect(editor.view.locator(".tcv-beside"), "the other one is outlined, too").toHaveAttribute("d", /M/);

  const before = await editor.design();
  const places = await projectors(editor);
  const from = await editor.pointOf(number);
  await editor.drag(from, { x: from.x + 40, y: from.y + 30 }, 5);
  const way = await wayOf(editor, places);
  expect(way["Number 07"]?.[0]).toBeGreaterThan(0.02);
  expect(way["Travel badge"]).toEqual(way["Number 07"]);
  expect(await chosen(editor), "a drag leaves the choice").toEqual(["Number 07", "Travel badge"]);
  await page.keyboard.press("Control+z");
  expect(await editor.design(), "one step").toEqual(before);

  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 40, from.y, { steps: 3 });
  await page.keyboard.press("Escape");
  await page.mouse.up();
  expect(await editor.design(), "given up").toEqual(before);

  await shiftClick(editor, await editor.pointOf(badge));
  await expect.poll(() => chosen(editor)).toEqual(["Number 07"]);
  await shiftClick(editor, await editor.pointOf(badge));
  const beside = await editor.pointOf(number);
  await page.mouse.click(beside.x, beside.y);
  await expect.poll(() => chosen(editor), "a click alone chooses the one").toEqual(["Number 07"]);
});

test("keys move, turn, size and fade all chosen decals, each as one step; a locked one stays", async ({
  editor,
  page,
}) => {
  const { number } = await openOnTwo(editor);
  await page.keyboard.press("Control+a");
  await editor.view.focus();
  const before = await editor.design();
  const places = await projectors(editor);
  await page.keyboard.press("Shift+ArrowRight");
  const way = await wayOf(editor, places);
  expect(way["Number 07"]?.[0]).toBeGreaterThan(0.005);
  expect(way["Travel badge"]).toEqual(way["Number 07"]);
  await page.keyboard.press("Control+z");
  expect(await editor.design()).toEqual(before);

  await page.keyboard.press("+");
  await page.keyboard.press("]");
  await page.keyboard.press("4");
  const sized = await projectors(editor);
  for (const [name, { size, rotation }] of Object.entries(places)) {
    expect(sized[name]?.size[0]).toBeCloseTo(size[0] * 1.01);
    expect(sized[name]?.rotation).not.toEqual(rotation);
  }
  expect((await editor.design()).layers.map(({ opacity }) => opacity)).toEqual([0.4, 0.4]);
  await page.keyboard.press("0");
  expect((await editor.design()).layers.map(({ opacity }) => opacity)).toEqual([1, 1]);

  await editor.select(number);
  await page.locator("tc-layer-list .row.primary [data-action=locked]").click();
  await page.keyboard.press("Control+a");
  await editor.view.focus();
  const held = await projectors(editor);
  await page.keyboard.press("ArrowRight");
  const went = await wayOf(editor, held);
  expect(went["Number 07"]).toEqual([0, 0, 0]);
  expect(went["Travel badge"]?.[0]).toBeGreaterThan(0);
  await expect(editor.notices).toContainText("is locked");
});

test("a chosen group is moved whole, by keys and by any of its decals, and its menu is for all of it", async ({
  editor,
  page,
}) => {
  const { badge } = await openOnTwo(editor);
  const from = await editor.pointOf(badge);
  await page.keyboard.press("Control+a");
  await page.keyboard.press("Control+g");
  await expect.poll(() => chosen(editor)).toEqual(["Group"]);
  await editor.view.focus();
  const places = await projectors(editor);
  await page.keyboard.press("Shift+ArrowUp");
  const nudged = await wayOf(editor, places);
  expect(nudged["Number 07"]?.[1]).toBeGreaterThan(0.005);
  expect(nudged["Travel badge"]).toEqual(nudged["Number 07"]);
  await page.keyboard.press("Control+z");

  await editor.drag(from, { x: from.x + 40, y: from.y + 20 }, 5);
  const dragged = await wayOf(editor, places);
  expect(dragged["Travel badge"]?.[0]).toBeGreaterThan(0.02);
  expect(dragged["Number 07"]).toEqual(dragged["Travel badge"]);
  expect(await chosen(editor)).toEqual(["Group"]);

  const [group] = (await editor.design()).layers as GroupLayer[];
  await page.mouse.click(from.x + 40, from.y + 20, { button: "right" });
  await page.locator("tc-model-menu [role=menu]").getByRole("menuitem", { name: "Ungroup" }).click();
  await expect.poll(async () => (await editor.design()).layers).toEqual(group?.layers);
});
