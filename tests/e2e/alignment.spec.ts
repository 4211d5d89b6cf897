/** What is dragged comes into line with what is near, and says so by lines. */
import type { PlanarProjector, UvProjector } from "../../web/editor/document/index.ts";
import { type EditorPage, expect, type Point, test } from "./support/editor-page.ts";
import { squareGlb } from "./support/test-files.ts";

/** On the square: the badge aside of its middle, the number in it. */
async function openOnTwo(editor: EditorPage): Promise<{ badge: string; number: string }> {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const badge = await editor.addDemoDecal("badge");
  const at = await editor.pointOf(badge);
  await editor.drag(at, { x: at.x - 90, y: at.y - 60 }, 4);
  const number = await editor.addDemoDecal("number");
  return { badge, number };
}

async function positionOf(editor: EditorPage, id: string): Promise<PlanarProjector["position"]> {
  return ((await editor.decal(id)).projector as PlanarProjector).position;
}

/** Lines that show what is in line, drawn over a view. */
const linesIn = (editor: EditorPage, view: "model" | "texture"): Promise<number> =>
  editor.page
    .locator(view === "model" ? ".tcv-root:not(.tcv-texture)" : ".tcv-texture")
    .locator(".tcv-alignment-line")
    .evaluate((line) => (line.getAttribute("d") ?? "").split("M").length - 1);

/** CSS pixels right of a decal, by which a place 140 under it is aside of the line that goes down from that: the view is no drawing. */
const BESIDE = 8;

const beside = ({ x, y }: Point, right: number, down: number): Point => ({ x: x + right, y: y + down });

test("a decal that is dragged nearly under another one comes exactly under it, and a line says so", async ({
  editor,
}) => {
  const { badge, number } = await openOnTwo(editor);
  const [over, from] = [await editor.pointOf(badge), await editor.pointOf(number)];
  const shown: number[] = [];
  await editor.drag(from, beside(over, BESIDE, 140), 6, async () => {
    await editor.idle();
    shown.push(await linesIn(editor, "model"));
  });
  expect(shown.at(-1)).toBe(1);
  expect(shown[2]).toBe(0);
  const [[x], [left]] = [await positionOf(editor, number), await positionOf(editor, badge)];
  expect(x).toBeCloseTo(left, 6);
  expect(await linesIn(editor, "model")).toBe(0);
  await editor.page.keyboard.press("Control+z");
  await editor.idle();
  expect(await editor.pointOf(number)).toEqual(from);
});

test("near to the model's middle it comes into that, both ways at once", async ({ editor }) => {
  await editor.open();
  await editor.openModel([squareGlb()]);
  const badge = await editor.addDemoDecal("badge");
  const middle = await editor.pointOf(badge);
  await editor.drag(middle, beside(middle, -80, 50), 4);
  await editor.drag(await editor.pointOf(badge), beside(middle, 3, -5), 4);
  const [x, y] = await positionOf(editor, badge);
  expect(x).toBeCloseTo(0, 6);
  expect(y).toBeCloseTo(0, 6);
});

test("Ctrl in a drag leaves it where the pointer has it, and so does the setting, which the browser keeps", async ({
  editor,
}) => {
  const { badge, number } = await openOnTwo(editor);
  const [left] = await positionOf(editor, badge);
  const [over, from] = [await editor.pointOf(badge), await editor.pointOf(number)];
  const goal = beside(over, BESIDE, 140);
  const aside = async (): Promise<number> => ((await positionOf(editor, number))[0] as number) - left;
  const { mouse, keyboard } = editor.page;
  await mouse.move(from.x, from.y);
  await mouse.down();
  await mouse.move(goal.x, goal.y, { steps: 6 });
  await editor.idle();
  expect(await aside()).toBeCloseTo(0, 6);
  await keyboard.down("Control");
  await mouse.move(goal.x, goal.y + 1);
  await editor.idle();
  expect(await aside()).toBeGreaterThan(1e-3);
  expect(await linesIn(editor, "model")).toBe(0);
  await keyboard.up("Control");
  await mouse.move(goal.x, goal.y);
  await mouse.up();
  await editor.idle();
  expect(await aside()).toBeCloseTo(0, 6);
  await keyboard.press("Control+z");
  await editor.idle();
  await keyboard.press("Shift+L");
  await editor.drag(from, goal, 6);
  expect(await aside()).toBeGreaterThan(1e-3);
  await editor.reload();
  await editor.page.locator("#view-menu").click();
  await expect(editor.page.locator("#aligns")).not.toBeChecked();
});

test("a key and a button slide a decal into the model's middle, as one step", async ({ editor }) => {
  const { badge } = await openOnTwo(editor);
  await editor.select(badge);
  const [left, height] = await positionOf(editor, badge);
  expect(left).toBeLessThan(-0.1);
  await editor.page.keyboard.press("Alt+m");
  await editor.idle();
  const [x, y] = await positionOf(editor, badge);
  expect(x).toBeCloseTo(0, 6);
  expect(y).toBeCloseTo(height, 6);
  await editor.page.keyboard.press("Control+z");
  await editor.idle();
  expect(await positionOf(editor, badge)).toEqual(expect.arrayContaining([left, height]));
  await editor.page.locator("#align-middle").click();
  await editor.idle();
  expect((await positionOf(editor, badge))[0]).toBeCloseTo(0, 6);
  await editor.page.getByRole("radio", { name: "Flat" }).check({ force: true });
  await expect(editor.page.locator("#align-middle")).toBeDisabled();
});

test("a decal that was laid flat says where its handles are while the texture is out of sight", async ({
  editor,
  page,
}) => {
  await editor.openOnLowest();
  const projection = page.getByRole("group", { name: "Projection" });
  await page.locator("#layout-model").click();
  await expect(projection).not.toContainText("Its handles");
  await page.getByRole("radio", { name: "Flat" }).check({ force: true });
  await expect(projection).toContainText("Its handles are in the texture.");
  await page.locator("#layout-both").click();
  await expect(projection).not.toContainText("Its handles");
  await editor.resize(390, 844);
  await page.locator("tc-bottom-sheet").getByText("Edit", { exact: true }).click();
  await expect(projection).toContainText("Its handles are in the texture.");
});

test("several that are chosen are brought under the selected one, or beside it, as one step", async ({ editor }) => {
  const { badge, number } = await openOnTwo(editor);
  const before = await positionOf(editor, badge);
  const stays = await positionOf(editor, number);
  await editor.row("Travel badge").click();
  await editor.row("Number 07").click({ modifiers: ["Control"] });
  await editor.page.locator("#align-column").click();
  await editor.idle();
  const [x, y] = await positionOf(editor, badge);
  expect(x).toBeCloseTo(stays[0], 6);
  expect(y).toBeCloseTo(before[1], 6);
  expect(await positionOf(editor, number)).toEqual(stays);
  await editor.page.keyboard.press("Control+z");
  await editor.idle();
  expect(await positionOf(editor, badge)).toEqual(before);
  await editor.page.locator("#align-row").click();
  await editor.idle();
  expect((await positionOf(editor, badge))[1]).toBeCloseTo(stays[1], 6);
});

test("three that are chosen are spread evenly between the outermost as one step, and a second time as none", async ({
  editor,
}) => {
  const { badge, number } = await openOnTwo(editor);
  const flower = await editor.addDemoDecal("flower");
  await editor.select(flower);
  for (let press = 0; press < 4; press += 1) await editor.page.keyboard.press("Shift+ArrowRight");
  await editor.idle();
  const rights = async (): Promise<number[]> =>
    (await Promise.all([badge, number, flower].map((id) => positionOf(editor, id)))).map(([x]) => x);
  const before = await rights();
  await editor.page.keyboard.press("Control+a");
  await editor.page.locator("#spread-across").click();
  await editor.idle();
  const [left, between, right] = await rights();
  expect([left, right]).toEqual([before[0], before[2]]);
  expect(between).not.toBeCloseTo(before[1] as number, 3);
  await editor.page.locator("#spread-across").click();
  await editor.idle();
  expect(await rights()).toEqual([left, between, right]);
  await editor.page.keyboard.press("Control+z");
  await editor.idle();
  expect(await rights()).toEqual(before);
});

test("a flat stamp comes into line in its texture with other stamps and with the texture itself", async ({
  editor,
}) => {
  const { badge, number } = await openOnTwo(editor);
  const texture = editor.page.locator(".tcv-texture");
  const box = (await texture.boundingBox()) as NonNullable<Awaited<ReturnType<typeof texture.boundingBox>>>;
  const stampOf = async (id: string): Promise<UvProjector> => (await editor.decal(id)).projector as UvProjector;
  for (const id of [badge, number]) {
    await editor.select(id);
    await editor.page.getByRole("radio", { name: "Flat" }).check({ force: true });
    await editor.idle();
  }
  const other = await stampOf(badge);
  const start = await stampOf(number);
  const side = Math.min(box.width, box.height) - 2 * 16;
  const at = ([u, v]: readonly [number, number]): Point => ({
    x: box.x + box.width / 2 + (u - 0.5) * side,
    y: box.y + box.height / 2 + (v - 0.5) * side,
  });
  const shown: number[] = [];
  await editor.drag(at(start.center), beside(at([other.center[0], 0.8]), 3, 0), 6, async () => {
    await editor.idle();
    shown.push(await linesIn(editor, "texture"));
  });
  expect(shown.at(-1)).toBeGreaterThan(0);
  expect(await linesIn(editor, "texture")).toBe(0);
  expect((await stampOf(number)).center[0]).toBeCloseTo(other.center[0], 9);
});
