/** Tells when an element is about to be seen. */
import { windowOf } from "../viewer/window-of.ts";

/** How far beyond the window it counts as about to be seen. */
const NEAR = "200px";

export class Sight {
  readonly #element: Element;
  readonly #near: () => void;
  #observer: IntersectionObserver | null = null;

  constructor(element: Element, near: () => void) {
    this.#element = element;
    this.#near = near;
  }

  watch(): void {
    this.end();
    this.#observer = new (windowOf(this.#element).IntersectionObserver)(
      (entries) => {
        if (entries.some(({ isIntersecting }) => isIntersecting)) this.#near();
      },
      { rootMargin: NEAR },
    );
    this.#observer.observe(this.#element);
  }

  end(): void {
    this.#observer?.disconnect();
    this.#observer = null;
  }
}
