/** The editor's light reactive state: one immutable value, listeners told after a change, at most once per microtask. */
import type { ReactiveController, ReactiveControllerHost } from "lit";

export class Store<State extends object> {
  #state: State;
  readonly #listeners = new Set<() => void>();
  #scheduled = false;

  constructor(initial: State) {
    this.#state = initial;
  }

  get state(): State {
    return this.#state;
  }

  /** Replaces the named fields. Fields whose values are identical wake nobody. */
  set(patch: Partial<State>): void {
    const changed = (Object.keys(patch) as (keyof State)[]).some((key) => !Object.is(patch[key], this.#state[key]));
    if (!changed) return;
    this.#state = { ...this.#state, ...patch };
    this.#schedule();
  }

  subscribe(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Several changes of one event handler end in one round of renders. */
  #schedule(): void {
    if (this.#scheduled) return;
    this.#scheduled = true;
    queueMicrotask(() => {
      this.#scheduled = false;
      for (const listener of [...this.#listeners]) listener();
    });
  }
}

/**
 * Renders its element again when one of the values that `pick` names has changed, and only then. With a `pace`, changes that
 * follow each other faster than that wait: the first is shown at once, the newest when the time is over.
 */
export class StoreController<State extends object> implements ReactiveController {
  readonly #host: ReactiveControllerHost;
  readonly #store: () => Store<State> | undefined;
  readonly #pick: (state: State) => readonly unknown[];
  readonly #pace: number;
  #seen: readonly unknown[] = [];
  #unsubscribe: (() => void) | undefined;
  #waiting: ReturnType<typeof setTimeout> | undefined;
  #requested = Number.NEGATIVE_INFINITY;

  /**
   * `store` is a function because an element is made before its properties are set.
   *
   * @param pace least milliseconds between two renders; default 0
   */
  constructor(
    host: ReactiveControllerHost,
    store: () => Store<State> | undefined,
    pick: (state: State) => readonly unknown[],
    pace = 0,
  ) {
    this.#pace = pace;
    this.#host = host;
    this.#store = store;
    this.#pick = pick;
    host.addController(this);
  }

  hostUpdate(): void {
    if (!this.#unsubscribe) this.hostConnected();
  }

  hostConnected(): void {
    const store = this.#store();
    if (!store || this.#unsubscribe) return;
    this.#seen = this.#pick(store.state);
    this.#unsubscribe = store.subscribe(() => {
      const now = this.#pick(store.state);
      if (now.length === this.#seen.length && now.every((value, index) => Object.is(value, this.#seen[index]))) return;
      this.#seen = now;
      this.#request();
    });
    this.#host.requestUpdate();
  }

  #request(): void {
    if (this.#waiting !== undefined) return;
    const wait = this.#requested + this.#pace - performance.now();
    if (wait > 0) {
      this.#waiting = setTimeout(() => this.#render(), wait);
    } else {
      this.#render();
    }
  }

  #render(): void {
    this.#waiting = undefined;
    this.#requested = performance.now();
    this.#host.requestUpdate();
  }

  hostDisconnected(): void {
    clearTimeout(this.#waiting);
    this.#waiting = undefined;
    this.#unsubscribe?.();
    this.#unsubscribe = undefined;
  }
}
