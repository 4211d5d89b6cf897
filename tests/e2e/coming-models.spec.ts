/** What is done while a model is still being read: it was asked for before, and what is drawn meanwhile is not lost. */
import type { Editor } from "../../web/editor/state/editor.ts";
import { buildModel, plane } from "../support/model-builder.ts";
import { glbWithVariants } from "../support/variant-model.ts";
import { type EditorPage, expect, test } from "./support/editor-page.ts";
import { demoFile, file, halfBareGlb, squareGlb } from "./support/test-files.ts";

const names = async (editor: EditorPage): Promise<string[]> => (await editor.design()).layers.map(({ name }) => name);
const model = (editor: EditorPage): Promise<string | undefined> =>
  editor.page.evaluate(
    () => (document.querySelector("tc-workbench") as unknown as { editor: Editor }).editor.store.state.model?.ref.title,
  );

test("an undo while a demo's model is on its way takes that back, and not the step before it", async ({
  editor,
  page,
}) => {
  await editor.openOnLowest();
  const [before, first] = [await names(editor), await model(editor)];
  await editor.action("duplicate").click();
  const duplicated = await names(editor);
  let release = (): void => {};
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route(/skateboard\.glb/, async (route) => {
    await held;
    await route.continue();
  });
  await page.locator("tc-top-bar .models button").first().click();
  await page.getByRole("menuitemradio", { name: "Skateboard" }).click();
  await page.keyboard.press("Control+z");
  release();
  await editor.idle();
  await expect.poll(() => model(editor)).toBe(first);
  expect(await names(editor)).toEqual(duplicated);
  await page.keyboard.press("Control+z");
  await expect.poll(() => names(editor)).toEqual(before);
  for (let step = 0; step < 2; step += 1) await page.keyboard.press("Control+Shift+z");
  await expect.poll(() => model(editor)).toBe("Skateboard");
});

test("undos that follow a dropped model at once take that and the step before it back", async ({ editor, page }) => {
  await editor.openOnLowest();
  const [before, first] = [await names(editor), await model(editor)];
  await editor.action("duplicate").click();
  const glb = demoFile("skateboard.glb").buffer.toString("base64");
  await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([bytes], "board.glb"));
    const init = { dataTransfer, clientX: 240, clientY: 450, bubbles: true, cancelable: true, composed: true };
    document.elementFromPoint(240, 450)?.dispatchEvent(new DragEvent("drop", init));
    await new Promise((resolve) => setTimeout(resolve, 0));
    for (let step = 0; step < 2; step += 1) {
      dispatchEvent(new KeyboardEvent("keydown", { key: "z", code: "KeyZ", ctrlKey: true }));
    }
  }, glb);
  await editor.idle();
  await expect.poll(() => model(editor)).toBe(first);
  await expect.poll(() => names(editor)).toEqual(before);
  for (let step = 0; step < 2; step += 1) await page.keyboard.press("Control+Shift+z");
  await expect.poll(() => model(editor)).toBe("board.glb");
});

/** Begins something that opens a model, and duplicates the chosen layer as soon as that is being read. */
const duplicateDuring = (editor: EditorPage, begin: (of: Editor) => Promise<void>): Promise<void> =>
  editor.page.evaluate(`(async () => {
    const { editor } = document.querySelector("tc-workbench");
    const done = (${begin})(editor);
    const isReading = ({ tasks }) => tasks.some(({ label }) => /^Opening/.test(label));
    if (!isReading(editor.store.state)) {
      await new Promise((resolve) => {
        const stop = editor.store.subscribe(() => {
          if (isReading(editor.store.state)) resolve(stop);
        });
      });
    }
    editor.layers.duplicate();
    await done;
  })()`);

test("a step forth to a model whose reading something is done in arrives at that model, and what was done can be gone back to", async ({
  editor,
}) => {
  const id = await editor.openOnLowest();
  const before = await names(editor);
  await editor.openModel([squareGlb()]);
  await editor.addLayer(/^Fill/);
  for (let step = 0; step < 2; step += 1) await editor.page.keyboard.press("Control+z");
  await editor.idle();
  await editor.select(id);
  await duplicateDuring(editor, ({ files }) => files.travel("redo"));
  await editor.idle();
  expect(await model(editor)).toBe("square.glb");
  expect(await names(editor)).toEqual([]);
  await editor.page.keyboard.press("Control+z");
  await expect.poll(() => model(editor)).toBe("Mug");
  expect(await names(editor)).toHaveLength(before.length + 1);
});

test("what is done while a model's other variant is being read is on that, too", async ({ editor }) => {
  await editor.open();
  const materials = ["Red", "Green"].map((name) => ({ name }));
  const parts = buildModel({ meshes: [plane(1, 0)], materials });
  const glb = glbWithVariants(parts, ["Meadow"], [[{ material: 1, variants: [0] }]]);
  await editor.openModel([file("square.glb", glb)]);
  const id = await editor.addDemoDecal("flower");
  await editor.select(id);
  await duplicateDuring(editor, ({ variants }) => variants?.show(0) ?? Promise.resolve());
  await editor.idle();
  const { layers } = await editor.design();
  expect(layers.map((layer) => "material" in layer && layer.material)).toEqual([1, 1]);
});

test("what is done while the unwrapped model is being read is on that, too", async ({ editor }) => {
  await editor.open();
  await editor.openModel([halfBareGlb()]);
  const id = await editor.addDemoDecal("flower");
  await editor.select(id);
  await duplicateDuring(editor, ({ unwrapping }) => unwrapping?.run() ?? Promise.resolve());
  await editor.idle();
  expect((await editor.design()).layers).toHaveLength(2);
});
