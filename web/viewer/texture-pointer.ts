/** Where the pointer is in the flat view, and clicks that are no drags. Only listens: panning and tools keep what they take. */
import { FrameTask } from "./frame-task.ts";
import type { ScreenPoint } from "./screen-space.ts";

/** Pixels that a press may wander and still be a click. */
const SLOP = 4;

export interface TexturePointerHooks {
  /** At most once a frame; null when the pointer has left. */
  hover(at: ScreenPoint | null): void;
  click(at: ScreenPoint): void;
}

export class TexturePointer {
  readonly #root: HTMLElement;
  readonly #abort = new AbortController();
  readonly #task: FrameTask;
  #at: ScreenPoint | null = null;
  #press: PointerEvent | null = null;

  constructor(root: HTMLElement, hooks: TexturePointerHooks) {
    this.#root = root;
    this.#task = new FrameTask(() => hooks.hover(this.#at));
    const early = { capture: true, signal: this.#abort.signal };
    root.addEventListener("pointermove", (event) => this.#moveTo(this.#pointOf(event)), early);
    root.addEventListener("pointerleave", () => this.#moveTo(null), early);
    root.addEventListener(
      "pointerdown",
      (event) => {
        this.#press = event.button === 0 && event.isPrimary ? event : null;
      },
      early,
    );
    root.addEventListener(
      "pointerup",
      (event) => {
        const press = this.#press;
        this.#press = null;
        const wandered = press && Math.hypot(event.clientX - press.clientX, event.clientY - press.clientY);
        if (press?.pointerId === event.pointerId && wandered !== null && wandered <= SLOP) {
          hooks.click(this.#pointOf(event));
        }
      },
      early,
    );
  }

  dispose(): void {
    this.#abort.abort();
    this.#task.cancel();
  }

  #moveTo(at: ScreenPoint | null): void {
    this.#at = at;
    this.#task.request();
  }

  #pointOf(event: PointerEvent): ScreenPoint {
    const box = this.#root.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }
}
