import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { GpuPace } from "../../web/viewer/gpu-pace.ts";

/** A context whose fences are done, or forgotten with the context that they were made in, when a test says so. */
function graphics() {
  const state = { signaled: false, lost: false, contexts: 1 };
  const gl = {
    ...{ SYNC_GPU_COMMANDS_COMPLETE: 0x9117, SYNC_STATUS: 0x9114, SIGNALED: 0x9119, UNSIGNALED: 0x9118 },
    fenceSync: () => (state.lost ? null : { context: state.contexts }),
    getSyncParameter: (fence: { context: number }) => {
      if (state.lost || fence.context !== state.contexts) return null;
      return state.signaled ? 0x9119 : 0x9118;
    },
    deleteSync: () => undefined,
    flush: () => undefined,
    isContextLost: () => state.lost,
  };
  return { state, gl: gl as unknown as WebGL2RenderingContext };
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

test("what waits for the GPU runs once it is done, and not before", () => {
  const { state, gl } = graphics();
  const notes: number[] = [];
  const pace = new GpuPace(gl, (milliseconds) => notes.push(milliseconds));
  const task = vi.fn();
  pace.mark({ flush: true });
  pace.whenDone(task);
  vi.advanceTimersByTime(500);
  expect(task).not.toHaveBeenCalled();
  state.signaled = true;
  vi.advanceTimersByTime(1000);
  expect(task).toHaveBeenCalledOnce();
  expect(notes).toHaveLength(1);
});

test("what waits for a GPU that is lost runs, and counts as no work of it", () => {
  const { state, gl } = graphics();
  const note = vi.fn();
  const pace = new GpuPace(gl, note);
  const task = vi.fn();
  pace.mark({ flush: true });
  pace.whenDone(task);
  state.lost = true;
  vi.advanceTimersByTime(1000);
  expect(task).toHaveBeenCalledOnce();
  expect(note).not.toHaveBeenCalled();
});

test("what waits for a GPU that was lost and came back between two looks runs, and so does what comes after it", () => {
  const { state, gl } = graphics();
  const note = vi.fn();
  const pace = new GpuPace(gl, note);
  const [task, next] = [vi.fn(), vi.fn()];
  pace.mark({ flush: true });
  pace.whenDone(task);
  state.contexts += 1;
  vi.advanceTimersByTime(1000);
  expect(task).toHaveBeenCalledOnce();
  expect(note).not.toHaveBeenCalled();
  pace.mark({ flush: true });
  pace.whenDone(next);
  state.signaled = true;
  vi.advanceTimersByTime(1000);
  expect(next).toHaveBeenCalledOnce();
});
