import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { DrawingTask } from "../../web/editor/state/drawing-task.ts";
import { INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { Store } from "../../web/editor/state/store.ts";
import { Tasks } from "../../web/editor/state/tasks.ts";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** An engine that has drawn all when it is told so, and what the page shows of it. */
function drawing() {
  const store = new Store(INITIAL_STATE);
  const asked: { readonly drawn: () => void; readonly fail: () => void }[] = [];
  const idle = (): Promise<void> =>
    new Promise((resolve, reject) => asked.push({ drawn: resolve, fail: () => reject(new Error("not drawn")) }));
  const task = new DrawingTask({ engine: { idle }, tasks: new Tasks(store), label: () => "Painting" });
  const shown = (): string[] => store.state.tasks.filter(({ visible }) => visible).map(({ label }) => label);
  const end = async (how: "drawn" | "fail" = "drawn"): Promise<void> => {
    asked.at(-1)?.[how]();
    await vi.advanceTimersByTimeAsync(0);
  };
  return { task, asked, shown, end };
}

test.each(["drawn", "fail"] as const)(
  "layers that take long are shown as work under way until it has ended (%s)",
  async (how) => {
    const { task, shown, end } = drawing();
    task.follow();
    await vi.advanceTimersByTimeAsync(500);
    expect(shown()).toEqual([]);
    await vi.advanceTimersByTimeAsync(2000);
    expect(shown()).toEqual(["Painting"]);
    await end(how);
    expect(shown()).toEqual([]);
  },
);

test("quick steps in a row are never shown, however long they go on", async () => {
  const { task, asked, shown, end } = drawing();
  for (let step = 0; step < 20; step++) {
    task.follow();
    await vi.advanceTimersByTimeAsync(400);
    task.follow();
    expect(shown()).toEqual([]);
    await end();
  }
  expect(asked.length).toBeGreaterThan(20);
});

test("a step that is taken while the layers are painted is waited for, under the same card", async () => {
  const { task, asked, shown, end } = drawing();
  task.follow();
  await vi.advanceTimersByTimeAsync(2000);
  task.follow();
  expect(asked).toHaveLength(1);
  await end();
  expect(asked).toHaveLength(2);
  expect(shown()).toEqual(["Painting"]);
  await vi.advanceTimersByTimeAsync(3000);
  expect(shown()).toEqual(["Painting"]);
  await end();
  expect(shown()).toEqual([]);
});
