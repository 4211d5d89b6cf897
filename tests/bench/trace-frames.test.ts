import { expect, test } from "vitest";
import { frameWork, type TraceEvent } from "../../bench/browser/trace-frames.ts";

const PAGE = { pid: 7, tid: 1 };
const named = (tid: number, name: string): TraceEvent => ({
  ...{ pid: 7, tid, name: "thread_name", ph: "M", ts: 0 },
  args: { name },
});
/** Milliseconds; `own`: processor time. */
const event = (name: string, start: number, length: number, own = length, place = PAGE): TraceEvent => ({
  ...{ ...place, name, ph: "X" },
  ...{ ts: start * 1000, dur: length * 1000, tdur: own * 1000 },
});

test("a frame's work is the page thread's processor time from one commit to the next", () => {
  const { frames, median, mean, byKind } = frameWork([
    named(1, "CrRendererMain"),
    named(2, "Compositor"),
    event("RunTask", 0, 9),
    event("Commit", 8, 1),
    // The first frame: an animation callback of 2 in which layout takes 1, and a wait of 6 that is not the page's work.
    event("RunTask", 10, 8, 2),
    event("FireAnimationFrame", 10, 8, 2),
    event("Layout", 11, 1),
    event("RunTask", 19, 1.5),
    event("TimerFire", 19, 0.5),
    event("Commit", 20, 0.5),
    // The second.
    event("RunTask", 30, 4.5),
    event("Commit", 34, 0.5),
    // Nobody knows how long the third would have been.
    event("RunTask", 40, 100),
    event("RunTask", 12, 50, 50, { pid: 7, tid: 2 }),
  ]);
  expect({ frames, median, mean }).toEqual({ frames: 2, median: 4, mean: 4 });
  expect(byKind["frame callbacks"]).toBeCloseTo(1);
  expect(byKind.timers).toBeCloseTo(0.25);
  expect(byKind["style and layout"]).toBeUndefined();
  expect(byKind.paint).toBeCloseTo(0.5);
  expect(byKind.other).toBeCloseTo(4 - 1.75);
});

test("messages of the test that drives the page are none of its work", () => {
  const message = (start: number, length: number, tag: string): TraceEvent => ({
    ...event("Receive mojo message", start, length),
    args: { chrome_mojo_event_info: { mojo_interface_tag: tag } },
  });
  const { median } = frameWork([
    named(1, "CrRendererMain"),
    event("Commit", 0, 1),
    event("RunTask", 2, 3),
    message(2.5, 2, "blink.mojom.DevToolsSession"),
    event("RunTask", 6, 2),
    message(6.5, 1, "viz.mojom.CompositorFrameSinkClient"),
    event("RunTask", 9, 1.5),
    event("Commit", 10, 0.5),
  ]);
  expect(median).toBe(3.5);
});

test("the work of all frames is shared among the pointer's moves", () => {
  const move = (start: number): TraceEvent => ({
    ...event("EventDispatch", start, 0.5),
    args: { data: { type: "pointermove" } },
  });
  const events = [named(1, "CrRendererMain"), event("Commit", 0, 1), event("RunTask", 2, 3)];
  const second = [event("Commit", 5, 1), event("RunTask", 7, 2), event("RunTask", 10, 1), event("Commit", 10, 1)];
  expect(frameWork([...events, ...second]).perMove).toBeNull();
  expect(frameWork([...events, move(2), move(7.5), ...second]).perMove).toBeCloseTo(3);
});

test("a trace without frames is refused, not counted as no work", () => {
  expect(() => frameWork([named(1, "CrRendererMain"), event("RunTask", 0, 5)])).toThrow("no frames");
});
