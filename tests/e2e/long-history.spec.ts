/** A long session: many strokes, many steps back, and the memory that they take. */
import { expect, test } from "./support/editor-page.ts";

// A picture for each of a thousand moves would take most of the time.
test.use({ trace: "off" });

test("two hundred strokes and a hundred undos stay within the budgets of memory", async ({ editor, page }) => {
  // Two hundred strokes and two hundred steps through the history.
  test.slow();
  await editor.open();
  await editor.openTemplate("block-wide");
  await page.keyboard.press("b");
  const middle = await editor.middleOfStage();
  const hashes: string[] = [];
  for (let stroke = 0; stroke < 200; stroke += 1) {
    const angle = stroke * 2.4;
    const from = { x: middle.x + 25 * Math.cos(angle), y: middle.y + 60 * Math.sin(angle) };
    // Sent together, in order: a hand does not wait for the page either.
    await Promise.all([
      page.mouse.move(from.x, from.y),
      page.mouse.down(),
      page.mouse.move(from.x + 9, from.y + 6),
      page.mouse.move(from.x + 18, from.y + 2),
      page.mouse.up(),
    ]);
    if (stroke % 100 === 99) hashes.push(await editor.settledHash());
  }
  const painted = (await editor.design()).layers.find(({ type }) => type === "paint");
  expect(painted?.type === "paint" && painted.strokes.length).toBe(200);
  const travel = async (key: string): Promise<void> => {
    for (let step = 0; step < 100; step += 1) await page.keyboard.press(key);
  };
  await travel("ControlOrMeta+z");
  expect(await editor.settledHash()).toBe(hashes[0]);
  const { memoryPeakBytes, memoryBudgetBytes } = await editor.stats();
  expect(memoryPeakBytes).toBeLessThanOrEqual(memoryBudgetBytes);
  await travel("ControlOrMeta+Shift+z");
  expect(await editor.settledHash()).toBe(hashes[1]);
});
