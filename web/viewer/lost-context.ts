/** Waits for the graphics that the browser has taken away from a canvas. */

/** Milliseconds after which they are not waited for in silence; most are back in one or two seconds. */
const GONE_AFTER = 5000;

export class LostContext {
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** Browsers take the graphics from pages that nobody looks at, and give them back when somebody does. */
  wait(gone: () => void): void {
    const unseen = document.hidden;
    this.#timer = setTimeout(() => (unseen || document.hidden ? this.wait(gone) : gone()), GONE_AFTER);
  }

  /** They are back, or nobody waits for them any more. */
  end(): void {
    clearTimeout(this.#timer);
  }
}
