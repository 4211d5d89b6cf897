/**
 * A pinch on a trackpad in Safari, which tells it by gesture events of its own, as all other browsers tell it: by a wheel with Ctrl.
 * Unheard, the page itself would be zoomed.
 */
import { windowOf } from "./window-of.ts";

/** Not of any standard. `scale` is the pinch's since it began. */
interface SafariGesture extends MouseEvent {
  readonly scale: number;
}

/** What a wheel turns by where a pinch grows e-fold (Chromium's own, crrev.com/267822). */
const WHEEL_OF_E = 100;

/** Until `signal`. What listens for a wheel on `element` or around it hears of pinches, too. */
export function hearTrackpadPinches(element: HTMLElement, signal: AbortSignal): void {
  const fingers = new Set<number>();
  let before: number | null = null;
  // Fingers on glass make the same events, beside those of their own, which are pinches already.
  const early = { capture: true, signal };
  const window = windowOf(element);
  window.addEventListener(
    "pointerdown",
    (event) => event.pointerType === "touch" && fingers.add(event.pointerId),
    early,
  );
  for (const type of ["pointerup", "pointercancel"] as const)
    window.addEventListener(type, (event) => fingers.delete(event.pointerId), early);

  const hear = (type: string, take: (gesture: SafariGesture) => void): void =>
    element.addEventListener(
      type,
      (event) => {
        event.preventDefault();
        take(event as SafariGesture);
      },
      { signal },
    );
  hear("gesturestart", () => {
    before = fingers.size > 0 ? null : 1;
  });
  hear("gesturechange", ({ target, scale, clientX, clientY }) => {
    if (before === null || !(scale > 0)) return;
    const deltaY = -WHEEL_OF_E * Math.log(scale / before);
    before = scale;
    const step = { deltaY, ctrlKey: true, clientX, clientY, bubbles: true, cancelable: true, composed: true };
    target?.dispatchEvent(new WheelEvent("wheel", step));
  });
  hear("gestureend", () => {
    before = null;
  });
}
