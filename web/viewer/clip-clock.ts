/** Lets a model's clip run, holds it while a button is down over the model, and tells where it is. */
import type { ModelAnimation } from "./model-animation.ts";
import type { AnimationState } from "./viewer-api.ts";

/** While a clip plays its place is told this often, seconds. */
const NEWS = 0.1;

export interface ClipClockHooks {
  animation(): ModelAnimation | null;
  /** Whether the model is met by a press, which then holds the clip: the surface stays under the pointer. */
  isOnModel(event: PointerEvent): boolean;
  tell(state: AnimationState): void;
  /** The pose changed, or was held or let go. */
  changed(): void;
}

export class ClipClock {
  readonly #hooks: ClipClockHooks;
  readonly #abort = new AbortController();
  #untold = 0;
  #held = false;

  constructor(root: HTMLElement, hooks: ClipClockHooks) {
    this.#hooks = hooks;
    const early = { capture: true, signal: this.#abort.signal };
    root.addEventListener("pointerdown", (event) => this.#press(event), early);
    for (const type of ["pointerup", "pointercancel"] as const) {
      window.addEventListener(type, () => this.#release(), early);
    }
  }

  /** Whether the pose changes from frame to frame. */
  get runs(): boolean {
    return !this.#held && this.#hooks.animation()?.playing === true;
  }

  /** Goes on by `delta` seconds. Returns whether the clip runs. */
  advance(delta: number): boolean {
    const animation = this.#hooks.animation();
    if (animation === null || !this.runs) {
      return false;
    }
    animation.advance(delta);
    this.#untold += delta;
    if (this.#untold >= NEWS) {
      this.#tell(animation);
    }
    this.#hooks.changed();
    return true;
  }

  /** Plays, stops, scrubs or rests, as `ModelViewer.setAnimation` says. */
  set(change: Partial<AnimationState>): void {
    const animation = this.#hooks.animation();
    if (animation === null || animation.clips.length === 0) {
      return;
    }
    animation.set(change);
    this.#tell(animation);
    this.#hooks.changed();
  }

  dispose(): void {
    this.#abort.abort();
  }

  #tell(animation: ModelAnimation): void {
    this.#untold = 0;
    this.#hooks.tell(animation.state);
  }

  #press(event: PointerEvent): void {
    this.#held = this.#hooks.animation()?.playing === true && this.#hooks.isOnModel(event);
    if (this.#held) {
      this.#hooks.changed();
    }
  }

  #release(): void {
    if (this.#held) {
      this.#held = false;
      this.#hooks.changed();
    }
  }
}
