/**
 * What a browser itself would do with a press, a wheel or a pinch on a view. A press of the middle button would scroll the page from
 * then on (autoscroll, on Windows), a wheel that turns in the midst of a press would scroll it too, and a press where the page around is
 * selected, or can be dragged (`draggable`), would take that along and end the view's own drag. A pinch on a trackpad would zoom the
 * page in Safari, which tells it by gesture events of its own: it is told as all other browsers tell it, by a wheel with Ctrl.
 */
import { windowOf } from "./window-of.ts";

/** Not of any standard. `scale` is the pinch's since it began. */
interface SafariGesture extends MouseEvent {
  readonly scale: number;
}

/** What a wheel turns by where a pinch grows e-fold (Chromium's own, crrev.com/267822). */
const WHEEL_OF_E = 100;

/** Until `signal`. What listens for a wheel on `element` or around it hears of pinches, too. */
export function keepFromBrowser(element: HTMLElement, signal: AbortSignal): void {
  const fingers = new Set<number>();
  let before: number | null = null;
  // Fingers on glass make the same events, beside those of their own, which are pinches already.
  const early = { capture: true, signal };
  const window = windowOf(element);
  window.addEventListener(
    "pointerdown",
    (event) => {
      const isTouch = event.pointerType === "touch";
      // What can be dragged itself is dragged in the place of what it stands in. A finger's long press would lift it.
      element.draggable = !isTouch;
      if (isTouch) fingers.add(event.pointerId);
    },
    early,
  );
  for (const type of ["pointerup", "pointercancel"] as const)
    window.addEventListener(type, (event) => fingers.delete(event.pointerId), early);

  const hear = (type: string, take?: (gesture: SafariGesture) => unknown): void =>
    element.addEventListener(
      type,
      (event) => {
        if (take?.(event as SafariGesture) !== false) event.preventDefault();
      },
      { signal },
    );
  hear("mousedown", ({ button }) => button === 1);
  hear("dragstart");
  hear("wheel");
  hear("gesturestart", () => {
    before = fingers.size ? null : 1;
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
