import { type EditorPage, expect, test } from "./support/editor-page.ts";
import { squareGlb } from "./support/test-files.ts";

/** A badge on a square board, with a stroke of the eraser on its mask. */
async function maskedBadge(editor: EditorPage): Promise<string> {
  const { page } = editor;
  await editor.open();
  await editor.openModel([squareGlb()]);
  const badge = await editor.addDemoDecal("badge");
  await page.locator("tc-layer-list .more button").first().click();
  await page.getByRole("menuitem", { name: "Add mask that shows all" }).click();
  await page.getByRole("radio", { name: "Eraser" }).click();
  const { x, y } = await editor.pointOf(badge);
  await editor.drag({ x: x - 20, y: y - 10 }, { x: x + 10, y: y - 10 }, 4);
  await page.keyboard.press("v");
  return badge;
}

interface Places {
  readonly decal: readonly number[];
  readonly dab: readonly number[];
}

/** Where the badge is, and the first dab on its mask. */
async function placesOf(editor: EditorPage, id: string): Promise<Places> {
  const { projector, mask } = await editor.decal(id);
  const stroke = mask?.layers[0];
  const dab = stroke?.type === "stroke" ? stroke.dabs[0] : undefined;
  if (dab?.kind !== "planar" || projector.kind !== "planar") throw new Error("The badge or its mask is no more.");
  return { decal: projector.position, dab: dab.position };
}
const apart = ({ decal, dab }: Places): number[] =>
  dab.map((part, axis) => expect.closeTo(part - (decal[axis] ?? 0), 5) as unknown as number);
const way = ({ decal, dab }: Places): number[] => dab.map((part, axis) => part - (decal[axis] ?? 0));

test("a mask goes with its layer by pointer, keys and numbers, live and as one step each", async ({ editor, page }) => {
  const badge = await maskedBadge(editor);
  const start = await placesOf(editor, badge);
  const hashes = [await editor.settledHash()];
  const moved = async (why: string): Promise<void> => {
    const now = await placesOf(editor, badge);
    expect(now.decal, why).not.toEqual(start.decal);
    expect(way(now), why).toEqual(apart(start));
    hashes.push(await editor.settledHash());
  };
  const from = await editor.pointOf(badge);
  await editor.drag(from, { x: from.x + 60, y: from.y + 40 }, 4, async () => {
    const { decal, dab } = await placesOf(editor, badge);
    expect(way({ decal, dab }), "while it is dragged").toEqual(apart(start));
  });
  await moved("dragged");
  await page.keyboard.press("ArrowLeft");
  await moved("by a key");
  await editor.setField("position-y", "-12");
  await moved("by a number");

  await editor.setField("spin", "90");
  const [x, y] = way(start) as [number, number];
  expect(way(await placesOf(editor, badge)), "turned about the badge").toEqual([
    expect.closeTo(-y, 5),
    expect.closeTo(x, 5),
    expect.closeTo(0, 5),
  ]);
  for (const hash of hashes.toReversed()) {
    await page.keyboard.press("Control+z");
    await expect.poll(() => editor.settledHash()).toBe(hash);
  }
  expect(await placesOf(editor, badge)).toEqual(start);
});

test("a mask's link to its layer can be taken off, in its fields and in the menu, and is kept", async ({
  editor,
  page,
}) => {
  const badge = await maskedBadge(editor);
  const start = await placesOf(editor, badge);
  const link = page.getByRole("button", { name: "Moves with the layer" });
  await expect(link).toHaveAttribute("aria-pressed", "true");
  await link.focus();
  await page.keyboard.press("Enter");
  await expect(link).toHaveAttribute("aria-pressed", "false");
  await expect(link).toBeFocused();
  await editor.setField("position-x", "20");
  const unlinked = await placesOf(editor, badge);
  expect(unlinked.decal).not.toEqual(start.decal);
  expect(unlinked.dab).toEqual(start.dab);
  await page.evaluate(() => window.texelcast.kept());
  await editor.reload();
  await editor.select(badge);
  expect((await editor.decal(badge)).mask?.linked).toBe(false);

  await page.locator("tc-layer-list .more button").first().click();
  await page.getByRole("menuitem", { name: "Link mask to layer" }).click();
  await editor.setField("position-x", "-20");
  expect(way(await placesOf(editor, badge))).toEqual(apart(unlinked));
  await page.locator("tc-layer-list .more button").first().click();
  await expect(page.getByRole("menuitem", { name: "Unlink mask from layer" })).toBeVisible();
});
