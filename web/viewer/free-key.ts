/** Whether Ctrl or Cmd is held, which leaves what is dragged where the pointer has it. */
import { windowOf } from "./window-of.ts";

export class FreeKey {
  readonly #abort = new AbortController();
  #held = false;

  constructor(root: HTMLElement) {
    const seenIn = windowOf(root);
    const options = { capture: true, signal: this.#abort.signal };
    const follow = ({ ctrlKey, metaKey }: KeyboardEvent | PointerEvent): void => {
      this.#held = ctrlKey || metaKey;
    };
    seenIn.addEventListener("keydown", follow, options);
    seenIn.addEventListener("keyup", follow, options);
    // A key that is let go in another window is told nobody.
    root.addEventListener("pointermove", follow, options);
  }

  get held(): boolean {
    return this.#held;
  }

  dispose(): void {
    this.#abort.abort();
  }
}
