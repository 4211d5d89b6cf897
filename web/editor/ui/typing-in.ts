/** Whether somebody types in a part of the page, for what would lie over it. */
import type { LitElement, ReactiveController } from "lit";
import { windowOf } from "../../viewer/window-of.ts";
import { focusedIn } from "./open-field.ts";

/**
 * Known at each update of its host, and the host is updated when the typing may have ended. Whoever goes on to the host from the field
 * has not ended it: what is pressed there must not move.
 */
export class TypingIn implements ReactiveController {
  readonly #host: LitElement;
  readonly #part: string;
  #watching = new AbortController();
  now = false;

  /** @param part name of the elements in whose fields it counts */
  constructor(host: LitElement, part: string) {
    this.#host = host;
    this.#part = part;
    host.addController(this);
  }

  hostUpdate(): void {
    const focused = focusedIn(this.#host.ownerDocument);
    const before = this.now;
    if (!isWithin(focused, (element) => element === this.#host)) {
      this.now =
        focused?.matches("input, textarea") === true && isWithin(focused, ({ localName }) => localName === this.#part);
    }
    if (this.now === before) return;
    this.#watching.abort();
    if (this.now) this.#watch();
  }

  hostDisconnected(): void {
    this.#watching.abort();
    this.now = false;
  }

  /** Where the focus goes from one part of the page to another, no event of it leaves the page's own root. */
  #watch(): void {
    this.#watching = new AbortController();
    const page = windowOf(this.#host);
    for (const type of ["focusout", "click", "keyup"]) {
      page.addEventListener(type, () => this.#host.requestUpdate(), { capture: true, signal: this.#watching.signal });
    }
  }
}

/** Whether an element is one of those, or lies in one, through however many shadow roots. */
function isWithin(element: Element | null, isOne: (element: Element) => boolean): boolean {
  for (let at: Node | null = element; at !== null; at = at instanceof ShadowRoot ? at.host : at.parentNode) {
    if (at instanceof Element && isOne(at)) return true;
  }
  return false;
}
