import { type EditorPage, expect, test } from "./support/editor-page.ts";
import { file, ringPicture } from "./support/test-files.ts";

/** On the front of the demo's mug: a line by a round brush, and rings by a picture. */
const DESIGN = {
  format: "texelcast-design",
  version: 1,
  assets: { ring: { type: "image/png", uri: "pictures/ring.png" } },
  layers: [
    {
      id: "line",
      name: "Line",
      type: "stroke",
      brush: { color: "#c02050", hardness: 0.5, flow: 0.5 },
      dabs: Array.from({ length: 20 }, (_, i) => dab(-0.02 + 0.002 * i, 0.04)),
    },
    {
      id: "rings",
      name: "Rings",
      type: "stroke",
      brush: { tip: "picture", asset: "ring" },
      dabs: [-0.02, 0, 0.02].map((x) => dab(x, 0.065)),
    },
  ],
};

function dab(x: number, y: number): object {
  return { kind: "planar", position: [x, y, 0.04], rotation: [0, 0, 0, 1], size: [0.012, 0.012, 0.03] };
}

test("a design of strokes opens, is painted and listed, and its strokes are edited and undone", async ({
  editor,
  page,
}) => {
  await editor.open();
  await editor.removeAllDecals();
  const bare = await editor.settledHash();
  await editor.openDesign([file("strokes.design.json", JSON.stringify(DESIGN), "application/json"), ringPicture()]);
  const whole = await editor.settledHash();
  const hashes = new Set([bare, whole]);
  expect(hashes.size).toBe(2);
  for (const name of ["Line", "Rings"]) {
    await editor.row(name).getByText(name, { exact: true }).click();
    await expect(page.locator("tc-layer-properties #name")).toHaveValue(name);
    await editor.setField("opacity", "40");
    const hash = await editor.settledHash();
    expect(hashes.has(hash), name).toBe(false);
    hashes.add(hash);
  }
  const { layers } = await editor.design();
  expect(layers).toMatchObject([
    { type: "stroke", opacity: 0.4, brush: { tip: "round", hardness: 0.5, flow: 0.5 } },
    { type: "stroke", opacity: 0.4, brush: { tip: "picture", color: null } },
  ]);
  expect(layers[0]?.type === "stroke" && layers[0].dabs).toHaveLength(20);
  for (let step = 0; step < 2; step += 1) await page.locator("#undo").click();
  expect(await editor.settledHash()).toBe(whole);
});

/** A stroke of the brush by 40 pixels from the middle of the view, whose button is still down. `before`: the hash without it. */
async function beginStroke(editor: EditorPage): Promise<{ before: string; x: number; y: number }> {
  const { keyboard, mouse } = editor.page;
  await editor.open();
  await keyboard.press("Escape");
  const before = await editor.settledHash();
  const { x, y } = await editor.middleOfStage();
  await keyboard.press("b");
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x + 40, y, { steps: 4 });
  return { before, x, y };
}

test("a tool that is chosen in the middle of a stroke ends it, and what was painted stays", async ({
  editor,
  page,
}) => {
  const { before, x, y } = await beginStroke(editor);
  await page.keyboard.press("e");
  await expect(page.locator("#tool-eraser")).toBeChecked();
  // The button is still down.
  await page.mouse.move(x + 40, y + 40, { steps: 4 });
  await page.mouse.up();
  const painted = await editor.settledHash();
  expect(painted).not.toBe(before);
  const paint = (await editor.design()).layers.filter(({ type }) => type === "paint");
  expect(paint).toMatchObject([{ strokes: [{ type: "stroke" }] }]);
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(before);
});

test("so it is with a pencil", async ({ editor, page }) => {
  await editor.open();
  await editor.openTemplate("block-wide");
  const before = await editor.settledHash();
  const { x, y } = await editor.middleOfStage();
  await page.keyboard.press("n");
  await page.mouse.move(x, y - 20);
  await page.mouse.down();
  await page.mouse.move(x + 12, y - 30, { steps: 4 });
  await page.keyboard.press("v");
  await page.mouse.up();
  expect(await editor.settledHash()).not.toBe(before);
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(before);
});

test("Delete in the middle of a stroke ends it first: the stroke, and the layer that goes with it, are two steps", async ({
  editor,
  page,
}) => {
  await editor.open();
  await page.keyboard.press("Escape");
  const { x, y } = await editor.middleOfStage();
  await page.keyboard.press("b");
  const stroke = async (dy: number, whileDown: () => Promise<void> = async () => {}) => {
    await page.mouse.move(x - 20, y + dy);
    await page.mouse.down();
    await page.mouse.move(x + 20, y + dy, { steps: 4 });
    await whileDown();
    // The button is still down.
    await page.mouse.move(x + 20, y + dy + 20, { steps: 4 });
    await page.mouse.up();
  };
  await stroke(-40);
  const first = await editor.settledHash();
  await stroke(0, () => page.keyboard.press("Delete"));
  await editor.idle();
  expect((await editor.design()).layers.filter(({ type }) => type === "paint")).toHaveLength(0);
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).not.toBe(first);
  const paint = (await editor.design()).layers.filter(({ type }) => type === "paint");
  expect(paint).toMatchObject([{ strokes: [{ type: "stroke" }, { type: "stroke" }] }]);
  await page.keyboard.press("Control+z");
  expect(await editor.settledHash()).toBe(first);
});

test("a redo in the middle of a stroke, which has nothing to bring back, keeps the stroke", async ({
  editor,
  page,
}) => {
  const { before } = await beginStroke(editor);
  await page.keyboard.press("Control+Shift+z");
  await page.mouse.up();
  expect(await editor.settledHash()).not.toBe(before);
});
