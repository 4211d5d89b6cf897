/**
 * Undo and redo over immutable values. A step is whatever the user would call one act: a gesture or the scrub of a
 * field is previewed many times and recorded once, and nudges that follow each other closely are one step.
 *
 * A value shares all that a step did not change with the value before it, so a step weighs what it added. Steps are
 * kept without limit to their number until those around the present weigh more than the budget; then the oldest goes.
 */
import { HeldWeight } from "./held-weight.ts";
import { MEBIBYTE } from "./megabytes.ts";

interface Entry<T> {
  readonly value: T;
  /** What led to this value: "Move decal". */
  readonly label: string;
}

export interface HistoryOptions {
  /** Bytes that the steps may hold beyond what the present value holds itself; sought whenever a step is recorded. */
  readonly budget?: number;
  /** Milliseconds within which steps with the same merge key become one. */
  readonly mergeWindow?: number;
  readonly now?: () => number;
}

export const DEFAULT_BUDGET = 256 * MEBIBYTE;

export class History<T> {
  readonly #mergeWindow: number;
  readonly #now: () => number;
  readonly #all = new HeldWeight();
  readonly #shown = new HeldWeight();
  #budget: number;
  #past: Entry<T>[] = [];
  /** The next one last. */
  #future: Entry<T>[] = [];
  #present: Entry<T>;
  #preview: { readonly value: T } | undefined;
  #mergeKey: string | undefined;
  #mergeTime = 0;
  #dropped = 0;

  constructor(initial: T, options: HistoryOptions = {}) {
    this.#present = { value: initial, label: "" };
    this.#budget = options.budget ?? DEFAULT_BUDGET;
    this.#mergeWindow = options.mergeWindow ?? 500;
    this.#now = options.now ?? (() => performance.now());
    this.#all.retain(initial);
    this.#shown.retain(initial);
  }

  /** The previewed value while a gesture is under way, else the newest recorded one. */
  get present(): T {
    return this.#preview ? this.#preview.value : this.#present.value;
  }

  /** The newest recorded value, whatever is being previewed. */
  get recorded(): T {
    return this.#present.value;
  }

  get previewing(): boolean {
    return this.#preview !== undefined;
  }

  /** Null when there is nothing to undo. */
  get undoLabel(): string | null {
    return this.#past.length > 0 ? this.#present.label : null;
  }

  get redoLabel(): string | null {
    return this.#future.at(-1)?.label ?? null;
  }

  /** Labels of all values, the oldest first; "" for the one that the history began with. */
  get labels(): string[] {
    return [...this.#past, this.#present, ...this.#future.toReversed()].map(({ label }) => label);
  }

  /** Place of the recorded value among `labels`. */
  get position(): number {
    return this.#past.length;
  }

  /** Steps that were dropped to keep within the budget. */
  get dropped(): number {
    return this.#dropped;
  }

  /** Bytes that the steps hold beyond what the present value holds itself. */
  get heldBytes(): number {
    return this.#all.bytes - this.#shown.bytes;
  }

  get budget(): number {
    return this.#budget;
  }

  set budget(bytes: number) {
    this.#budget = bytes;
    this.#keepWithinBudget();
  }

  /** The value at a place among `labels`. */
  valueAt(position: number): T | undefined {
    const { length } = this.#past;
    if (position < length) return this.#past[position]?.value;
    return position === length ? this.#present.value : this.#future.at(length - position)?.value;
  }

  /** Shows a value without recording it; `record` or `cancelPreview` ends the preview. */
  preview(value: T): void {
    this.#preview = { value };
  }

  cancelPreview(): void {
    this.#preview = undefined;
  }

  /** One step. A value identical to the recorded one ends a preview and records nothing. */
  record(value: T, label: string, mergeKey?: string): void {
    this.#preview = undefined;
    if (Object.is(value, this.#present.value)) return;
    const now = this.#now();
    const merges =
      mergeKey !== undefined &&
      mergeKey === this.#mergeKey &&
      now - this.#mergeTime <= this.#mergeWindow &&
      this.#future.length === 0;
    this.#all.retain(value);
    if (merges) this.#all.release(this.#present.value);
    else this.#past.push(this.#present);
    for (const entry of this.#future) this.#all.release(entry.value);
    this.#future = [];
    this.#show({ value, label });
    this.#mergeKey = mergeKey;
    this.#mergeTime = now;
    this.#keepWithinBudget();
  }

  undo(): boolean {
    return this.travelTo(this.position - 1);
  }

  redo(): boolean {
    return this.travelTo(this.position + 1);
  }

  /** Brings back the value at a place among `labels`. False where there is none, or it is the present one. */
  travelTo(position: number): boolean {
    const count = this.#past.length + 1 + this.#future.length;
    if (position === this.position || position < 0 || position >= count || !Number.isInteger(position)) return false;
    let entry = this.#present;
    while (this.#past.length > position) {
      this.#future.push(entry);
      entry = this.#past.pop() as Entry<T>;
    }
    while (this.#past.length < position) {
      this.#past.push(entry);
      entry = this.#future.pop() as Entry<T>;
    }
    // Drops nothing, whatever the present weighs now: what one travels over must not go for it.
    this.#arrive(entry);
    return true;
  }

  /** Forgets every step. */
  reset(value: T): void {
    this.#all.retain(value);
    for (const known of this.values()) this.#all.release(known);
    this.#past = [];
    this.#future = [];
    this.#dropped = 0;
    this.#arrive({ value, label: "" });
  }

  /** Every value that an undo or redo could bring back, and the present one. */
  *values(): Iterable<T> {
    for (const { value } of this.#past) yield value;
    yield this.#present.value;
    for (const { value } of this.#future) yield value;
  }

  /** The oldest steps go first; when none is left before the present, those that could be redone, the furthest first. */
  #keepWithinBudget(): void {
    while (this.heldBytes > this.#budget) {
      const entry = this.#past.shift() ?? this.#future.shift();
      if (!entry) return;
      this.#all.release(entry.value);
      this.#dropped += 1;
    }
  }

  #arrive(entry: Entry<T>): void {
    this.#show(entry);
    this.#preview = undefined;
    this.#mergeKey = undefined;
  }

  #show(entry: Entry<T>): void {
    this.#shown.retain(entry.value);
    this.#shown.release(this.#present.value);
    this.#present = entry;
  }
}
