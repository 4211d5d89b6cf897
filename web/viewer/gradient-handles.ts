/** The ends of a fill's gradient over the 3D view: dragged in the plane of the view, or moved by keys. */
import { Plane, Vector3 } from "three";
import type { Vec3 } from "../engine/engine-api.ts";
import { tupleOf } from "./decal-pose.ts";
import { FrameTask } from "./frame-task.ts";
import type { ScreenPoint, ScreenSpace } from "./screen-space.ts";
import type { SurfaceSample } from "./surface-query.ts";
import { takesBack } from "./take-back-key.ts";

/** Where a gradient goes over the model: model space, metres. */
export type GradientPlace =
  | { readonly kind: "linear"; readonly from: Vec3; readonly to: Vec3 }
  | { readonly kind: "radial"; readonly center: Vec3; readonly radius: number };

/** Of a drag: it goes on, ends, or is given up. "step": a key moved a handle. */
export type GradientPhase = "move" | "end" | "step" | "cancel";

export interface GradientHandlesHooks {
  /** What lies under a point of the view. */
  pick(at: ScreenPoint): SurfaceSample | null;
  /** Whether the model is drawn as it is at rest, where gradients lie. */
  atRest(): boolean;
  changed(place: GradientPlace, phase: GradientPhase): void;
}

/** The handles' names, the first for where the first colour is. */
export type GradientLabels = readonly [first: string, second: string];

/** CSS pixels that a key press moves a handle; with Shift ten times that. */
const KEY_STEP = 4;
const COARSE = 10;
/** Of the circle as it is drawn. */
const CIRCLE_POINTS = 64;
/** Where a circle's handle may sit, the first that is in view. */
const RIM_ANGLES = [0, 7, 1, 6, 2, 5, 3, 4].map((eighth) => (eighth * Math.PI) / 4);
/** CSS pixels from the view's border. */
const MARGIN = 24;
const ARROWS: Readonly<Record<string, readonly [right: number, up: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

interface HandleDrag {
  readonly pointerId: number;
  readonly handle: 0 | 1;
  readonly start: GradientPlace;
  /** From the pointer to the handle's middle. */
  readonly offset: ScreenPoint;
}

export class GradientHandles {
  readonly #root: HTMLElement;
  readonly #screen: ScreenSpace;
  readonly #hooks: GradientHandlesHooks;
  readonly #layer = document.createElement("div");
  readonly #buttons: readonly [HTMLButtonElement, HTMLButtonElement];
  readonly #lines: readonly SVGPathElement[];
  readonly #abort = new AbortController();
  readonly #task = new FrameTask(() => this.drawNow());
  #place: GradientPlace | null = null;
  #drag: HandleDrag | null = null;
  #enabled = true;
  /** Where on the circle its handle sits: radians from the right, counter-clockwise. */
  #rimAngle = 0;

  constructor(root: HTMLElement, screen: ScreenSpace, hooks: GradientHandlesHooks) {
    this.#root = root;
    this.#screen = screen;
    this.#hooks = hooks;
    const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    svg.classList.add("tcv-overlay");
    svg.setAttribute("aria-hidden", "true");
    this.#lines = ["tcv-casing", "tcv-outline"].map((name) => {
      const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
      path.setAttribute("class", name);
      svg.append(path);
      return path;
    });
    this.#buttons = [this.#makeButton(0), this.#makeButton(1)];
    this.#layer.className = "tcv-gradient";
    this.#layer.hidden = true;
    this.#layer.append(svg, ...this.#buttons);
    root.append(this.#layer);
    // Before the camera's and the decals' own: what is on a handle is the handle's.
    const early = { capture: true, signal: this.#abort.signal };
    root.addEventListener("pointerdown", (event) => this.#onDown(event), early);
    root.addEventListener("pointermove", (event) => this.#onMove(event), early);
    root.addEventListener("pointerup", (event) => this.#onEnd(event, "end"), early);
    root.addEventListener("pointercancel", (event) => this.#onEnd(event, "cancel"), early);
    // Whatever took the pointer, no release will be told.
    root.addEventListener("lostpointercapture", (event) => this.#onEnd(event, "end"), early);
    window.addEventListener("keydown", (event) => this.#onKey(event), early);
  }

  /** Null shows none. */
  show(place: GradientPlace | null, labels: GradientLabels): void {
    if (place === null && this.#place === null) return;
    if (place === null && this.#drag !== null) this.#stop();
    this.#place = place;
    for (const [index, button] of this.#buttons.entries()) {
      button.setAttribute("aria-label", labels[index] as string);
      button.title = labels[index] as string;
    }
    this.#task.request();
  }

  /** Not while a tool has the pointer. */
  set enabled(value: boolean) {
    this.#enabled = value;
    this.#task.request();
  }

  /** Draws in this turn: the camera has moved and the frame is being shown. */
  drawNow(): void {
    this.#task.cancel();
    const place = this.#enabled && this.#hooks.atRest() ? this.#place : null;
    const spots = place === null ? [] : this.#spotsOf(place).map((spot) => this.#screen.project(spot));
    this.#layer.hidden = place === null;
    for (const [index, button] of this.#buttons.entries()) {
      const spot = spots[index] ?? null;
      button.hidden = spot === null;
      if (spot !== null) button.style.transform = `translate(${spot.x.toFixed(1)}px, ${spot.y.toFixed(1)}px)`;
    }
    const line = place === null ? "" : this.#lineOf(place, spots);
    for (const path of this.#lines) path.setAttribute("d", line);
  }

  dispose(): void {
    this.#abort.abort();
    this.#task.cancel();
    this.#layer.remove();
  }

  #makeButton(handle: 0 | 1): HTMLButtonElement {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "tcv-gradient-handle";
    button.dataset.gradientHandle = handle === 0 ? "first" : "second";
    button.addEventListener("keydown", (event) => this.#onArrow(event, handle));
    return button;
  }

  /** The two ends; of a circle its middle and a place of its rim, one that is in view where there is one. */
  #spotsOf(place: GradientPlace): [Vector3, Vector3] {
    if (place.kind === "linear") return [new Vector3(...place.from), new Vector3(...place.to)];
    if (this.#drag === null && !this.#isInView(this.#rimSpot(place, this.#rimAngle))) {
      this.#rimAngle = RIM_ANGLES.find((angle) => this.#isInView(this.#rimSpot(place, angle))) ?? this.#rimAngle;
    }
    return [new Vector3(...place.center), this.#rimSpot(place, this.#rimAngle)];
  }

  #rimSpot({ center, radius }: Extract<GradientPlace, { kind: "radial" }>, angle: number): Vector3 {
    const { right, up } = this.#screen.axes;
    return new Vector3(...center)
      .addScaledVector(right, Math.cos(angle) * radius)
      .addScaledVector(up, Math.sin(angle) * radius);
  }

  #isInView(spot: Vector3): boolean {
    const at = this.#screen.project(spot);
    const { clientWidth: width, clientHeight: height } = this.#root;
    return at !== null && at.x > MARGIN && at.y > MARGIN && at.x < width - MARGIN && at.y < height - MARGIN;
  }

  #lineOf(place: GradientPlace, [first, second]: readonly (ScreenPoint | null | undefined)[]): string {
    if (place.kind === "linear") {
      return first && second ? `M${pair(first)}L${pair(second)}` : "";
    }
    const points = Array.from({ length: CIRCLE_POINTS }, (_, step) =>
      this.#screen.project(this.#rimSpot(place, (2 * Math.PI * step) / CIRCLE_POINTS)),
    );
    return points.every((point) => point !== null) ? `M${points.map(pair).join("L")}Z` : "";
  }

  #onDown(event: PointerEvent): void {
    const handle = this.#buttons.findIndex((button) => event.composedPath().includes(button));
    if (this.#drag !== null) {
      event.stopImmediatePropagation();
      return;
    }
    const place = this.#place;
    if ((handle !== 0 && handle !== 1) || place === null || event.button !== 0) return;
    event.stopImmediatePropagation();
    const pointer = this.#screen.pointOf(event.clientX, event.clientY);
    const spot = this.#screen.project(this.#spotsOf(place)[handle]) ?? pointer;
    this.#drag = {
      ...{ pointerId: event.pointerId, handle, start: place },
      offset: { x: spot.x - pointer.x, y: spot.y - pointer.y },
    };
    this.#buttons[handle].toggleAttribute("data-active", true);
    this.#buttons[handle].focus();
    this.#root.setPointerCapture(event.pointerId);
  }

  #onMove(event: PointerEvent): void {
    const drag = this.#drag;
    if (drag === null || drag.pointerId !== event.pointerId) return;
    event.stopImmediatePropagation();
    const { x, y } = this.#screen.pointOf(event.clientX, event.clientY);
    this.#move(drag.handle, { x: x + drag.offset.x, y: y + drag.offset.y }, event.altKey);
    if (this.#place !== null) this.#hooks.changed(this.#place, "move");
  }

  #onEnd(event: PointerEvent, phase: "end" | "cancel"): void {
    const drag = this.#drag;
    if (drag === null || drag.pointerId !== event.pointerId) return;
    event.stopImmediatePropagation();
    this.#stop();
    const place = phase === "cancel" ? drag.start : this.#place;
    // A press that moved nothing is no step.
    if (place !== null && (phase === "cancel" || place !== drag.start)) this.#hooks.changed(place, phase);
  }

  #onKey(event: KeyboardEvent): void {
    const drag = this.#drag;
    if (drag === null || !takesBack(event)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    this.#stop();
    this.#place = drag.start;
    this.#task.request();
    this.#hooks.changed(drag.start, "cancel");
  }

  #onArrow(event: KeyboardEvent, handle: 0 | 1): void {
    const arrow = ARROWS[event.key];
    const place = this.#place;
    if (arrow === undefined || place === null || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const spot = this.#screen.project(this.#spotsOf(place)[handle]);
    if (spot === null) return;
    const step = KEY_STEP * (event.shiftKey ? COARSE : 1);
    const isRadius = place.kind === "radial" && handle === 1;
    // A radius has one direction: right and up make it larger.
    const outward = (arrow[0] + arrow[1]) * step;
    const [right, down] = isRadius
      ? [Math.cos(this.#rimAngle) * outward, -Math.sin(this.#rimAngle) * outward]
      : [arrow[0] * step, -arrow[1] * step];
    this.#move(handle, { x: spot.x + right, y: spot.y + down }, false);
    if (this.#place !== null) this.#hooks.changed(this.#place, "step");
  }

  /** To a point of the view, as far from the eye as before; `snap` takes it to the surface that is seen there. */
  #move(handle: 0 | 1, to: ScreenPoint, snap: boolean): void {
    const place = this.#place;
    if (place === null) return;
    const spot = this.#spotsOf(place)[handle];
    const ray = this.#screen.rayThrough(to);
    const { right, up } = this.#screen.axes;
    const plane = new Plane().setFromNormalAndCoplanarPoint(right.clone().cross(up), spot);
    const surface = snap ? this.#hooks.pick(to) : null;
    const point = surface?.position ?? ray.intersectPlane(plane, new Vector3());
    if (point === null) return;
    if (place.kind === "linear") {
      this.#place = handle === 0 ? { ...place, from: tupleOf(point) } : { ...place, to: tupleOf(point) };
    } else if (handle === 0) {
      this.#place = { ...place, center: tupleOf(point) };
    } else {
      const center = new Vector3(...place.center);
      const way = point.clone().sub(center);
      if (this.#drag !== null) this.#rimAngle = Math.atan2(way.dot(up), way.dot(right));
      this.#place = { ...place, radius: Math.max(this.#screen.metresPerPixel(center), way.length()) };
    }
    this.#task.request();
  }

  #stop(): void {
    this.#drag = null;
    for (const button of this.#buttons) button.removeAttribute("data-active");
  }
}

const pair = (point: ScreenPoint | null): string => `${point?.x.toFixed(1)} ${point?.y.toFixed(1)}`;
