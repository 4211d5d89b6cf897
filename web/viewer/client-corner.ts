/**
 * Where a view's corner is in the page, and how large the page makes its pixels. Asked of the document once a press and not once
 * an event: a drag changes the page in each of its frames, and after a change each question makes the browser lay the page out
 * then and there, and again for the frame (0.6 ms of each frame in a drag).
 */
import type { ScreenPoint } from "./screen-space.ts";
import { windowOf } from "./window-of.ts";

export class ClientCorner {
  readonly #element: HTMLElement;
  readonly #abort = new AbortController();
  readonly #resize: ResizeObserver;
  /** `scale`: the view's own pixels for one of the window's, where a part of the page around it is scaled. */
  #corner: (ScreenPoint & { readonly scale: number }) | null = null;

  constructor(element: HTMLElement) {
    this.#element = element;
    const window = windowOf(element);
    this.#resize = new window.ResizeObserver(this.forget);
    this.#resize.observe(element);
    const early = { capture: true, passive: true, signal: this.#abort.signal };
    for (const type of ["pointerdown", "scroll", "resize"] as const) {
      window.addEventListener(type, this.forget, early);
    }
    element.addEventListener("pointerenter", this.forget, early);
  }

  /** Where an event is in the view, CSS pixels. */
  pointOf(clientX: number, clientY: number): ScreenPoint {
    if (this.#corner === null) {
      const { left, top, width } = this.#element.getBoundingClientRect();
      // As `scaleOf`, which would cost a shop's first touch 25 bytes.
      this.#corner = { x: left, y: top, scale: Number((this.#element.offsetWidth / width).toFixed(2)) || 1 };
    }
    const { x, y, scale } = this.#corner;
    return { x: (clientX - x) * scale, y: (clientY - y) * scale };
  }

  /** It may be elsewhere by now. */
  readonly forget = (): void => {
    this.#corner = null;
  };

  dispose(): void {
    this.#abort.abort();
    this.#resize.disconnect();
  }
}
