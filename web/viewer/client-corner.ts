/**
 * Where a view's corner is in the page. Asked of the document once a press and not once an event: a drag changes the page in
 * each of its frames, and after a change each question makes the browser lay the page out then and there, and again for
 * the frame (0.6 ms of each frame in a drag).
 */
import type { ScreenPoint } from "./screen-space.ts";
import { windowOf } from "./window-of.ts";

export class ClientCorner {
  readonly #element: HTMLElement;
  readonly #abort = new AbortController();
  readonly #resize: ResizeObserver;
  #corner: ScreenPoint | null = null;

  constructor(element: HTMLElement) {
    this.#element = element;
    const forget = (): void => {
      this.#corner = null;
    };
    const window = windowOf(element);
    this.#resize = new window.ResizeObserver(forget);
    this.#resize.observe(element);
    const early = { capture: true, passive: true, signal: this.#abort.signal };
    for (const type of ["pointerdown", "scroll", "resize"] as const) {
      window.addEventListener(type, forget, early);
    }
    element.addEventListener("pointerenter", forget, early);
  }

  /** Where an event is in the view, CSS pixels. */
  pointOf(clientX: number, clientY: number): ScreenPoint {
    if (this.#corner === null) {
      const { left, top } = this.#element.getBoundingClientRect();
      this.#corner = { x: left, y: top };
    }
    return { x: clientX - this.#corner.x, y: clientY - this.#corner.y };
  }

  dispose(): void {
    this.#abort.abort();
    this.#resize.disconnect();
  }
}
