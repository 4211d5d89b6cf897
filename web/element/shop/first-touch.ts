/**
 * What a hand does on the view before there are hands: kept, and done again when they come, so that the first touch is not
 * lost. A pointer that is still down goes on from where it went down; one that came and went was a click.
 */
import type { DecalViewer } from "../../viewer/viewer-api.ts";
import { windowOf } from "../../viewer/window-of.ts";

/** Pixels that a press may wander and still be a click. */
const SLOP = 8;
/** Of a wheel that is turned meanwhile no more are done again. */
const MOST_STEPS = 30;

interface Press {
  readonly down: PointerEvent;
  newest: PointerEvent;
}

export class FirstTouch {
  readonly #view: HTMLElement;
  readonly #abort = new AbortController();
  readonly #presses = new Map<number, Press>();
  #click: PointerEvent | null = null;
  #steps: WheelEvent[] = [];

  /** @param touched somebody is about to touch the view, or does */
  constructor(view: HTMLElement, touched: () => void) {
    this.#view = view;
    const { signal } = this.#abort;
    view.addEventListener("pointerenter", touched, { signal });
    view.addEventListener("pointerdown", (event) => this.#down(event), { signal });
    view.addEventListener(
      "wheel",
      (event) => {
        touched();
        event.preventDefault();
        if (this.#steps.length < MOST_STEPS) this.#steps.push(event);
      },
      { signal, passive: false },
    );
    // Wherever it goes: what is pressed may be let go beside the view.
    const window = windowOf(view);
    window.addEventListener("pointermove", (event) => this.#move(event), { signal });
    window.addEventListener("pointerup", (event) => this.#up(event), { signal });
    window.addEventListener("pointercancel", (event) => this.#presses.delete(event.pointerId), { signal });
    view.addEventListener("pointerdown", touched, { signal });
  }

  /** Does again what was done; to be called once. */
  giveTo(viewer: DecalViewer): void {
    this.stop();
    const presses = [...this.#presses.values()];
    // Every finger is down before one of them moves: two of them are a pinch, and not a drag with a second finger on it.
    for (const { down } of presses) this.#view.dispatchEvent(new PointerEvent("pointerdown", down));
    for (const { down, newest } of presses) {
      if (newest !== down) this.#view.dispatchEvent(new PointerEvent("pointermove", newest));
    }
    if (this.#presses.size === 0 && this.#click !== null) viewer.clickAt(this.#click.clientX, this.#click.clientY);
    for (const step of this.#steps) this.#view.dispatchEvent(new WheelEvent("wheel", step));
  }

  stop(): void {
    this.#abort.abort();
  }

  #down(event: PointerEvent): void {
    this.#click = null;
    this.#presses.set(event.pointerId, { down: event, newest: event });
  }

  #move(event: PointerEvent): void {
    const press = this.#presses.get(event.pointerId);
    if (press) press.newest = event;
  }

  #up(event: PointerEvent): void {
    const press = this.#presses.get(event.pointerId);
    if (!press) return;
    this.#presses.delete(event.pointerId);
    const { down } = press;
    const isClick = Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) <= SLOP;
    if (isClick && down.button === 0) this.#click = down;
  }
}
