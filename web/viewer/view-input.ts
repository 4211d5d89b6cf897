/**
 * Pointer and keys of the 3D view: tells presses on decals from those for the camera. Listens before the camera's
 * controls do and keeps from them what belongs to a decal.
 */
import type { Ray } from "three";
import type { PictureGrab } from "./box-drag.ts";
import { keepFromBrowser } from "./browser-gestures.ts";
import type { DecalGizmo } from "./decal-gizmo.ts";
import { FrameTask } from "./frame-task.ts";
import type { DragPointer } from "./gizmo-drag.ts";
import type { HandleName } from "./gizmo-overlay.ts";
import { heldToAxis } from "./held-to-axis.ts";
import type { ScreenPoint, ScreenSpace } from "./screen-space.ts";
import type { SurfaceSample } from "./surface-query.ts";
import { takesBack } from "./take-back-key.ts";
import type { ViewerDecal } from "./viewer-api.ts";
import { windowOf } from "./window-of.ts";

export interface ViewInputHooks {
  /** What a ray of the view meets, told as it lies at rest. */
  pick(ray: Ray): SurfaceSample | null;
  /** Whether an animation has posed the model: rays say nothing about the resting one then. */
  isPosed(): boolean;
  select(id: string | null): void;
  hover(sample: SurfaceSample | null): void;
  /** The next press of the left button pans instead of turning. */
  setPanning(pans: boolean): void;
}

/** A press that has not become a drag yet. */
interface Press {
  readonly event: PointerEvent;
  readonly decal: ViewerDecal | null;
  readonly grab: PictureGrab | null;
  /** What a release without a drag selects; undefined leaves the selection. */
  readonly onClick: string | null | undefined;
}

/** Pixels that a press may wander and still be a click. */
const MOUSE_SLOP = 3;
const TOUCH_SLOP = 8;

export class ViewInput {
  readonly #root: HTMLElement;
  readonly #gizmo: DecalGizmo;
  readonly #screen: ScreenSpace;
  readonly #hooks: ViewInputHooks;
  readonly #hoverTask = new FrameTask(() => this.#hoverNow());
  readonly #abort = new AbortController();
  #press: Press | null = null;
  #dragPointer: PointerEvent | null = null;
  /** Where the press was that a slide began with; null in a drag of a handle. */
  #slideFrom: ScreenPoint | null = null;
  /** The press of a finger that has not left its place on a handle: a tap changes nothing. */
  #restingTouch: PointerEvent | null = null;
  #hoverEvent: PointerEvent | null = null;
  #spaceHeld = false;
  #pointerInside = false;
  /** A tool has the pointer: decals are neither pressed nor hovered. */
  #suspended = false;
  /** A finger is down beside the decals: the camera's, and so are those that come to it. */
  #turns = false;
  /** A press that is handed to the camera after all comes by here a second time. */
  #passOn: Event | null = null;

  constructor(root: HTMLElement, gizmo: DecalGizmo, screen: ScreenSpace, hooks: ViewInputHooks) {
    this.#root = root;
    this.#gizmo = gizmo;
    this.#screen = screen;
    this.#hooks = hooks;
    const early = { capture: true, signal: this.#abort.signal };
    root.addEventListener("pointerdown", (event) => this.#onDown(event), early);
    root.addEventListener("pointermove", (event) => this.#onMove(event), early);
    root.addEventListener("pointerup", (event) => this.#onUp(event), early);
    root.addEventListener("pointercancel", (event) => this.#onCancel(event), early);
    root.addEventListener("lostpointercapture", (event) => this.#onLost(event), early);
    root.addEventListener("pointerleave", () => this.#onLeave(), { signal: this.#abort.signal });
    keepFromBrowser(root, this.#abort.signal);
    const window = windowOf(root);
    window.addEventListener("keydown", (event) => this.#onKey(event, true), early);
    window.addEventListener("keyup", (event) => this.#onKey(event, false), early);
    window.addEventListener("blur", () => this.#setSpace(false), early);
  }

  set suspended(value: boolean) {
    this.#suspended = value;
    this.#press = null;
    this.#gizmo.hoverHandle(null);
    this.#setCursor("");
  }

  dispose(): void {
    this.#abort.abort();
    this.#hoverTask.cancel();
  }

  #onDown(event: PointerEvent): void {
    if (event === this.#passOn) {
      return;
    }
    const first = this.#press?.grab ? this.#press.event : this.#dragPointer;
    // The hand lies down before its pen does.
    if (event.pointerType === "pen" && first?.pointerType === "touch") {
      this.#gizmo.cancel();
      this.#dragPointer = null;
    } else if (first !== null) {
      this.#onSecondPointer(first, event);
      return;
    }
    this.#press = null;
    if (this.#turns && !event.isPrimary) {
      return;
    }
    this.#turns = false;
    this.#restingTouch = null;
    // What is lit up under the pointer would tint what the press is about.
    this.#hoverTask.cancel();
    this.#hooks.hover(null);
    if (event.button !== 0 || this.#spaceHeld) {
      this.#hooks.setPanning(false);
      return;
    }
    if (this.#suspended) {
      this.#hooks.setPanning(event.shiftKey);
      return;
    }
    const handle = this.#handleAt(event);
    if (handle !== null && this.#startHandle(handle, event)) {
      return;
    }
    this.#press = this.#pressAt(event);
    if (this.#press.grab !== null) {
      this.#take(event);
    } else {
      this.#turns = true;
      this.#hooks.setPanning(event.shiftKey);
    }
  }

  #pressAt(event: PointerEvent): Press {
    const pointer = this.#pointerOf(event);
    const sample = this.#hooks.pick(pointer.ray);
    const [top = null] = sample === null ? [] : this.#gizmo.decalsAt(sample);
    // What is selected is meant, even where another lies over it; a click alone goes to the topmost.
    const held = this.#gizmo.heldAt(pointer, sample);
    if (held !== null) {
      return { event, ...held, onClick: top?.id };
    }
    if (top !== null && sample !== null) {
      this.#hooks.select(top.id);
      return { event, decal: top, grab: top.locked === true ? null : sample, onClick: undefined };
    }
    return { event, decal: null, grab: null, onClick: null };
  }

  /** As a click that came and went before there were hands. */
  clickAt(clientX: number, clientY: number): void {
    if (this.#suspended) {
      return;
    }
    const { onClick } = this.#pressAt(new PointerEvent("pointerdown", { clientX, clientY }));
    if (onClick !== undefined) {
      this.#hooks.select(onClick);
    }
  }

  #handleAt({ clientX, clientY, pointerType }: PointerEvent): HandleName | null {
    return this.#gizmo.handleAt(this.#screen.pointOf(clientX, clientY), pointerType);
  }

  #startHandle(handle: HandleName, event: PointerEvent): boolean {
    if (!this.#gizmo.startHandle(handle, this.#pointerOf(event))) {
      return false;
    }
    this.#dragPointer = event;
    this.#slideFrom = null;
    this.#restingTouch = event.pointerType === "touch" ? event : null;
    this.#take(event);
    return true;
  }

  /** A second finger on a decal that is held turns the press into the camera's pinch. A palm beside a pen is nobody's. */
  #onSecondPointer(first: PointerEvent, event: PointerEvent): void {
    if (event.pointerType !== "touch" || first.pointerType !== "touch") {
      event.stopImmediatePropagation();
      return;
    }
    this.#gizmo.finish();
    this.#press = null;
    this.#dragPointer = null;
    this.#turns = true;
    const again = new PointerEvent("pointerdown", first);
    this.#passOn = again;
    this.#root.dispatchEvent(again);
    this.#passOn = null;
  }

  #onMove(event: PointerEvent): void {
    this.#pointerInside = true;
    if (this.#press !== null && this.#press.event.pointerId === event.pointerId) {
      this.#maybeStartSlide(this.#press, event);
    }
    if (this.#dragPointer !== null) {
      event.stopImmediatePropagation();
      if (this.#dragPointer.pointerId === event.pointerId) {
        this.#dragPointer = event;
        this.#followPointer(event);
      }
    } else if (event.buttons === 0 && event.pointerType !== "touch" && !this.#suspended) {
      this.#hoverEvent = event;
      this.#hoverTask.request();
    }
  }

  #maybeStartSlide(press: Press, event: PointerEvent): void {
    const slop = event.pointerType === "touch" ? TOUCH_SLOP : MOUSE_SLOP;
    if (distance(press.event, event) <= slop) {
      return;
    }
    this.#press = null;
    if (press.decal !== null && press.grab !== null) {
      this.#dragPointer = event;
      this.#slideFrom = this.#screen.pointOf(press.event.clientX, press.event.clientY);
      this.#gizmo.startSlide(press.decal, press.grab);
    }
  }

  #followPointer(event: PointerEvent): void {
    if (this.#restingTouch !== null && distance(this.#restingTouch, event) <= TOUCH_SLOP) return;
    this.#restingTouch = null;
    this.#gizmo.moveTo(this.#pointerOf(event, this.#slideFrom));
  }

  #onUp(event: PointerEvent): void {
    this.#turns = false;
    if (this.#dragPointer?.pointerId === event.pointerId) {
      event.stopImmediatePropagation();
      this.#followPointer(event);
      this.#gizmo.finish();
      this.#dragPointer = null;
    }
    const press = this.#press;
    if (press?.event.pointerId === event.pointerId) {
      this.#press = null;
      if (press.onClick !== undefined) {
        this.#hooks.select(press.onClick);
      }
    }
  }

  #onCancel(event: PointerEvent): void {
    if (this.#dragPointer?.pointerId === event.pointerId) {
      this.#gizmo.cancel();
      this.#dragPointer = null;
    }
    this.#press = null;
    this.#turns = false;
  }

  /** A dialog came between, or the view was moved: no release will be told, and the decal or the camera would hang on the pointer. */
  #onLost(event: PointerEvent): void {
    if (this.#dragPointer?.pointerId === event.pointerId) {
      this.#gizmo.finish();
      this.#dragPointer = null;
    }
    if (this.#press?.event.pointerId === event.pointerId) this.#press = null;
    // The camera's controls would go on turning under a pointer that presses nothing.
    if (this.#turns) this.#root.dispatchEvent(new PointerEvent("pointerup", event));
  }

  #onLeave(): void {
    this.#pointerInside = false;
    this.#hoverEvent = null;
    this.#hoverTask.cancel();
    if (this.#dragPointer === null) {
      this.#gizmo.hoverHandle(null);
      this.#gizmo.hover(null);
      this.#hooks.hover(null);
    }
  }

  #onKey(event: KeyboardEvent, down: boolean): void {
    if (down && takesBack(event) && this.#gizmo.cancel()) {
      this.#dragPointer = null;
      event.preventDefault();
      event.stopImmediatePropagation();
    }
    if (event.code === "Space" && !isControl(event.composedPath()[0])) {
      this.#setSpace(down);
      // The page would scroll, and a press of a space bar over the view is the camera's.
      if (this.#pointerInside && !this.#suspended) {
        event.preventDefault();
      }
    }
    if ((event.key === "Alt" || event.key === "Shift") && this.#dragPointer !== null) {
      event.preventDefault();
      this.#gizmo.moveTo(this.#pointerOf(this.#dragPointer, this.#slideFrom, event));
    }
  }

  #setSpace(held: boolean): void {
    this.#spaceHeld = held;
    this.#setCursor(held ? "orbit" : "");
  }

  #hoverNow(): void {
    const event = this.#hoverEvent;
    if (event === null || this.#dragPointer !== null || this.#suspended) {
      return;
    }
    const { ray } = this.#pointerOf(event);
    const sample = this.#hooks.pick(ray);
    const handle = this.#spaceHeld ? null : this.#handleAt(event);
    const onHandle = handle !== null;
    this.#gizmo.hoverHandle(handle);
    const [top = null] = sample === null || onHandle ? [] : this.#gizmo.decalsAt(sample);
    const held = onHandle ? null : this.#gizmo.heldAt(this.#pointerOf(event), sample);
    this.#gizmo.hover(held === null ? top : null);
    const movable = held !== null || (top !== null && top.locked !== true);
    this.#setCursor(this.#spaceHeld ? "orbit" : onHandle ? "handle" : movable ? "move" : "");
    this.#hooks.hover(sample);
  }

  #setCursor(cursor: string): void {
    this.#root.dataset.cursor = cursor;
  }

  /** Keeps a pointer's events for the gizmo, wherever it goes. */
  #take(event: PointerEvent): void {
    event.stopImmediatePropagation();
    this.#root.setPointerCapture(event.pointerId);
  }

  /** @param from Where a slide began, which Shift holds to an axis. */
  #pointerOf(
    event: PointerEvent,
    from: ScreenPoint | null = null,
    { altKey, shiftKey }: PointerEvent | KeyboardEvent = event,
  ): DragPointer & { at: ScreenPoint } {
    const point = this.#screen.pointOf(event.clientX, event.clientY);
    const at = from && shiftKey ? heldToAxis(from, point) : point;
    const ray = this.#screen.rayThrough(at);
    const posed = this.#hooks.isPosed() ? { met: this.#hooks.pick(ray) } : {};
    return { at, ray, alt: altKey, shift: shiftKey, ...posed };
  }
}

function distance(from: PointerEvent, to: PointerEvent): number {
  return Math.hypot(to.clientX - from.clientX, to.clientY - from.clientY);
}

/** Keys typed into these are theirs. `target` is the innermost one, inside shadow trees, too. */
function isControl(target: EventTarget | undefined): boolean {
  return target instanceof Element && target.closest("input, textarea, select, button, a, [contenteditable]") !== null;
}
