/** Where the pointer is in the flat view, and clicks that are no drags. Only listens: panning and tools keep what they take. */
import { ClientCorner } from "./client-corner.ts";
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
  readonly #corner: ClientCorner;
  readonly #abort = new AbortController();
  readonly #task: FrameTask;
  #at: ScreenPoint | null = null;
  #press: PointerEvent | null = null;

  constructor(root: HTMLElement, hooks: TexturePointerHooks) {
    this.#corner = new ClientCorner(root);
    this.#task = new FrameTask(() => hooks.hover(this.#at));
    const early = { capture: true, signal: this.#abort.signal };
    const pointOf = ({ clientX, clientY }: PointerEvent): ScreenPoint => this.#corner.pointOf(clientX, clientY);
    root.addEventListener("pointermove", (event) => this.#moveTo(pointOf(event)), early);
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
          hooks.click(pointOf(event));
        }
      },
      early,
    );
  }

  /** Whether it is over the view. */
  get isHere(): boolean {
    return this.#at !== null;
  }

  dispose(): void {
    this.#abort.abort();
    this.#corner.dispose();
    this.#task.cancel();
  }

  #moveTo(at: ScreenPoint | null): void {
    this.#at = at;
    this.#task.request();
  }
}
