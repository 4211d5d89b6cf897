/**
 * Gets targets ready for the change that is expected next (`Engine.expect`), a little at a time while there is nothing else to
 * do: any call, and any newer list of layers, comes first.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { ExpectedChange } from "./engine-api.ts";
import { callLater } from "./event-loop.ts";
import type { OpenTarget } from "./open-target.ts";

/** A drag's steps follow each other more closely, and need nothing but themselves. */
const PAUSE_MS = 120;
/** What a message that comes meanwhile has to wait at most, or nearly. */
const SHORT_STEP_MS = 2;
const LONG_STEP_MS = 6;
const FIRST_STEP_TILES = 8;

export interface ReadyingParts {
  readonly targets: () => readonly OpenTarget[];
  /** There is something else to do. */
  readonly isBusy: () => boolean;
  readonly fault: (error: Error) => void;
}

export class Readying {
  readonly #parts: ReadyingParts;
  #change: ExpectedChange | null = null;
  /** Those that are not ready yet, the next one last. */
  #targets: OpenTarget[] = [];
  #tile = 0;
  #tilesAtOnce = FIRST_STEP_TILES;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** Counts beginnings: a step that was asked for before the newest one is none any more. */
  #turn = 0;

  constructor(parts: ReadyingParts) {
    this.#parts = parts;
  }

  expect(change: ExpectedChange | null): void {
    if (change?.id === this.#change?.id && change?.inside === this.#change?.inside) return;
    this.#change = change;
    this.#begin(0);
  }

  /** Something was drawn. */
  restart(): void {
    if (this.#change !== null) this.#begin(PAUSE_MS);
  }

  /** Something else is over. */
  resume(): void {
    if (this.#targets.length > 0) this.#schedule(0);
  }

  #begin(delay: number): void {
    this.#targets = this.#change === null ? [] : [...this.#parts.targets()];
    this.#tile = 0;
    this.#schedule(delay);
  }

  #schedule(delay: number): void {
    clearTimeout(this.#timer);
    this.#turn += 1;
    if (this.#targets.length === 0) return;
    const turn = this.#turn;
    this.#timer = setTimeout(() => this.#step(turn), delay);
    // In Node nothing shall wait for this alone.
    (this.#timer as { unref?: () => void }).unref?.();
  }

  #step(turn: number): void {
    const change = this.#change;
    if (turn !== this.#turn || change === null || this.#parts.isBusy()) return;
    const target = this.#targets.at(-1);
    if (target === undefined) return;
    if (!this.#parts.targets().includes(target)) {
      // It was closed.
      this.#targets.pop();
      this.#tile = 0;
      callLater(() => this.#step(turn));
      return;
    }
    try {
      const start = performance.now();
      const next = target.prepare(change, this.#tile, this.#tilesAtOnce);
      const milliseconds = performance.now() - start;
      if (milliseconds < SHORT_STEP_MS) this.#tilesAtOnce *= 2;
      else if (milliseconds > LONG_STEP_MS) this.#tilesAtOnce = Math.max(1, this.#tilesAtOnce >> 1);
      if (next === null) this.#targets.pop();
      this.#tile = next ?? 0;
    } catch (thrown) {
      this.#targets = [];
      this.#parts.fault(TexelcastError.wrap(thrown, "internal", "The engine could not get ready for a change."));
    }
    callLater(() => this.#step(turn));
  }
}
