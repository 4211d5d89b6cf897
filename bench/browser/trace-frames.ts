/**
 * What a page's own thread does from frame to frame, from a Chromium trace.
 *
 * What the GPU does is not in it, nor what Chromium's GPU process does, where WebGL in software draws. What this thread does
 * for the GPU is: copying texels and commands into the memory that both share, asking fences, handing a canvas over to
 * the compositor (0.8 ms of a frame that draws). It is not told apart either, for WebGL's calls lie in the midst of functions
 * that the trace knows as a whole.
 *
 * A frame is a commit, and a step of the drag takes two or three of them where drawing is slow: the pointer's own, the
 * answer's, sometimes one of a panel. What saves a step a whole frame, a cheap one, raises the median of frames; so the work
 * of a move is told beside it.
 */
import { median } from "../rounds.ts";

/** As in Chromium's trace files; microseconds. */
export interface TraceEvent {
  readonly name: string;
  readonly ph: string;
  readonly pid: number;
  readonly tid: number;
  readonly ts: number;
  readonly dur?: number;
  /** The thread's processor time: without the time in which it waited for others. */
  readonly tdur?: number;
  readonly args?: {
    readonly name?: string;
    /** Of an event that is dispatched, its type. */
    readonly data?: { readonly type?: string };
    readonly chrome_mojo_event_info?: { readonly mojo_interface_tag?: string };
  };
}

/** "toplevel" names the messages between processes, by which the test's own are told from the page's work. */
export const TRACE_CATEGORIES = ["devtools.timeline", "disabled-by-default-devtools.timeline", "toplevel"];

/** The mouse that moves in a test comes by messages of this interface, which a user's does not. */
const DRIVER = "DevTools";

/** Kinds of work that are told apart, none within another; the rest of a task is "other". */
const KINDS: Readonly<Record<string, string>> = {
  FireAnimationFrame: "frame callbacks",
  TimerFire: "timers",
  HandlePostMessage: "answers of the engine",
  EventDispatch: "input",
  UpdateLayoutTree: "style and layout",
  Layout: "style and layout",
  PrePaint: "paint",
  Paint: "paint",
  Layerize: "paint",
  Commit: "paint",
};

export interface FrameWork {
  readonly frames: number;
  /** Processor time of the page's thread in a frame, milliseconds. */
  readonly median: number;
  readonly mean: number;
  /** 19 of 20 frames take less. */
  readonly p95: number;
  /** Of all frames, shared among the moves of the pointer; null where it did not move. */
  readonly perMove: number | null;
  /** Mean of each kind. */
  readonly byKind: Readonly<Record<string, number>>;
}

/** A frame is what lies between two commits of the page's thread, the busiest of its kind in the trace. */
export function frameWork(events: readonly TraceEvent[]): FrameWork {
  const thread = pageThread(events);
  const commits = thread.filter(({ name }) => name === "Commit").map(({ ts, dur = 0 }) => ts + dur);
  commits.sort((a, b) => a - b);
  const frameOf = ({ ts }: TraceEvent): number => commits.findIndex((end) => ts < end) - 1;
  const driven = driverTimes(thread);
  const tasks = thread.filter((event) => event.name === "RunTask" && frameOf(event) >= 0 && !holdsAny(event, driven));
  const frames = new Array<number>(Math.max(0, commits.length - 1)).fill(0);
  for (const task of tasks) frames[frameOf(task)] += milliseconds(task);
  if (frames.length === 0 || !tasks.some(({ tdur }) => tdur)) {
    throw new Error("The trace holds no frames with processor times: was the page drawn while it was taken?");
  }
  const sorted = [...frames].sort((a, b) => a - b);
  const sum = frames.reduce((all, frame) => all + frame, 0);
  const mean = sum / frames.length;
  const moves = thread.filter((event) => event.args?.data?.type === "pointermove" && frameOf(event) >= 0).length;
  return {
    frames: frames.length,
    median: median(frames),
    mean,
    p95: sorted[Math.floor(frames.length * 0.95)],
    perMove: moves === 0 ? null : sum / moves,
    byKind: kindsOf(
      thread.filter((event) => frameOf(event) >= 0),
      frames.length,
      mean,
    ),
  };
}

/** Means in a frame; what lies within another kind of work counts as that. */
function kindsOf(events: readonly TraceEvent[], frames: number, mean: number): Record<string, number> {
  const kinds: Record<string, number> = {};
  let end = 0;
  for (const event of events.filter(({ name }) => name in KINDS).sort((a, b) => a.ts - b.ts)) {
    if (event.ts < end) continue;
    end = event.ts + (event.dur ?? 0);
    const kind = KINDS[event.name];
    kinds[kind] = (kinds[kind] ?? 0) + milliseconds(event) / frames;
  }
  const named = Object.values(kinds).reduce((sum, share) => sum + share, 0);
  return { ...kinds, other: mean - named };
}

function pageThread(events: readonly TraceEvent[]): TraceEvent[] {
  const places = events
    .filter(({ name, args }) => name === "thread_name" && args?.name === "CrRendererMain")
    .map(({ pid, tid }) => `${pid} ${tid}`);
  const threads = places.map((place) => events.filter(({ ph, pid, tid }) => ph === "X" && `${pid} ${tid}` === place));
  return threads.sort((a, b) => b.length - a.length)[0] ?? [];
}

/** When the thread took messages of the test that drives the page. */
function driverTimes(thread: readonly TraceEvent[]): number[] {
  const info = ({ args }: TraceEvent): string => args?.chrome_mojo_event_info?.mojo_interface_tag ?? "";
  return thread.filter((event) => info(event).includes(DRIVER)).map(({ ts }) => ts);
}

function holdsAny({ ts, dur = 0 }: TraceEvent, times: readonly number[]): boolean {
  return times.some((time) => time >= ts && time <= ts + dur);
}

function milliseconds({ tdur = 0 }: TraceEvent): number {
  return tdur / 1000;
}
