/** Several decals, or a group of them, moved as one: by a drag of any, by the box round them, by keys; chosen on the model itself. */
import type { GroupLayer, PlanarProjector, UvProjector } from "../../web/editor/document/index.ts";
import { type EditorPage, expect, type Point, test } from "./support/editor-page.ts";
import { file, ringPicture, squareGlb } from "./support/test-files.ts";

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

/** From one decal to the other, on the square: how long, and (degrees) which way. */
function between({ "Travel badge": badge, "Number 07": number }: Record<string, PlanarProjector>) {
  const [across, up] = [0, 1].map((axis) => (number?.position[axis] ?? 0) - (badge?.position[axis] ?? 0));
  const way = (Math.atan2(up ?? 0, across ?? 0) * 180) / Math.PI;
  return { length: Math.hypot(across ?? 0, up ?? 0), way };
}

/** How a box on the square is turned, degrees. */
const spin = (projector?: PlanarProjector): number => {
  const [, , z, w] = projector?.rotation ?? [0, 0, 0, 1];
  return (Math.atan2(z, w) * 360) / Math.PI;
};

/** 0 to 360. */
const round = (degrees: number): number => ((degrees % 360) + 360) % 360;

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

test("the handles of the box round several turn and size all of them about their middle, as one step", async ({
  editor,
  page,
}) => {
  await openOnTwo(editor);
  await page.keyboard.press("Control+a");
  const before = await editor.design();
  const places = await projectors(editor);
  const start = between(places);

  const from = await editor.handle("rotate");
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 60, from.y + 60, { steps: 5 });
  await expect(editor.view).toHaveAttribute("data-gesture", "rotate");
  await page.keyboard.press("Escape");
  await page.mouse.up();
  expect(await editor.design(), "given up").toEqual(before);

  const again = await editor.handle("rotate");
  await editor.drag(again, { x: again.x + 50, y: again.y + 50 }, 5);
  const turned = await projectors(editor);
  const turn = round(spin(turned["Number 07"]) - spin(places["Number 07"]));
  expect(turn).toBeGreaterThan(300);
  expect(turn).toBeLessThan(350);
  expect(round(spin(turned["Travel badge"]) - spin(places["Travel badge"]))).toBeCloseTo(turn);
  expect(between(turned).length).toBeCloseTo(start.length);
  expect(round(between(turned).way - start.way)).toBeCloseTo(turn);
  expect(await chosen(editor)).toEqual(["Number 07", "Travel badge"]);

  const corner = await editor.handle("se");
  await editor.drag(corner, { x: corner.x - 20, y: corner.y - 20 }, 5);
  const sized = await projectors(editor);
  const factor = between(sized).length / start.length;
  expect(factor).not.toBeCloseTo(1, 2);
  for (const [name, { size }] of Object.entries(places)) expect(sized[name]?.size[0]).toBeCloseTo(size[0] * factor);

  await page.keyboard.press("Control+z");
  expect(await projectors(editor), "one step").toEqual(turned);
  await page.keyboard.press("Control+z");
  expect(await editor.design(), "one step").toEqual(before);
});

test("keys turn and size several, and a group, about their middle: all the way round is where they were", async ({
  editor,
  page,
}) => {
  await openOnTwo(editor);
  await page.keyboard.press("Control+a");
  await page.keyboard.press("Control+g");
  await expect(editor.view.locator(".tcv-beside"), "a group's decals are outlined").toHaveAttribute("d", /M.*M/);
  await expect(editor.view.locator("[data-handle=se]")).toBeVisible();
  await editor.view.focus();
  const places = await projectors(editor);
  const start = between(places);
  await editor.quickly(async () => {
    for (let step = 0; step < 9; step += 1) await page.keyboard.press("Shift+BracketLeft");
    await page.keyboard.press("+");
  });
  const turned = await projectors(editor);
  expect(round(between(turned).way - start.way)).toBeCloseTo(90);
  expect(between(turned).length).toBeCloseTo(start.length * 1.01);
  expect(round(spin(turned["Number 07"]) - spin(places["Number 07"]))).toBeCloseTo(90);
  await page.keyboard.press("Control+z");
  for (let step = 0; step < 27; step += 1) await page.keyboard.press("Shift+BracketLeft");
  const round360 = await projectors(editor);
  for (const [name, { position }] of Object.entries(places)) {
    for (const axis of [0, 1, 2] as const) expect(round360[name]?.position[axis]).toBeCloseTo(position[axis], 9);
  }
});

/** Two decals in front and behind the demo's mug, and two stamps in its texture. */
const decalAt = (name: string, projector: object): object => ({
  id: name,
  name,
  type: "decal",
  asset: "ring",
  projector,
});
const lyingApart = {
  format: "texelcast-design",
  version: 1,
  assets: { ring: { type: "image/png", uri: "pictures/ring.png" } },
  layers: [
    decalAt("Left", { kind: "uv", center: [0.3, 0.3], size: [0.1, 0.1], angle: 0 }),
    decalAt("Right", { kind: "uv", center: [0.6, 0.3], size: [0.1, 0.1], angle: 20 }),
    decalAt("Back", { kind: "planar", position: [0, 0.05, -0.04], rotation: [0, 1, 0, 0], size: [0.02, 0.02, 0.02] }),
    decalAt("Front", { kind: "planar", position: [0, 0.05, 0.04], rotation: [0, 0, 0, 1], size: [0.02, 0.02, 0.02] }),
  ],
};

test("what lies apart is turned where it lies; stamps go round their middle in the texture", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.openDesign([file("apart.design.json", JSON.stringify(lyingApart), "application/json"), ringPicture()]);
  await page.keyboard.press("Control+a");
  await editor.view.focus();
  await page.keyboard.press("Shift+BracketLeft");
  const { Front, Back } = await projectors(editor);
  expect(Front?.position).toEqual([0, 0.05, 0.04]);
  expect(Back?.position).toEqual([0, 0.05, -0.04]);
  expect(spin(Front)).toBeCloseTo(10);
  const stamps = async (): Promise<UvProjector[]> =>
    (await editor.design()).layers.slice(0, 2).map((layer) => (layer as { projector: UvProjector }).projector);
  const [left, right] = await stamps();
  expect([left?.angle, right?.angle]).toEqual([-10, 10]);
  const tilt = 0.15 * Math.sin(Math.PI / 18);
  expect([left?.center[1], right?.center[1]]).toEqual([expect.closeTo(0.3 + tilt), expect.closeTo(0.3 - tilt)]);

  const knob = await editor.handle("rotate");
  await editor.drag(knob, { x: knob.x + 40, y: knob.y + 30 }, 4);
  const now = await projectors(editor);
  expect(now.Front?.position).toEqual([0, 0.05, 0.04]);
  expect(now.Back?.position).toEqual([0, 0.05, -0.04]);
  expect(spin(now.Front)).toBeLessThan(-20);
  const behind = (projector?: PlanarProjector): number => {
    const [x, y] = projector?.rotation ?? [0, 1, 0, 0];
    return (Math.atan2(x, y) * 360) / Math.PI;
  };
  expect(behind(now.Back) - behind(Back)).toBeCloseTo(spin(now.Front) - spin(Front));

  const [place] = await editor.places(page.locator(".tcv-texture [data-handle=rotate] .tcv-mark"));
  const inTexture = { x: place.x + place.width / 2, y: place.y + place.height / 2 };
  const before = await stamps();
  await editor.drag(inTexture, { x: inTexture.x + 60, y: inTexture.y + 60 }, 4);
  const after = await stamps();
  const turn = (after[0]?.angle ?? 0) - (before[0]?.angle ?? 0);
  expect(turn).toBeGreaterThan(15);
  expect((after[1]?.angle ?? 0) - (before[1]?.angle ?? 0)).toBeCloseTo(turn);
  expect(after[0]?.center[1]).toBeLessThan((before[0]?.center[1] ?? 0) - 0.02);
  expect(await chosen(editor)).toHaveLength(4);
});

test("of several that are chosen each is dragged through what lies over it, and a click there chooses that", async ({
  editor,
  page,
}) => {
  const { badge, number } = await openOnTwo(editor);
  const at = await editor.pointOf(number);
  const over = await editor.addDemoDecal("flower");
  const from = await editor.pointOf(over);
  await editor.drag(from, at, 5);
  const order = (await editor.design()).layers.map(({ id }) => id);
  expect(order).toEqual([badge, number, over]);

  await editor.select(number);
  await shiftClick(editor, await editor.pointOf(badge));
  await expect.poll(() => chosen(editor)).toEqual(["Number 07", "Travel badge"]);
  const places = await projectors(editor);
  await editor.drag(at, { x: at.x + 40, y: at.y + 30 }, 5);
  const way = await wayOf(editor, places);
  expect(way["Number 07"]?.[0]).toBeGreaterThan(0.02);
  expect(way["Travel badge"]).toEqual(way["Number 07"]);
  expect(way.Flower).toEqual([0, 0, 0]);
  expect(await chosen(editor)).toEqual(["Number 07", "Travel badge"]);

  await shiftClick(editor, at);
  await expect.poll(() => chosen(editor), "Shift and a click adds what lies on top").toHaveLength(3);
  await shiftClick(editor, at);
  await expect.poll(() => chosen(editor), "and takes it out again").toEqual(["Number 07", "Travel badge"]);
  await page.mouse.click(at.x, at.y);
  await expect.poll(() => chosen(editor)).toEqual(["Flower"]);
});
