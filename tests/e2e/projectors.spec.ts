import { type EditorPage, expect, test } from "./support/editor-page.ts";
import { file, ringPicture } from "./support/test-files.ts";

/** On the demo's mug: a slide from the front, a label round it, a stamp in its texture. */
const DESIGN = {
  format: "texelcast-design",
  version: 1,
  assets: { ring: { type: "image/png", uri: "pictures/ring.png" } },
  layers: [
    {
      id: "stamp",
      name: "Stamp",
      type: "decal",
      asset: "ring",
      projector: { kind: "uv", center: [0.5, 0.5], size: [0.2, 0.2], angle: 15 },
    },
    {
      id: "label",
      name: "Label",
      type: "decal",
      asset: "ring",
      wrap: "repeat",
      projector: {
        kind: "cylindrical",
        position: [0, 0.05, 0],
        rotation: [0, 0, 0, 1],
        radius: 0.041,
        height: 0.03,
        arc: 120,
        depth: 0.004,
      },
    },
    {
      id: "slide",
      name: "Slide",
      type: "decal",
      asset: "ring",
      projector: {
        kind: "perspective",
        position: [0, 0.08, 0.3],
        rotation: [0, 0, 0, 1],
        fov: 5,
        aspect: 1,
        near: 0.1,
        far: 1,
      },
    },
  ],
};

const designFile = file("three.design.json", JSON.stringify(DESIGN), "application/json");

/** The design on the mug, with its label selected. */
async function openLabel(editor: EditorPage): Promise<void> {
  await editor.open();
  await editor.openDesign([designFile, ringPicture()]);
  await editor.select("label");
}

test("a design with slides, labels and stamps opens, each is painted, selected and edited by its numbers", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.removeAllDecals();
  const bare = await editor.settledHash();
  await editor.openDesign([designFile, ringPicture()]);
  const whole = await editor.settledHash();
  expect(whole).not.toBe(bare);
  const hashes = new Set([bare, whole]);
  for (const [name, field, value] of [
    ["Slide", "field-of-view", "8"],
    ["Label", "arc", "200"],
    ["Label", "position-y", "60"],
    ["Stamp", "angle", "40"],
    ["Stamp", "size-u", "0.3"],
  ] as const) {
    await editor.row(name).getByText(name, { exact: true }).click();
    await expect(page.locator("tc-layer-properties #name")).toHaveValue(name);
    await editor.setField(field, value);
    const hash = await editor.settledHash();
    expect(hashes.has(hash), `${name} ${field}`).toBe(false);
    hashes.add(hash);
  }
  const numbers = (await editor.design()).layers.map((layer) => (layer.type === "decal" ? layer.projector : null));
  expect(numbers).toMatchObject([{ angle: 40, size: [0.3, 0.2] }, { arc: 200, position: [0, 0.06, 0] }, { fov: 8 }]);
  for (let step = 0; step < 5; step += 1) await page.locator("#undo").click();
  expect(await editor.settledHash()).toBe(whole);
});

test("a label is dragged round its mug and stays on its axis; its lines and handles are shown", async ({
  editor,
  page,
}) => {
  await openLabel(editor);
  await page.evaluate(() => document.querySelector<HTMLElement>("tc-app")?.focus());
  const start = await editor.settledHash();
  const middle = await page.evaluate(() => window.texelcast.project(0, 0.05, 0.041) ?? null);
  if (!middle) throw new Error("The label is not in view.");
  await page.mouse.move(middle.x, middle.y);
  await expect(page.locator(".tcv-overlay .tcv-outline").first()).toHaveAttribute("d", /M/);
  await expect(page.locator(".tcv-overlay .tcv-box").first()).toHaveAttribute("d", /M/);
  await expect(editor.view.locator(".tcv-overlay [data-handle=e]")).toBeVisible();
  await editor.drag(middle, { x: middle.x + 60, y: middle.y - 30 }, 6);
  const { projector } = await editor.decal("label");
  if (projector.kind !== "cylindrical") throw new Error("The label is none any more.");
  expect(projector.position[0]).toBeCloseTo(0, 9);
  expect(projector.position[2]).toBeCloseTo(0, 9);
  expect(projector.position[1], "up, as the pointer").toBeGreaterThan(0.052);
  expect(projector.rotation[1], "to the right").toBeGreaterThan(0.05);
  expect(await editor.settledHash()).not.toBe(start);
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(start);
});

test("a label that is pushed over the rim is told to lie beside the model, until it is back", async ({
  editor,
  page,
}) => {
  await openLabel(editor);
  const told = editor.notices.getByText("Label lies beside the model");
  await editor.setField("position-y", "150");
  await expect(told).toBeVisible();
  await editor.view.focus();
  await page.keyboard.press("ArrowUp");
  await expect(told, "it goes on to lie there").toBeVisible();
  for (let step = 0; step < 2; step++) await page.keyboard.press("Control+z");
  await expect(told).toHaveCount(0);
  await editor.setField("position-y", "92");
  await expect(told, "half of it is seen").toHaveCount(0);
});

test("keys nudge, turn and duplicate what is no box", async ({ editor, page }) => {
  await editor.open();
  await editor.openDesign([designFile, ringPicture()]);
  await page.locator("tc-stage").hover();
  for (const id of ["slide", "label", "stamp"]) {
    await editor.select(id);
    const before = (await editor.decal(id)).projector;
    await page.keyboard.press("Shift+ArrowRight");
    const moved = (await editor.decal(id)).projector;
    expect(moved, id).not.toEqual(before);
    await page.keyboard.press("Control+d");
    await expect.poll(async () => (await editor.design()).layers.length).toBe(4);
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+z");
    expect((await editor.decal(id)).projector).toEqual(before);
  }
});

test("a box is what it was after other kinds were tried on it, and follows what was moved meanwhile", async ({
  editor,
  page,
}) => {
  const id = await editor.openOnLowest();
  const before = await editor.decal(id);
  const hash = await editor.settledHash();
  const choose = (kind: string): Promise<void> =>
    page.locator(`#projection input[value=${kind}]`).evaluate((input: HTMLInputElement) => input.click());
  for (const kind of ["cylindrical", "uv", "cylindrical", "planar"]) {
    await choose(kind);
    await expect.poll(async () => (await editor.decal(id)).projector.kind).toBe(kind);
  }
  expect(await editor.decal(id)).toEqual(before);
  expect(await editor.settledHash()).toBe(hash);
  await choose("cylindrical");
  await expect.poll(async () => (await editor.decal(id)).projector.kind).toBe("cylindrical");
  await editor.setField("position-y", "70");
  await choose("planar");
  await expect.poll(async () => (await editor.decal(id)).projector.kind).toBe("planar");
  const { projector } = await editor.decal(id);
  expect(projector.kind === "planar" && projector.position[1]).toBeCloseTo(0.07, 2);
});

test("what the camera sees is stuck onto the model, scaled by a corner, and taken from the view again", async ({
  editor,
  page,
}) => {
  const id = await editor.openOnLowest();
  const box = await editor.settledHash();
  const covered = await page.locator(".tcv-overlay .tcv-outline").first().boundingBox();
  await page.locator("tc-stage").hover();
  await page.keyboard.press("Alt+p");
  await expect.poll(async () => (await editor.decal(id)).projector.kind).toBe("perspective");
  const thrown = await editor.settledHash();
  expect(thrown).not.toBe(box);
  const now = await page.locator(".tcv-overlay .tcv-outline").first().boundingBox();
  expect(Math.abs((now?.x ?? 0) - (covered?.x ?? 0)), "left where it was seen").toBeLessThan(12);
  expect(Math.abs((now?.width ?? 0) - (covered?.width ?? 0)), "as wide as it was seen").toBeLessThan(24);

  const corner = await editor.handle("ne");
  await editor.drag(corner, { x: corner.x - 30, y: corner.y + 30 }, 6);
  const { projector } = await editor.decal(id);
  if (projector.kind !== "perspective") throw new Error("It is projected from the view no more.");
  const eye = projector.position;
  expect(await editor.settledHash()).not.toBe(thrown);

  await page.evaluate(() => document.querySelector<HTMLElement>("tc-app")?.focus());
  const { x, y } = await page
    .locator("tc-stage .tcv-root, .tcv-root")
    .first()
    .boundingBox()
    .then((area) => area ?? { x: 0, y: 0 });
  await editor.drag({ x: x + 60, y: y + 500 }, { x: x + 110, y: y + 500 }, 5);
  await page.locator("tc-layer-properties #view-again").click();
  await expect.poll(async () => JSON.stringify((await editor.decal(id)).projector)).not.toContain(JSON.stringify(eye));
  await page.locator("#undo").click();
  await page.locator("#undo").click();
  await page.locator("#undo").click();
  expect(await editor.settledHash()).toBe(box);
});

test("a decal is wrapped around the mug, its arc pulled by a handle, and made a box again", async ({
  editor,
  page,
}) => {
  const id = await editor.openOnLowest();
  const before = (await editor.decal(id)).projector;
  await page.locator("tc-layer-properties input[value=cylindrical]").check({ force: true });
  const wrapped = (await editor.decal(id)).projector;
  if (wrapped.kind !== "cylindrical" || before.kind !== "planar") throw new Error("It is not wrapped around.");
  // The demo's mug stands upright on the origin and is 41 mm in radius.
  expect(wrapped.radius).toBeCloseTo(0.041, 3);
  expect(Math.hypot(wrapped.position[0], wrapped.position[2])).toBeLessThan(0.001);
  expect((wrapped.radius * wrapped.arc * Math.PI) / 180).toBeCloseTo(before.size[0], 4);

  const end = await editor.handle("e");
  await editor.drag(end, { x: end.x + 40, y: end.y }, 6);
  const pulled = (await editor.decal(id)).projector;
  expect(pulled.kind === "cylindrical" && pulled.arc).toBeGreaterThan(wrapped.arc + 3);
  await page.locator("tc-layer-properties input[value=planar]").check({ force: true });
  const box = (await editor.decal(id)).projector;
  expect(box.kind === "planar" && box.size[1]).toBeCloseTo(before.size[1], 3);
});
