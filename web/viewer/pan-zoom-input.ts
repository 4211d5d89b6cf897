/** Wheel, drag, pinch and keys as zoom and pan: for the texture view. */
import type { TextureCamera } from "./texture-camera.ts";
import { hearTrackpadPinches } from "./trackpad-pinch.ts";

export interface PanZoomHooks {
  changed(): void;
  fit(): void;
}

/** Zoom of one wheel step of 100 units, and of one key press. */
const WHEEL_ZOOM = 1.22;
const KEY_ZOOM = 1.5;
/** A trackpad's pinch comes as small wheel steps with Ctrl. */
const PINCH_WHEEL_ZOOM = 2.6;
const KEY_PAN = 48;

export class PanZoomInput {
  readonly #element: HTMLElement;
  readonly #camera: TextureCamera;
  readonly #hooks: PanZoomHooks;
  readonly #abort = new AbortController();
  readonly #pointers = new Map<number, PointerEvent>();

  constructor(element: HTMLElement, camera: TextureCamera, hooks: PanZoomHooks) {
    this.#element = element;
    this.#camera = camera;
    this.#hooks = hooks;
    const { signal } = this.#abort;
    element.addEventListener("wheel", (event) => this.#onWheel(event), { signal, passive: false });
    hearTrackpadPinches(element, signal);
    element.addEventListener("pointerdown", (event) => this.#onDown(event), { signal });
    element.addEventListener("pointermove", (event) => this.#onMove(event), { signal });
    for (const type of ["pointerup", "pointercancel"] as const) {
      element.addEventListener(type, (event) => this.#onEnd(event), { signal });
    }
    element.addEventListener("dblclick", () => hooks.fit(), { signal });
    element.addEventListener("keydown", (event) => this.#onKey(event), { signal });
  }

  dispose(): void {
    this.#abort.abort();
  }

  #onWheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 33 : 1);
    const base = event.ctrlKey ? PINCH_WHEEL_ZOOM : WHEEL_ZOOM;
    const at = this.#place(event);
    this.#camera.zoomAt(base ** (-pixels / 100), at.x, at.y);
    this.#hooks.changed();
  }

  #onDown(event: PointerEvent): void {
    this.#element.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, event);
    this.#element.toggleAttribute("data-panning", true);
  }

  #onMove(event: PointerEvent): void {
    const before = this.#pointers.get(event.pointerId);
    if (before === undefined) {
      return;
    }
    const other = [...this.#pointers.values()].find((pointer) => pointer.pointerId !== event.pointerId);
    if (other === undefined) {
      this.#camera.panBy(event.clientX - before.clientX, event.clientY - before.clientY);
    } else {
      this.#pinch(before, event, other);
    }
    this.#pointers.set(event.pointerId, event);
    this.#hooks.changed();
  }

  /** The middle of both fingers stays on its texel, their distance is the zoom. */
  #pinch(before: PointerEvent, now: PointerEvent, other: PointerEvent): void {
    const span = (pointer: PointerEvent) =>
      Math.hypot(pointer.clientX - other.clientX, pointer.clientY - other.clientY);
    this.#camera.panBy((now.clientX - before.clientX) / 2, (now.clientY - before.clientY) / 2);
    const [a, b] = [this.#place(now), this.#place(other)];
    this.#camera.zoomAt(span(now) / Math.max(1, span(before)), (a.x + b.x) / 2, (a.y + b.y) / 2);
  }

  #onEnd(event: PointerEvent): void {
    this.#pointers.delete(event.pointerId);
    this.#element.toggleAttribute("data-panning", this.#pointers.size > 0);
  }

  #onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    const { clientWidth: width, clientHeight: height } = this.#element;
    const zoom = (factor: number) => this.#camera.zoomAt(factor, width / 2, height / 2);
    const steps: Record<string, () => void> = {
      "+": () => zoom(KEY_ZOOM),
      "=": () => zoom(KEY_ZOOM),
      "-": () => zoom(1 / KEY_ZOOM),
      "0": () => this.#hooks.fit(),
      ArrowLeft: () => this.#camera.panBy(KEY_PAN, 0),
      ArrowRight: () => this.#camera.panBy(-KEY_PAN, 0),
      ArrowUp: () => this.#camera.panBy(0, KEY_PAN),
      ArrowDown: () => this.#camera.panBy(0, -KEY_PAN),
    };
    const step = steps[event.key];
    if (step !== undefined) {
      step();
      this.#hooks.changed();
      event.preventDefault();
      // The page's own keys (nudging a decal) are not meant while this view has the focus.
      event.stopPropagation();
    }
  }

  #place(event: MouseEvent): { x: number; y: number } {
    const box = this.#element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }
}
