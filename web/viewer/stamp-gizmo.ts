/** The selected flat stamp in the texture view: its border, its handles, and drags of both. */
import type { UvProjector } from "../engine/engine-api.ts";
import { ClientCorner } from "./client-corner.ts";
import { sideOf } from "./gizmo-drag.ts";
import { GizmoOverlay, type GizmoPicture, type HandleName, type HandlePlace } from "./gizmo-overlay.ts";
import { degreesOf, line, resizeCursor } from "./gizmo-picture.ts";
import type { ScreenPoint } from "./screen-space.ts";
import { movedStamp, scaledStamp, stampHolds, turnedStamp, type Uv, uvOfStamp } from "./stamp-drag.ts";
import { takesBack } from "./take-back-key.ts";
import type { DecalGesture, ViewerDecal } from "./viewer-api.ts";

export interface StampGizmoHooks {
  pixelOf(uv: Uv): ScreenPoint;
  uvOf(x: number, y: number): Uv;
  gesture(gesture: DecalGesture): void;
}

/** Where the handles sit on the picture; y up. */
const PLACES: readonly (readonly [Exclude<HandleName, "rotate" | "depth" | "near" | "far">, number, number])[] = [
  ["sw", -0.5, -0.5],
  ["se", 0.5, -0.5],
  ["ne", 0.5, 0.5],
  ["nw", -0.5, 0.5],
  ["s", 0, -0.5],
  ["e", 0.5, 0],
  ["n", 0, 0.5],
  ["w", -0.5, 0],
];
/** CSS pixels. */
const STEM = 28;
const LEAST_EDGE = 60;

interface StampDrag {
  readonly id: string;
  readonly pointerId: number;
  readonly kind: DecalGesture["kind"];
  readonly handle: HandleName | null;
  readonly start: UvProjector;
  readonly from: Uv;
  projector: UvProjector;
}

export class StampGizmo {
  readonly #root: HTMLElement;
  readonly #hooks: StampGizmoHooks;
  readonly #overlay: GizmoOverlay;
  readonly #corner: ClientCorner;
  readonly #abort = new AbortController();
  #decal: ViewerDecal | null = null;
  #drag: StampDrag | null = null;

  constructor(root: HTMLElement, hooks: StampGizmoHooks) {
    this.#root = root;
    this.#hooks = hooks;
    this.#overlay = new GizmoOverlay(root);
    this.#corner = new ClientCorner(root);
    const early = { capture: true, signal: this.#abort.signal };
    root.addEventListener("pointerdown", (event) => this.#onDown(event), early);
    root.addEventListener("pointermove", (event) => this.#onMove(event), early);
    root.addEventListener("pointerup", (event) => this.#onEnd(event, "end"), early);
    root.addEventListener("pointercancel", (event) => this.#onEnd(event, "cancel"), early);
    window.addEventListener("keydown", (event) => this.#onKey(event), early);
  }

  /** Null, and decals of other kinds, show nothing. */
  set decal(decal: ViewerDecal | null) {
    this.#decal = decal?.projector.kind === "uv" ? decal : null;
    if (this.#drag !== null && this.#drag.id !== this.#decal?.id) this.#stop();
    this.draw();
  }

  /** Again, where the view was zoomed or panned. */
  draw(): void {
    const stamp = this.#stamp;
    this.#overlay.draw(stamp === null ? null : this.#pictureOf(stamp));
  }

  dispose(): void {
    this.#abort.abort();
    this.#corner.dispose();
    this.#overlay.dispose();
  }

  get #stamp(): UvProjector | null {
    const projector = this.#drag?.projector ?? this.#decal?.projector;
    return projector?.kind === "uv" ? projector : null;
  }

  #onDown(event: PointerEvent): void {
    const [decal, start] = [this.#decal, this.#stamp];
    if (decal === null || start === null || decal.locked === true || event.button !== 0) return;
    if (this.#drag !== null) {
      event.stopImmediatePropagation();
      return;
    }
    const handle = this.#overlay.handleAt(event.target);
    const from = this.#uvOf(event);
    if (handle === null && !stampHolds(start, from)) return;
    event.stopImmediatePropagation();
    this.#root.setPointerCapture(event.pointerId);
    const kind = handle === null ? "slide" : handle === "rotate" ? "rotate" : "scale";
    const { pointerId } = event;
    this.#drag = { id: decal.id, pointerId, kind, handle, start, from, projector: start };
    this.#root.dataset.gesture = kind;
    this.#overlay.startGesture(handle);
    this.#tell(this.#drag, "start");
  }

  #onMove(event: PointerEvent): void {
    const drag = this.#drag;
    if (drag === null || drag.pointerId !== event.pointerId) return;
    event.stopImmediatePropagation();
    drag.projector = dragged(drag, this.#uvOf(event), event);
    this.#tell(drag, "move");
    this.draw();
  }

  #onEnd(event: PointerEvent, phase: "end" | "cancel"): void {
    const drag = this.#drag;
    if (drag === null || drag.pointerId !== event.pointerId) return;
    event.stopImmediatePropagation();
    this.#stop();
    this.#tell(drag, phase);
  }

  #onKey(event: KeyboardEvent): void {
    const drag = this.#drag;
    if (drag === null || !takesBack(event)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    this.#stop();
    drag.projector = drag.start;
    this.#tell(drag, "cancel");
  }

  #stop(): void {
    this.#drag = null;
    delete this.#root.dataset.gesture;
    this.#overlay.endGesture();
    this.draw();
  }

  #tell({ id, kind, projector }: StampDrag, phase: DecalGesture["phase"]): void {
    this.#hooks.gesture({ id, kind, phase, projector, material: null });
  }

  #uvOf(event: PointerEvent): Uv {
    const { x, y } = this.#corner.pointOf(event.clientX, event.clientY);
    return this.#hooks.uvOf(x, y);
  }

  #pictureOf(stamp: UvProjector): GizmoPicture {
    const at = (x: number, y: number): ScreenPoint => this.#hooks.pixelOf(uvOfStamp(stamp, x, y));
    const [sw, se, ne, nw] = [at(-0.5, -0.5), at(0.5, -0.5), at(0.5, 0.5), at(-0.5, 0.5)];
    const middle = at(0, 0);
    const handles = new Map<HandleName, HandlePlace>();
    const free = this.#decal?.locked !== true;
    for (const [name, x, y] of free ? PLACES : []) {
      const isEdge = x === 0 || y === 0;
      const edge = x === 0 ? distance(sw, se) : distance(sw, nw);
      if (isEdge && edge < LEAST_EDGE) continue;
      const place = at(x, y);
      const angle = x === 0 ? degreesOf(sw, se) : degreesOf(sw, nw);
      handles.set(name, { ...place, angle, hidden: false, cursor: resizeCursor(degreesOf(middle, place)) });
    }
    const top = at(0, 0.5);
    const reach = distance(middle, top) || 1;
    const knob = {
      x: top.x + ((top.x - middle.x) / reach) * STEM,
      y: top.y + ((top.y - middle.y) / reach) * STEM,
    };
    if (free) handles.set("rotate", { ...knob, angle: degreesOf(top, knob) + 90, hidden: false, cursor: "grab" });
    return {
      ...{ outlineHidden: "", box: "", boxHidden: "", arrow: "", arrowHead: "", hover: "", twin: "" },
      outline: [line(sw, se), line(se, ne), line(ne, nw), line(nw, sw)].join(""),
      guide: free ? line(top, knob) : "",
      handles,
    };
  }
}

function dragged(
  { start, from, handle }: StampDrag,
  to: Uv,
  { altKey, shiftKey }: Pick<PointerEvent, "altKey" | "shiftKey">,
): UvProjector {
  if (handle === null || handle === "depth" || handle === "near" || handle === "far") {
    return movedStamp(start, from, to);
  }
  return handle === "rotate"
    ? turnedStamp(start, from, to, shiftKey)
    : scaledStamp(start, sideOf(handle), from, to, altKey);
}

function distance(from: ScreenPoint, to: ScreenPoint): number {
  return Math.hypot(to.x - from.x, to.y - from.y);
}
