import type { PlanarProjector } from "../../web/editor/document/index.ts";
import { expect, test } from "./support/editor-page.ts";

test("a new picture lies whole on the avatar's shirt, not across its belt, and a smaller one on a detail that was come near to", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openTemplate("avatar");
  const boxOf = async (id: string) => {
    const { projector } = await editor.decal(id);
    if (projector.kind !== "planar") throw new Error("A picture is thrown as a box.");
    return projector;
  };
  const shirt = await boxOf(await editor.addDemoDecal("smiley"));
  // Metres: the belt's upper edge, and half of the torso's breadth.
  expect(shirt.position[1] - shirt.size[1] / 2).toBeGreaterThan(0.9);
  expect(Math.abs(shirt.position[0]) + shirt.size[0] / 2).toBeLessThan(0.25);
  expect(shirt.size[0]).toBeGreaterThan(0.25);

  await page.keyboard.press("Escape");
  const { x, y } = await editor.middleOfStage();
  await page.mouse.move(x, y);
  for (let step = 0; step < 12; step += 1) await page.mouse.wheel(0, -240);
  await editor.idle();
  const near = await boxOf(await editor.addDemoDecal("smiley"));
  expect(near.size[0]).toBeLessThan(shirt.size[0] / 2);
});

test("a second picture lies beside the first, on the mug, also while a brush is in the hand", async ({
  editor,
  page,
}) => {
  await editor.open();
  const added = async () => {
    const { projector } = await editor.decal(await editor.addDemoDecal("smiley"));
    if (projector.kind !== "planar") throw new Error("A picture is thrown as a box.");
    return projector;
  };
  const all = [await added()];
  for (const key of ["v", "b"]) {
    await page.keyboard.press(key);
    const next = await added();
    for (const { position, size } of all) {
      const gaps = [0, 1, 2].map((axis) => Math.abs(next.position[axis as 0] - position[axis as 0]));
      // Metres; on what is round, a corner may lie under the other's.
      expect(Math.hypot(...gaps)).toBeGreaterThan((0.8 * (size[0] + next.size[0])) / 2);
    }
    all.push(next);
  }
});

test("so does a customer's on a product without print zones, unless the shop says how wide it is", async ({ page }) => {
  await page.goto("element.html?mode=shop&loading=eager&locale=en&src=demo/avatar.glb&size=64");
  const added = (options: { width?: number }) =>
    page
      .locator("texelcast-editor")
      .evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"], options: { width?: number }) => {
        await element.start();
        const id = await element.addDecal("demo/decals/smiley.png", options);
        const { design } = await element.exportDesign();
        return (design.layers.find((layer) => layer.id === id) as { projector: PlanarProjector }).projector;
      }, options);
  const { position, size } = await added({});
  expect(position[1] - size[1] / 2).toBeGreaterThan(0.9);
  expect(Math.abs(position[0]) + size[0] / 2).toBeLessThan(0.25);
  expect((await added({ width: 0.1 })).size[0]).toBe(0.1);
});

test("a picture and words that a customer adds lie side by side, and words on a picture that covers the product as its background", async ({
  page,
}) => {
  const boxes = async (width?: number) => {
    await page.goto("element.html?mode=shop&loading=eager&locale=en&src=demo/mug.glb&size=64");
    const options = width === undefined ? {} : { width };
    return page
      .locator("texelcast-editor")
      .evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"], options: { width?: number }) => {
        await element.start();
        const ids = [await element.addDecal("demo/decals/smiley.png", options), await element.addText("Anna")];
        const { design } = await element.exportDesign();
        const projectorOf = (id: string) => design.layers.find((layer) => layer.id === id);
        return ids.map((id) => (projectorOf(id) as { projector: PlanarProjector }).projector);
      }, options);
  };
  const apart = ([one, other]: PlanarProjector[], axis: 0 | 1): number =>
    one && other ? Math.abs(one.position[axis] - other.position[axis]) - (one.size[axis] + other.size[axis]) / 2 : 0;
  const beside = await boxes();
  expect(Math.max(apart(beside, 0), apart(beside, 1))).toBeGreaterThan(-0.002);
  const onto = await boxes(0.09);
  expect(apart(onto, 0)).toBeLessThan(-0.02);
  expect(apart(onto, 1)).toBeLessThan(-0.005);
  expect(onto[1]?.position.map((value) => value.toFixed(2))).toEqual(
    onto[0]?.position.map((value) => value.toFixed(2)),
  );
});
