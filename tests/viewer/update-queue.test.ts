import { describe, expect, it } from "vitest";
import type { TargetUpdate } from "../../web/engine/engine-api.ts";
import { UpdateQueue } from "../../web/viewer/update-queue.ts";

const MEBIBYTE = 1024 * 1024;

function update(revision: number, bytes: number): TargetUpdate {
  return {
    material: 0,
    revision,
    rects: [],
    bytes: new Uint8Array(bytes),
    projectedLayers: 0,
    projectedTexels: 0,
    compositedTexels: 0,
    milliseconds: 0,
  };
}

/** A queue whose GPU is busy until `free` is called. */
function busyQueue() {
  const applied: number[] = [];
  const tasks: (() => void)[] = [];
  const queue = new UpdateQueue(
    ({ revision }) => applied.push(revision),
    (task) => tasks.push(task),
  );
  const free = () => {
    for (const task of tasks.splice(0)) {
      task();
    }
  };
  return { queue, applied, free };
}

describe("the queue of updates", () => {
  it("passes small updates on at once, however busy the GPU is", () => {
    const { queue, applied } = busyQueue();
    queue.push(update(1, 5 * MEBIBYTE));
    queue.push(update(2, MEBIBYTE));
    expect(applied).toEqual([1, 2]);
  });

  it("holds a large one until the GPU is free, and what comes after it in its order", () => {
    const { queue, applied, free } = busyQueue();
    queue.push(update(1, 9 * MEBIBYTE));
    queue.push(update(2, 10));
    queue.push(update(3, 10 * MEBIBYTE));
    expect(applied).toEqual([]);
    free();
    expect(applied).toEqual([1, 2, 3]);
    queue.push(update(4, 10));
    expect(applied).toEqual([1, 2, 3, 4]);
  });

  it("tells whose bytes are no longer needed", () => {
    const { queue, free } = busyQueue();
    expect(queue.push(update(1, 10))).toBe(true);
    expect(queue.push(update(2, 9 * MEBIBYTE))).toBe(false);
    expect(queue.push(update(3, 10))).toBe(false);
    free();
    expect(queue.push(update(4, 10))).toBe(true);
    const idle = new UpdateQueue(
      () => {},
      (task) => task(),
    );
    expect(idle.push(update(1, 9 * MEBIBYTE))).toBe(true);
  });

  it("forgets what waited for a target that is gone", () => {
    const { queue, applied, free } = busyQueue();
    queue.push(update(1, 9 * MEBIBYTE));
    queue.clear();
    queue.push(update(2, 10));
    free();
    expect(applied).toEqual([2]);
  });
});
