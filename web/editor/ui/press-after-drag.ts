/** The first press after something was dragged and dropped, which Safari does not tell as one. */

/** The pointer of a mouse, in WebKit. */
const MOUSE = 1;

/**
 * A drag takes the pointer that pressed, and all browsers but Safari tell its end then. Safari holds it for pressed, and tells the
 * next press as a move (bugs.webkit.org/show_bug.cgi?id=202287): a decal that was dropped could be taken hold of at the second try
 * alone. After each drag that begins in `root`, a mouse's press that came without its `pointerdown` gets one.
 *
 * Hears drags in `root` until `signal`.
 */
export function tellPressAfterDrag(root: EventTarget, signal: AbortSignal): void {
  root.addEventListener(
    "dragend",
    () => {
      const told = new AbortController();
      const options = { capture: true, signal: told.signal };
      root.addEventListener("pointerdown", () => told.abort(), options);
      root.addEventListener(
        "mousedown",
        (event) => {
          told.abort();
          event.composedPath()[0]?.dispatchEvent(pressOf(event as MouseEvent));
        },
        options,
      );
    },
    { signal },
  );
}

function pressOf(event: MouseEvent): PointerEvent {
  const { view, screenX, screenY, clientX, clientY, ctrlKey, shiftKey, altKey, metaKey, button, buttons } = event;
  return new PointerEvent("pointerdown", {
    ...{ bubbles: true, cancelable: true, composed: true },
    ...{ view, screenX, screenY, clientX, clientY, ctrlKey, shiftKey, altKey, metaKey, button, buttons },
    ...{ pointerId: MOUSE, pointerType: "mouse", isPrimary: true, pressure: 0.5 },
  });
}
