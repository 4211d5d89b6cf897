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

/** Renders its element again when one of the values that `pick` names has changed, and only then. */
export class StoreController<State extends object> implements ReactiveController {
  readonly #host: ReactiveControllerHost;
  readonly #store: () => Store<State> | undefined;
  readonly #pick: (state: State) => readonly unknown[];
  #seen: readonly unknown[] = [];
  #unsubscribe: (() => void) | undefined;

  /** `store` is a function because an element is made before its properties are set. */
  constructor(
    host: ReactiveControllerHost,
    store: () => Store<State> | undefined,
    pick: (state: State) => readonly unknown[],
  ) {
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
      this.#host.requestUpdate();
    });
    this.#host.requestUpdate();
  }

  hostDisconnected(): void {
    this.#unsubscribe?.();
    this.#unsubscribe = undefined;
  }
}
