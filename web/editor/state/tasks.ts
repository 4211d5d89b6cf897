/** Long work with progress and cancellation: shown only when it lasts, so that quick work does not flicker. */
import { ToldError } from "../strings/told-error.ts";
import { type Strings, stringsIn } from "../strings.ts";
import type { EditorState, Task } from "./editor-state.ts";
import type { Store } from "./store.ts";

export interface TaskHandle {
  readonly signal: AbortSignal;
  readonly abort: () => void;
  progress(share: number | null): void;
  relabel(label: string): void;
  /** Rejects (code "cancelled") once the user has cancelled: to be called between two parts of the work. */
  checkCancelled(): void;
}

/** Milliseconds before a task is shown. */
const PATIENCE = 300;

export class Tasks {
  readonly #store: Store<EditorState>;
  #count = 0;
  #quiet = 0;

  constructor(store: Store<EditorState>) {
    this.#store = store;
  }

  get #strings(): Strings {
    return stringsIn(this.#store.state.language);
  }

  get running(): boolean {
    return this.#quiet > 0 || this.#store.state.tasks.length > 0;
  }

  /** Counts work as running that shows no progress of its own. */
  async quietly<T>(work: Promise<T>): Promise<T> {
    this.#quiet += 1;
    try {
      return await work;
    } finally {
      this.#quiet -= 1;
    }
  }

  /** Runs `work` and passes on how it ends. */
  async run<T>(
    label: string,
    work: (task: TaskHandle) => Promise<T>,
    options: { cancellable?: boolean } = {},
  ): Promise<T> {
    this.#count += 1;
    const id = this.#count;
    const abort = new AbortController();
    const cancel = options.cancellable === false ? null : () => abort.abort();
    this.#store.set({ tasks: [...this.#store.state.tasks, { id, label, share: null, cancel, visible: false }] });
    const timer = setTimeout(() => this.#patch(id, { visible: true }), PATIENCE);
    try {
      return await work({
        signal: abort.signal,
        abort: () => abort.abort(),
        progress: (share) => this.#patch(id, { share }),
        relabel: (text) => this.#patch(id, { label: text, share: null }),
        checkCancelled: () => {
          if (abort.signal.aborted) throw new ToldError("cancelled", this.#strings.errors.cancelled);
        },
      });
    } finally {
      clearTimeout(timer);
      this.#store.set({ tasks: this.#store.state.tasks.filter((task) => task.id !== id) });
    }
  }

  #patch(id: number, patch: Partial<Task>): void {
    this.#store.set({ tasks: this.#store.state.tasks.map((task) => (task.id === id ? { ...task, ...patch } : task)) });
  }
}
