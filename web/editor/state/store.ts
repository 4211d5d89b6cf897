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

/** How often at most an element renders while the state changes in each frame of a drag. */
export interface Pace<State> {
  /** Least milliseconds between two renders. */
  readonly milliseconds: number;
  /** A change of one of these values is shown at once: what was shown in passing has become final. */
  readonly final?: (state: State) => readonly unknown[];
}

/** Where frames are slow, as many of them go without a render as where they are fast: at 60 a second these are 100 ms. */
const CHANGES_A_RENDER = 6;
/** Milliseconds without a change, after which the newest is shown, and the next one at once. */
const REST = 250;
/** Where changes come slower than that they rest only after a pause this many times as long as the one before. */
const REST_PAUSES = 3;
/** No pause is waited for longer, milliseconds. */
const LONGEST_REST = 1000;

/**
 * Renders its element again when one of the values that `pick` names has changed, and only then. With a `pace`, changes that
 * follow each other faster than that wait: the first is shown at once, the newest when they have come to rest.
 */
export class StoreController<State extends object> implements ReactiveController {
  readonly #host: ReactiveControllerHost;
  readonly #store: () => Store<State> | undefined;
  readonly #pick: (state: State) => readonly unknown[];
  readonly #pace: Pace<State> | null;
  #seen: readonly unknown[] = [];
  #final: readonly unknown[] = [];
  #unsubscribe: (() => void) | undefined;
  #isConnected = false;
  #waiting: ReturnType<typeof setTimeout> | undefined;
  #rendered = Number.NEGATIVE_INFINITY;
  /** Since the newest render. */
  #changes = 0;
  #changed = Number.NEGATIVE_INFINITY;
  /** Milliseconds between the two newest changes of one movement. */
  #pause = 0;

  /** `store` is a function because an element is made before its properties are set. */
  constructor(
    host: ReactiveControllerHost,
    store: () => Store<State> | undefined,
    pick: (state: State) => readonly unknown[],
    pace: Pace<State> | null = null,
  ) {
    this.#pace = pace;
    this.#host = host;
    this.#store = store;
    this.#pick = pick;
    host.addController(this);
  }

  /** Lit renders what was to be rendered once more, though it was taken out of the page meanwhile: that must not bind it again. */
  hostUpdate(): void {
    if (this.#isConnected) this.#subscribe();
  }

  hostConnected(): void {
    this.#isConnected = true;
    this.#subscribe();
  }

  #subscribe(): void {
    const store = this.#store();
    if (!store || this.#unsubscribe) return;
    this.#seen = this.#pick(store.state);
    this.#final = this.#pace?.final?.(store.state) ?? [];
    this.#unsubscribe = store.subscribe(() => this.#look(store.state));
    this.#host.requestUpdate();
  }

  #look(state: State): void {
    const final = this.#pace?.final?.(state) ?? [];
    const isFinal = differ(final, this.#final);
    this.#final = final;
    const now = this.#pick(state);
    const changed = differ(now, this.#seen);
    this.#seen = now;
    if (isFinal && (changed || this.#changes > 0)) this.#render();
    else if (changed) this.#change();
  }

  #change(): void {
    const now = performance.now();
    const pause = now - this.#changed;
    const rested = pause >= this.#rest;
    this.#pause = pause < LONGEST_REST ? pause : 0;
    this.#changed = now;
    this.#changes += 1;
    const { milliseconds } = this.#pace ?? { milliseconds: 0 };
    const due = this.#changes >= CHANGES_A_RENDER && now - this.#rendered >= milliseconds;
    if (milliseconds === 0 || rested || due) this.#render();
    else this.#waiting ??= setTimeout(() => this.#lookForRest(), this.#rest);
  }

  /** Milliseconds that tell a pause between the frames of a slow drag from its end. */
  get #rest(): number {
    return Math.min(LONGEST_REST, Math.max(REST, REST_PAUSES * this.#pause));
  }

  /** Changes that went on meanwhile put it off. */
  #lookForRest(): void {
    this.#waiting = undefined;
    const wait = this.#changed + this.#rest - performance.now();
    if (wait > 0) this.#waiting = setTimeout(() => this.#lookForRest(), wait);
    else this.#render();
  }

  #render(): void {
    clearTimeout(this.#waiting);
    this.#waiting = undefined;
    this.#changes = 0;
    this.#rendered = performance.now();
    this.#host.requestUpdate();
  }

  hostDisconnected(): void {
    this.#isConnected = false;
    clearTimeout(this.#waiting);
    this.#waiting = undefined;
    this.#unsubscribe?.();
    this.#unsubscribe = undefined;
  }
}

const differ = (a: readonly unknown[], b: readonly unknown[]): boolean =>
  a.length !== b.length || a.some((value, at) => !Object.is(value, b[at]));
