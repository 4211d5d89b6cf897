/** What is pressed takes the keyboard, as in all browsers but those on Apple's systems. */

/**
 * Safari leaves the keyboard where it was when a button, a switch or a slider is pressed: on nothing at all beside a mouse, so
 * that keys go to the page and not to the editor in it, and in the field that was typed in beside a finger, so that what was
 * typed there is not taken before what is pressed goes by it.
 *
 * Hears presses in `root` until `signal`.
 */
export function focusPressed(root: EventTarget, signal: AbortSignal): void {
  // Whoever prevents a press from it keeps the keyboard where it is, everywhere.
  let stays = false;
  const press = (event: Event): void => {
    stays = event.defaultPrevented;
  };
  root.addEventListener("mousedown", press, { signal });
  root.addEventListener(
    "click",
    (event) => {
      const pressed = event.composedPath().find((one) => one instanceof HTMLElement && one.matches("button, input"));
      if (!stays && pressed instanceof HTMLElement && !pressed.matches(":focus"))
        pressed.focus({ preventScroll: true });
      stays = false;
    },
    { capture: true, signal },
  );
}
