import type { ReactiveControllerHost } from "lit";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Store, StoreController } from "../../web/editor/state/store.ts";

interface Numbers {
  readonly value: number;
  readonly step: number;
}

/** A panel of numbers that renders at most each 100 ms; tells what it has shown. */
function pacedPanel() {
  const store = new Store<Numbers>({ value: 0, step: 0 });
  const shown: number[] = [];
  const host = {
    addController: () => {},
    removeController: () => {},
    requestUpdate: () => shown.push(store.state.value),
    updateComplete: Promise.resolve(true),
  } satisfies ReactiveControllerHost;
  const pace = { milliseconds: 100, final: ({ step }: Numbers) => [step] };
  new StoreController(
    host,
    () => store,
    ({ value }) => [value],
    pace,
  ).hostConnected();
  shown.length = 0;
  return { store, shown };
}

/** A change, and the frame in which it is told. */
async function frame(store: Store<Numbers>, change: Partial<Numbers>, milliseconds = 16): Promise<void> {
  store.set(change);
  await vi.advanceTimersByTimeAsync(milliseconds);
}

describe("a panel of numbers in a drag", () => {
  beforeEach(() => vi.useFakeTimers());
  afterEach(() => vi.useRealTimers());

  it("shows the first change at once, and then one in some", async () => {
    const { store, shown } = pacedPanel();
    for (let value = 1; value <= 30; value++) await frame(store, { value });
    expect(shown[0]).toBe(1);
    expect(shown.length).toBeGreaterThan(3);
    expect(shown.length).toBeLessThan(8);
  });

  it("shows one in some also where frames are so slow that each looks like a rest", async () => {
    const { store, shown } = pacedPanel();
    for (let value = 1; value <= 30; value++) await frame(store, { value }, 320);
    expect(shown.length).toBeGreaterThan(3);
    expect(shown.length).toBeLessThan(10);
    await vi.advanceTimersByTimeAsync(1000);
    expect(shown.at(-1)).toBe(30);
  });

  it("shows the newest when the changes have come to rest", async () => {
    const { store, shown } = pacedPanel();
    for (let value = 1; value <= 4; value++) await frame(store, { value });
    expect(shown).toEqual([1]);
    await vi.advanceTimersByTimeAsync(1000);
    expect(shown).toEqual([1, 4]);
  });

  it("shows the outcome at once when the drag ends, also where it is what was told last", async () => {
    const { store, shown } = pacedPanel();
    for (let value = 1; value <= 4; value++) await frame(store, { value });
    store.set({ step: 1 });
    await vi.advanceTimersByTimeAsync(0);
    expect(shown).toEqual([1, 4]);
  });
});
