/**
 * Gestures of three and four fingers: a tap of three undoes, of four redoes; three that swipe to the left undo, to the
 * right redo. One and two fingers are the tools' and the camera's.
 */

export type FingerGesture = "undo" | "redo";

export interface Finger {
  readonly id: number;
  /** CSS pixels. */
  readonly x: number;
  readonly y: number;
  /** Milliseconds. */
  readonly time: number;
}

/** A tap is over sooner than this, milliseconds, and its fingers wander less than this, pixels. */
const TAP = 350;
const TAP_SLOP = 24;
/** A swipe goes farther than this, mostly sideways. */
const SWIPE = 60;

/** Told of each finger; says what their gesture means once the last of them is lifted. */
export class FingerGestures {
  readonly #fingers = new Map<number, { readonly start: Finger; last: Finger }>();
  /** The most fingers that were down at once, and those that were lifted since. */
  #most = 0;
  #lifted: { readonly start: Finger; readonly last: Finger }[] = [];

  down(finger: Finger): void {
    if (this.#fingers.size === 0) this.#begin();
    this.#fingers.set(finger.id, { start: finger, last: finger });
    this.#most = Math.max(this.#most, this.#fingers.size);
  }

  move(finger: Finger): void {
    const known = this.#fingers.get(finger.id);
    if (known) known.last = finger;
  }

  up(finger: Finger): FingerGesture | null {
    const known = this.#fingers.get(finger.id);
    if (!known) return null;
    this.#fingers.delete(finger.id);
    this.#lifted.push({ start: known.start, last: finger });
    return this.#fingers.size === 0 ? this.#meaning() : null;
  }

  /** The system took the fingers over. */
  cancel(): void {
    this.#fingers.clear();
    this.#begin();
  }

  #begin(): void {
    this.#most = 0;
    this.#lifted = [];
  }

  #meaning(): FingerGesture | null {
    if (this.#most < 3 || this.#most > 4) return null;
    const ways = this.#lifted.map(({ start, last }) => ({ x: last.x - start.x, y: last.y - start.y }));
    const begin = Math.min(...this.#lifted.map(({ start }) => start.time));
    const end = Math.max(...this.#lifted.map(({ last }) => last.time));
    if (end - begin <= TAP && ways.every(({ x, y }) => Math.hypot(x, y) <= TAP_SLOP)) {
      return this.#most === 3 ? "undo" : "redo";
    }
    const sideways = ways.every(({ x, y }) => Math.abs(x) >= SWIPE && Math.abs(x) > 2 * Math.abs(y));
    if (this.#most !== 3 || !sideways) return null;
    if (ways.every(({ x }) => x < 0)) return "undo";
    return ways.every(({ x }) => x > 0) ? "redo" : null;
  }
}

/** Listens to the fingers on an element. Returns what ends it. */
export function watchFingers(element: HTMLElement, run: (gesture: FingerGesture) => void): () => void {
  const gestures = new FingerGestures();
  const abort = new AbortController();
  const listen = (type: "pointerdown" | "pointermove" | "pointerup", act: (finger: Finger) => void): void =>
    element.addEventListener(
      type,
      (event) => {
        if (event.pointerType !== "touch" || !event.isTrusted) return;
        act({ id: event.pointerId, x: event.clientX, y: event.clientY, time: event.timeStamp });
      },
      // Before the views, which keep to themselves what they take.
      { capture: true, signal: abort.signal },
    );
  listen("pointerdown", (finger) => gestures.down(finger));
  listen("pointermove", (finger) => gestures.move(finger));
  listen("pointerup", (finger) => {
    const gesture = gestures.up(finger);
    if (gesture) run(gesture);
  });
  element.addEventListener("pointercancel", () => gestures.cancel(), { capture: true, signal: abort.signal });
  return () => abort.abort();
}
