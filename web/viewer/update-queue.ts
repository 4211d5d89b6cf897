/**
 * Brings updates to the GPU in their order, large ones when it is free. A large upload given while the GPU draws makes
 * this thread wait for it: a second and more where it is software and compiles its shaders for the first frame.
 */
import type { TargetUpdate } from "../engine/engine-api.ts";

/** Bytes: a target of 1024 x 1024. */
const LARGE = 4 * 1024 * 1024;

export class UpdateQueue {
  readonly #apply: (update: TargetUpdate) => void;
  readonly #whenFree: (task: () => void) => void;
  #waiting: TargetUpdate[] = [];

  /** @param whenFree runs a task when the GPU is done with what it has; may run it at once */
  constructor(apply: (update: TargetUpdate) => void, whenFree: (task: () => void) => void) {
    this.#apply = apply;
    this.#whenFree = whenFree;
  }

  push(update: TargetUpdate): void {
    this.#waiting.push(update);
    if (this.#waiting.length > 1) {
      return;
    }
    if (update.bytes.byteLength > LARGE) {
      const waiting = this.#waiting;
      this.#whenFree(() => this.#flush(waiting));
    } else {
      this.#flush(this.#waiting);
    }
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
