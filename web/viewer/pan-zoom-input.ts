/** Wheel, drag, pinch and keys as zoom and pan: for the texture view. */

import { keepFromBrowser } from "./browser-gestures.ts";
import { ClientCorner } from "./client-corner.ts";
import type { ScreenPoint } from "./screen-space.ts";
import type { TextureCamera } from "./texture-camera.ts";

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
  readonly #corner: ClientCorner;
  /** Where those that are down are in the view. */
  readonly #pointers = new Map<number, ScreenPoint>();

  constructor(element: HTMLElement, camera: TextureCamera, hooks: PanZoomHooks) {
    this.#element = element;
    this.#camera = camera;
    this.#hooks = hooks;
    this.#corner = new ClientCorner(element);
    const { signal } = this.#abort;
    element.addEventListener("wheel", (event) => this.#onWheel(event), { signal, passive: false });
    keepFromBrowser(element, signal);
    element.addEventListener("pointerdown", (event) => this.#onDown(event), { signal });
    element.addEventListener("pointermove", (event) => this.#onMove(event), { signal });
    // Where a dialog came between, no release is told.
    for (const type of ["pointerup", "pointercancel", "lostpointercapture"] as const) {
      element.addEventListener(type, (event) => this.#onEnd(event), { signal });
    }
    // The right button moves the texture, too, as it does the model.
    element.addEventListener("contextmenu", (event) => event.preventDefault(), { signal });
    element.addEventListener("dblclick", () => hooks.fit(), { signal });
    element.addEventListener("keydown", (event) => this.#onKey(event), { signal });
  }

  dispose(): void {
    this.#abort.abort();
    this.#corner.dispose();
  }

  #onWheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 33 : 1);
    const base = event.ctrlKey ? PINCH_WHEEL_ZOOM : WHEEL_ZOOM;
    this.#corner.forget();
    const at = this.#place(event);
    this.#camera.zoomAt(base ** (-pixels / 100), at.x, at.y);
    this.#hooks.changed();
  }

  #onDown(event: PointerEvent): void {
    this.#element.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, this.#place(event));
    this.#element.toggleAttribute("data-panning", true);
  }

  #onMove(event: PointerEvent): void {
    const before = this.#pointers.get(event.pointerId);
    if (before === undefined) {
      return;
    }
    const now = this.#place(event);
    const [, other] = [...this.#pointers].find(([id]) => id !== event.pointerId) ?? [];
    if (other === undefined) this.#camera.panBy(now.x - before.x, now.y - before.y);
    else this.#pinch(before, now, other);
    this.#pointers.set(event.pointerId, now);
    this.#hooks.changed();
  }

  /** The middle of both fingers stays on its texel, their distance is the zoom. */
  #pinch(before: ScreenPoint, now: ScreenPoint, other: ScreenPoint): void {
    const span = (point: ScreenPoint) => Math.hypot(point.x - other.x, point.y - other.y);
    this.#camera.panBy((now.x - before.x) / 2, (now.y - before.y) / 2);
    this.#camera.zoomAt(span(now) / Math.max(1, span(before)), (now.x + other.x) / 2, (now.y + other.y) / 2);
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

  #place({ clientX, clientY }: MouseEvent): ScreenPoint {
    return this.#corner.pointOf(clientX, clientY);
  }
}
