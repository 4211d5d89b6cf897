/** The keyboard is somewhere after every key, and in a window that has become another: also where that took away what had it. */
import { focusedIn } from "./open-field.ts";

export interface HeldKeyboard {
  /** To be called whenever something of the page may have been taken away. */
  readonly look: () => void;
  /** To be called before something is without a key, as when the window becomes another. */
  readonly hold: (ownerDocument: Document) => void;
}

/**
 * Escape leaves the layer whose fields these were, Alt 3 the view that was looked at: browsers give the keyboard to nothing then, and the
 * next Tab begins at the top of the page. It goes to what `next` names instead. A pointer says itself where it goes on.
 *
 * Hears keys in `root` until `signal`.
 */
export function holdKeyboard(root: EventTarget, next: () => HTMLElement, signal: AbortSignal): HeldKeyboard {
  let held: HTMLElement | null = null;
  let asked = false;
  const look = (): void => {
    asked = false;
    if (held === null || signal.aborted) return;
    const { ownerDocument } = held;
    const focused = focusedIn(ownerDocument);
    // What is hidden has no place; Chromium takes the keyboard from it some frames later.
    if (focused !== null && focused !== ownerDocument.body && focused.getClientRects().length > 0) return;
    held = null;
    next().focus({ preventScroll: true });
  };
  // What is shown of a change is there in its frame.
  const lookSoon = (): void => {
    if (held === null || asked) return;
    asked = true;
    requestAnimationFrame(() => requestAnimationFrame(look));
  };
  const hold = (ownerDocument: Document): void => {
    const focused = focusedIn(ownerDocument);
    held = focused === ownerDocument.body ? null : focused;
    lookSoon();
  };
  root.addEventListener(
    "keydown",
    (event) => {
      const { target, key } = event as KeyboardEvent;
      // Tab may leave the page, for the browser's own bars.
      if (key === "Tab") held = null;
      else hold((target as Node | null)?.ownerDocument ?? document);
    },
    { capture: true, signal },
  );
  root.addEventListener(
    "pointerdown",
    () => {
      held = null;
    },
    { capture: true, signal },
  );
  return { look: lookSoon, hold };
}
