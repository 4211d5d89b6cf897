/**
 * Undo and redo over immutable values. A step is whatever the user would call one act: a gesture or the scrub of a
 * field is previewed many times and recorded once, and nudges that follow each other closely are one step.
 */

interface Entry<T> {
  readonly value: T;
  /** What led to this value: "Move decal". */
  readonly label: string;
}

export interface HistoryOptions {
  /** Steps kept; the oldest is dropped first. */
  readonly limit?: number;
  /** Milliseconds within which steps with the same merge key become one. */
  readonly mergeWindow?: number;
  readonly now?: () => number;
}

export class History<T> {
  readonly #limit: number;
  readonly #mergeWindow: number;
  readonly #now: () => number;
  #past: Entry<T>[] = [];
  #future: Entry<T>[] = [];
  #present: Entry<T>;
  #preview: { readonly value: T } | undefined;
  #mergeKey: string | undefined;
  #mergeTime = 0;

  constructor(initial: T, options: HistoryOptions = {}) {
    this.#present = { value: initial, label: "" };
    this.#limit = options.limit ?? 200;
    this.#mergeWindow = options.mergeWindow ?? 500;
    this.#now = options.now ?? (() => performance.now());
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

  /** The value that `undo` would bring back. */
  get undoValue(): T | undefined {
    return this.#past.at(-1)?.value;
  }

  get redoValue(): T | undefined {
    return this.#future.at(-1)?.value;
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
    if (!merges) {
      this.#past.push(this.#present);
      if (this.#past.length > this.#limit) this.#past.shift();
    }
    this.#present = { value, label };
    this.#future = [];
    this.#mergeKey = mergeKey;
    this.#mergeTime = now;
  }

  undo(): boolean {
    const entry = this.#past.pop();
    if (!entry) return false;
    this.#future.push(this.#present);
    this.#arrive(entry);
    return true;
  }

  redo(): boolean {
    const entry = this.#future.pop();
    if (!entry) return false;
    this.#past.push(this.#present);
    this.#arrive(entry);
    return true;
  }

  /** Forgets every step. */
  reset(value: T): void {
    this.#past = [];
    this.#future = [];
    this.#arrive({ value, label: "" });
  }

  /** Drops steps from the oldest on, as long as `unwanted` says so. */
  dropOldest(unwanted: (value: T) => boolean): void {
    const keep = this.#past.findIndex(({ value }) => !unwanted(value));
    this.#past = keep < 0 ? [] : this.#past.slice(keep);
  }

  /** Every value that an undo or redo could bring back, and the present one. */
  *values(): Iterable<T> {
    for (const { value } of this.#past) yield value;
    yield this.#present.value;
    for (const { value } of this.#future) yield value;
  }

  #arrive(entry: Entry<T>): void {
    this.#present = entry;
    this.#preview = undefined;
    this.#mergeKey = undefined;
  }
}
