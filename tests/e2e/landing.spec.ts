import type { Page } from "@playwright/test";
import type { PlanarProjector } from "../../web/editor/document/index.ts";
import { type EditorPage, expect, test } from "./support/editor-page.ts";

const SHOP = "element.html?mode=shop&loading=eager&locale=en&size=64";

async function boxOf(editor: EditorPage, id: string): Promise<PlanarProjector> {
  const { projector } = await editor.decal(id);
  if (projector.kind !== "planar") throw new Error("A picture is thrown as a box.");
  return projector;
}

/** The box of a demo picture that a customer adds, and of the words that follow, if any. */
async function boxesInShop(page: Page, options: { width?: number }, words: readonly string[] = []) {
  const added = { options, words };
  return page
    .locator("texelcast-editor")
    .evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"], { options, words }: typeof added) => {
      await element.start();
      const ids = [await element.addDecal("demo/decals/smiley.png", options)];
      for (const text of words) ids.push(await element.addText(text));
      const { design } = await element.exportDesign();
      const layerOf = (id: string) => design.layers.find((layer) => layer.id === id);
      return ids.map((id) => (layerOf(id) as { projector: PlanarProjector }).projector);
    }, added);
}

test("a new picture lies whole on the avatar's shirt, not across its belt, and a smaller one on a detail that was come near to", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openTemplate("avatar");
  const shirt = await boxOf(editor, await editor.addDemoDecal("smiley"));
  // Metres: the belt's upper edge, and half of the torso's breadth.
  expect(shirt.position[1] - shirt.size[1] / 2).toBeGreaterThan(0.9);
  expect(Math.abs(shirt.position[0]) + shirt.size[0] / 2).toBeLessThan(0.25);
  expect(shirt.size[0]).toBeGreaterThan(0.25);

  await page.keyboard.press("Escape");
  const { x, y } = await editor.middleOfStage();
  await page.mouse.move(x, y);
  for (let step = 0; step < 12; step += 1) await page.mouse.wheel(0, -240);
  await editor.idle();
  const near = await boxOf(editor, await editor.addDemoDecal("smiley"));
  expect(near.size[0]).toBeLessThan(shirt.size[0] / 2);
});

test("a second picture lies beside the first, on the mug, also while a brush is in the hand", async ({
  editor,
  page,
}) => {
  await editor.open();
  const all = [await boxOf(editor, await editor.addDemoDecal("smiley"))];
  for (const key of ["v", "b"]) {
    await page.keyboard.press(key);
    const next = await boxOf(editor, await editor.addDemoDecal("smiley"));
    for (const { position, size } of all) {
      const apart = Math.hypot(...position.map((value, axis) => value - (next.position[axis] ?? 0)));
      // Metres; on what is round, a corner may lie under the other's.
      expect(apart).toBeGreaterThan((0.8 * (size[0] + next.size[0])) / 2);
    }
    all.push(next);
  }
});

test("so does a customer's on a product without print zones, unless the shop says how wide it is", async ({ page }) => {
  await page.goto(`${SHOP}&src=demo/avatar.glb`);
  const [shirt] = await boxesInShop(page, {});
  if (!shirt) throw new Error("Nothing was added.");
  expect(shirt.position[1] - shirt.size[1] / 2).toBeGreaterThan(0.9);
  expect(Math.abs(shirt.position[0]) + shirt.size[0] / 2).toBeLessThan(0.25);
  expect((await boxesInShop(page, { width: 0.1 }))[0]?.size[0]).toBe(0.1);
});

test("a picture and words that a customer adds lie side by side, and words on a picture that covers the product as its background", async ({
  page,
}) => {
  const boxes = async (options: { width?: number }) => {
    await page.goto(`${SHOP}&src=demo/mug.glb`);
    return boxesInShop(page, options, ["Anna"]);
  };
  const apart = ([one, other]: PlanarProjector[], axis: 0 | 1): number =>
    one && other ? Math.abs(one.position[axis] - other.position[axis]) - (one.size[axis] + other.size[axis]) / 2 : 0;
  const beside = await boxes({});
  expect(Math.max(apart(beside, 0), apart(beside, 1))).toBeGreaterThan(-0.002);
  const onto = await boxes({ width: 0.09 });
  expect(apart(onto, 0)).toBeLessThan(-0.02);
  expect(apart(onto, 1)).toBeLessThan(-0.005);
  expect(onto[1]?.position.map((value) => value.toFixed(2))).toEqual(
    onto[0]?.position.map((value) => value.toFixed(2)),
  );
});
