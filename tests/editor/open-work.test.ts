import { afterEach, expect, test } from "vitest";
import { OpenWork } from "../../web/editor/state/open-work.ts";

const { allSettled } = Promise;
afterEach(() => {
  Promise.allSettled = allSettled;
});

/** As zone.js has it in the file for a script tag, made for the oldest browsers: it counts what has a length, and nothing else. */
const listsAlone = function (this: PromiseConstructor, works: Iterable<unknown>): Promise<unknown> {
  return allSettled.call(this, Array.from({ ...works, length: (works as unknown[]).length ?? 0 }));
} as typeof allSettled;

test("work is waited for where a page's own Promise.allSettled takes lists alone", async () => {
  let looks = 0;
  // A loop that never lets go of the thread would end no test.
  Promise.allSettled = function (this: PromiseConstructor, works: Iterable<unknown>) {
    if (++looks > 3) throw new Error("The thread is kept.");
    return listsAlone.call(this, works);
  } as typeof allSettled;
  const open = new OpenWork();
  let isDone = false;
  open.add(new Promise((resolve) => setTimeout(resolve)).then(() => (isDone = true)));
  await open.settled();
  expect({ isDone, underWay: open.underWay }).toEqual({ isDone: true, underWay: false });
});
