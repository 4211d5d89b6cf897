import { type EditorPage, expect, test } from "./support/editor-page.ts";
import { squareGlb, squareGltf } from "./support/test-files.ts";

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

test("a group's mask goes with the group by pointer, handles and keys, and stays while a part of it is moved", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const badge = await editor.addDemoDecal("badge");
  const at = await editor.pointOf(badge);
  await editor.drag(at, { x: at.x - 90, y: at.y - 60 }, 4);
  const from = await editor.pointOf(badge);
  await editor.addDemoDecal("number");
  await page.keyboard.press("Control+a");
  await page.keyboard.press("Control+g");
  await page.locator("tc-layer-list .more button").first().click();
  await page.getByRole("menuitem", { name: "Add mask that shows all" }).click();
  await page.getByRole("radio", { name: "Eraser" }).click();
  await editor.drag({ x: from.x - 20, y: from.y - 10 }, { x: from.x + 10, y: from.y - 10 }, 4);
  await page.keyboard.press("v");
  await expect(page.getByRole("button", { name: "Moves with the layer" })).toHaveAttribute("aria-pressed", "true");

  /** Where the dab is on the badge, in parts of its width, and how the dab is turned there, degrees. */
  const held = async (): Promise<{ badge: readonly number[]; onBadge: readonly number[] }> => {
    const [group] = (await editor.design()).layers;
    const stroke = group?.mask?.layers[0];
    const dab = stroke?.type === "stroke" ? stroke.dabs[0] : undefined;
    const picture = group?.type === "group" ? group.layers[0] : undefined;
    if (picture?.type !== "decal" || picture.projector.kind !== "planar" || dab?.kind !== "planar") {
      throw new Error("The group or its mask is no more.");
    }
    const { position, rotation, size } = picture.projector;
    const spin = (each: readonly number[]): number => 2 * Math.atan2(each[2] ?? 0, each[3] ?? 1);
    const angle = -spin(rotation);
    const [x, y] = [0, 1].map((axis) => (dab.position[axis] ?? 0) - (position[axis] ?? 0)) as [number, number];
    const along = (x * Math.cos(angle) - y * Math.sin(angle)) / size[0];
    const up = (x * Math.sin(angle) + y * Math.cos(angle)) / size[0];
    return { badge: [...position, ...rotation, ...size], onBadge: [along, up, Math.sin(spin(dab.rotation) + angle)] };
  };
  const start = await held();
  const hashes = [await editor.settledHash()];
  const same = start.onBadge.map((part) => expect.closeTo(part, 4));
  const moved = async (why: string): Promise<void> => {
    const now = await held();
    expect(now.badge, why).not.toEqual(start.badge);
    expect(now.onBadge, why).toEqual(same);
    hashes.push(await editor.settledHash());
  };
  await editor.drag(from, { x: from.x + 50, y: from.y + 30 }, 4, async () => {
    expect((await held()).onBadge, "while it is dragged").toEqual(same);
  });
  await moved("dragged");
  await editor.view.focus();
  await page.keyboard.press("Shift+ArrowUp");
  await moved("by a key");
  await page.keyboard.press("Shift+BracketLeft");
  await moved("turned by a key");
  const corner = await editor.handle("se");
  await editor.drag(corner, { x: corner.x - 20, y: corner.y - 20 }, 4);
  await moved("sized by a handle");
  for (const hash of hashes.slice(0, -1).toReversed()) {
    await page.keyboard.press("Control+z");
    await expect.poll(() => editor.settledHash()).toBe(hash);
  }
  expect(await held()).toEqual(start);

  await editor.select(badge);
  await editor.view.focus();
  await page.keyboard.press("Shift+ArrowUp");
  const alone = await held();
  expect(alone.badge).not.toEqual(start.badge);
  expect(alone.onBadge, "a part of the group moves behind the mask").not.toEqual(same);
});

test("what the brush has painted on a stamp's mask goes with the stamp over the surface", async ({ editor, page }) => {
  const badge = await maskedBadge(editor);
  await page.locator("#projection input[value=uv]").evaluate((input: HTMLInputElement) => input.click());
  const places = async (): Promise<{ center: readonly number[]; dab: readonly number[] }> => {
    const { projector, mask } = await editor.decal(badge);
    const stroke = mask?.layers[0];
    const dab = stroke?.type === "stroke" ? stroke.dabs[0] : undefined;
    if (projector.kind !== "uv" || dab?.kind !== "planar") throw new Error("The badge is no stamp with a mask.");
    return { center: projector.center, dab: dab.position };
  };
  const start = await places();
  const hash = await editor.settledHash();
  const way = async (): Promise<number> => ((await places()).dab[0] ?? 0) - (start.dab[0] ?? 0);
  await editor.setField("centre-u", `${(start.center[0] ?? 0) + 0.1}`);
  const once = await way();
  expect(once).not.toBeCloseTo(0, 3);
  await editor.setField("centre-u", `${(start.center[0] ?? 0) - 0.2}`);
  expect(await way(), "as far as the texture goes").toBeCloseTo(-2 * once, 5);
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await expect.poll(() => editor.settledHash()).toBe(hash);
  expect(await places()).toEqual(start);
});

test("what the pencil has drawn on a mask stays, and that is said beside the mask and once it is moved", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openModel(squareGltf());
  const badge = await editor.addDemoDecal("badge");
  await page.locator("tc-layer-list .more button").first().click();
  await page.getByRole("menuitem", { name: "Add mask that shows all" }).click();
  const stays = page.getByText("lie in the texture, and stay there");
  await expect(stays).toHaveCount(0);
  await page.keyboard.press("n");
  const from = await editor.pointOf(badge);
  await editor.drag({ x: from.x - 15, y: from.y + 8 }, { x: from.x + 15, y: from.y + 8 }, 4);
  await expect(stays).toBeVisible();
  await page.keyboard.press("v");
  await editor.drag(from, { x: from.x + 40, y: from.y + 20 }, 4);
  await expect(editor.notices).toContainText("A part of the mask of Travel badge stays");
  await editor.view.focus();
  await page.keyboard.press("ArrowLeft");
  await expect(editor.notices).toHaveCount(0);
});
