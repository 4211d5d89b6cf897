import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FrameTask } from "../../web/viewer/frame-task.ts";

describe("a frame's task", () => {
  let waiting: Map<number, () => void>;
  let runs: number;
  let task: FrameTask;

  beforeEach(() => {
    waiting = new Map();
    runs = 0;
    let newest = 0;
    vi.stubGlobal("requestAnimationFrame", (callback: () => void) => {
      waiting.set(++newest, callback);
      return newest;
    });
    vi.stubGlobal("cancelAnimationFrame", (request: number) => waiting.delete(request));
    task = new FrameTask(() => runs++);
  });
  afterEach(() => {
    vi.unstubAllGlobals();
  });

  /** How often the task has run after each of so many frames. */
  function runsAfter(frames: number, ask: () => void = () => {}): number[] {
    return Array.from({ length: frames }, () => {
      ask();
      const due = [...waiting.values()];
      waiting.clear();
      for (const callback of due) callback();
      return runs;
    });
  }

  it("runs once in the next frame, however often it is asked for", () => {
    task.request();
    task.request();
    expect(runsAfter(3)).toEqual([1, 1, 1]);
  });

  it("runs in every second frame while it is asked for later in each", () => {
    expect(runsAfter(6, () => task.requestLater())).toEqual([0, 1, 1, 2, 2, 3]);
  });

  it("runs in the next frame where it is asked for later, and then at once", () => {
    task.requestLater();
    task.request();
    task.requestLater();
    expect(runsAfter(3)).toEqual([1, 1, 1]);
  });

  it("runs at once where what waits is flushed, later or not, and never where it was cancelled", () => {
    task.requestLater();
    task.flush();
    expect(runs).toBe(1);
    task.requestLater();
    task.cancel();
    task.flush();
    expect(runsAfter(3)).toEqual([1, 1, 1]);
  });
});
