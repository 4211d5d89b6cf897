/**
 * Notices a worker that is gone without a word. A browser that ends a worker's thread (for want of memory, say) may raise no
 * event; but it frees the thread's Web Locks at once, and the page waits for one that the worker holds all its life. Without
 * Web Locks, and for a thread that hangs, there is the patience for an answer. One that may wait for what never comes, since
 * its page was held still, is not waited for.
 */
import type { CallName } from "./engine-protocol.ts";

/** What a worker does in one go, without a look at its messages, takes no longer than this even on slow phones. */
const PATIENCE_MS = 20_000;
/** Decoding a model, or packing a large texture as PNG. */
const LONG_PATIENCE_MS = 180_000;
const LONG: ReadonlySet<string> = new Set<CallName>([
  "loadModel",
  "setAsset",
  "openTarget",
  "exportPng",
  "exportGlb",
  "exportUsdz",
  "viewMap",
  "printReport",
  "printMap",
  "exportPrint",
]);
const LOOK_EVERY_MS = 2_000;

export interface WorkerWatchParts {
  /** Asks the worker for a sign of life. */
  readonly ping: () => void;
  /** What the worker has been asked and has not answered. */
  readonly waitsFor: () => readonly (CallName | "layers")[];
  /** Called once, with what happened to the worker; without a word where the page was held still in the midst of its work. */
  readonly lost: (reason?: string) => void;
}

export class WorkerWatch {
  readonly #parts: WorkerWatchParts;
  readonly #guard = new AbortController();
  readonly #timer: ReturnType<typeof setInterval>;
  /**
   * How often it was looked after since it was asked and did not answer. Counted, for clocks go on while the machine sleeps and while
   * the browser holds a page still that is not seen: both threads wake then, and this one may be the first.
   */
  #looks = 0;

  constructor(parts: WorkerWatchParts) {
    this.#parts = parts;
    this.#timer = setInterval(() => this.#look(), LOOK_EVERY_MS);
    // In Node (tests, tools) the watch alone must not keep the process alive.
    (this.#timer as { unref?: () => void }).unref?.();
    // What a worker asks of the server while its page is put away (left and come back to, or a tab that is frozen) may never be sent in
    // Chromium: of 84 pages left in the midst of a report, 6 waited for an import for ever. Its thread answers nevertheless.
    globalThis.document?.addEventListener("resume", () => parts.waitsFor()[0] && this.#lose(), {
      signal: this.#guard.signal,
    });
  }

  /** The worker has said something. */
  heard(): void {
    this.#looks = 0;
  }

  /** Waits for a lock that the worker holds. */
  guard(lock: string): void {
    const { signal } = this.#guard;
    navigator.locks?.request(lock, { signal }, () => this.#lose("its thread was ended")).catch(() => undefined);
  }

  stop(): void {
    clearInterval(this.#timer);
    this.#guard.abort();
  }

  #look(): void {
    const waiting = this.#parts.waitsFor();
    if (!waiting[0]) {
      this.heard();
      return;
    }
    // A thread that is free answers at once, however long the work itself takes.
    if (this.#looks === 0) this.#parts.ping();
    const silence = LOOK_EVERY_MS * this.#looks++;
    if (silence > (waiting.some((name) => LONG.has(name)) ? LONG_PATIENCE_MS : PATIENCE_MS)) {
      this.#lose(`it did not answer for ${silence / 1000} seconds`);
    }
  }

  #lose(reason?: string): void {
    if (this.#guard.signal.aborted) return;
    this.stop();
    this.#parts.lost(reason);
  }
}

/** The worker's half: takes a lock of a new name and keeps it; `announce` is called once it is held. */
export function holdLifeLock(announce: (lock: string) => void): void {
  const numbers = crypto.getRandomValues(new Uint32Array(4));
  const lock = `texelcast-engine-${[...numbers].map((number) => number.toString(16)).join("-")}`;
  navigator.locks
    ?.request(lock, () => {
      announce(lock);
      return new Promise(() => undefined);
    })
    .catch(() => undefined);
}
