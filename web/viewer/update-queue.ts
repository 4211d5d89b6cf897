/**
 * Brings updates to the GPU in their order, large ones when it is free. A large upload given while the GPU draws makes
 * this thread wait for it: a second and more where it is software and compiles its shaders for the first frame.
 */
import type { TargetUpdate } from "../engine/engine-api.ts";

/**
 * Bytes: a target of 2048 x 1024. With half of that what a drag paints at 2048 x 2048 had to wait, too, in each view for a
 * fence of its own: where WebGL runs on the processor, in one pair of runs, 17.2 ms of this thread a move of the pointer against
 * 14.1, and 290 ms until the next move against 200. What comes at once did not make this thread wait (11 ms at most).
 */
const LARGE = 8 * 1024 * 1024;

export class UpdateQueue {
  readonly #apply: (update: TargetUpdate) => void;
  readonly #whenFree: (task: () => void) => void;
  #waiting: TargetUpdate[] = [];

  /** @param whenFree runs a task when the GPU is done with what it has; may run it at once */
  constructor(apply: (update: TargetUpdate) => void, whenFree: (task: () => void) => void) {
    this.#apply = apply;
    this.#whenFree = whenFree;
  }

  /** Whether the update was brought at once: its bytes are not asked for again. */
  push(update: TargetUpdate): boolean {
    const waiting = this.#waiting;
    waiting.push(update);
    if (waiting.length === 1) {
      if (update.bytes.byteLength > LARGE) {
        this.#whenFree(() => this.#flush(waiting));
      } else {
        this.#flush(waiting);
      }
    }
    return waiting !== this.#waiting;
  }

  /** Drops what waits: its target is gone. */
  clear(): void {
    this.#waiting = [];
  }

  #flush(waiting: TargetUpdate[]): void {
    if (waiting === this.#waiting) {
      this.#waiting = [];
      for (const update of waiting) {
        this.#apply(update);
      }
    }
  }
}
