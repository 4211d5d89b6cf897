/** The selected flat stamp in the texture view: its border, its handles, and drags of both. */
import type { UvProjector } from "../engine/engine-api.ts";
import { ALIGNMENT_REACH, AlignmentLines } from "./alignment-lines.ts";
import { ClientCorner } from "./client-corner.ts";
import { sideOf } from "./gizmo-drag.ts";
import {
  GizmoOverlay,
  type GizmoPicture,
  type HandleName,
  type HandlePlace,
  type ScaleHandleName,
} from "./gizmo-overlay.ts";
import { line } from "./gizmo-picture.ts";
import { degreesOf, pushedOut, scaleHandlePlaces } from "./handle-places.ts";
import { distance } from "./handle-under.ts";
import { heldToAxis } from "./held-to-axis.ts";
import type { ScreenPoint } from "./screen-space.ts";
import { stampInLine } from "./stamp-alignment.ts";
import { movedStamp, scaledStamp, stampHolds, turnedStamp, type Uv, uvOfStamp } from "./stamp-drag.ts";
import { takesBack } from "./take-back-key.ts";
import type { UvBounds } from "./uv-charts.ts";
import type { DecalGesture, FindStamps, ViewerDecal } from "./viewer-api.ts";

export interface StampGizmoHooks {
  pixelOf(uv: Uv): ScreenPoint;
  uvOf(x: number, y: number): Uv;
  /** Whether a point is in the view, and this far from its border. */
  holds(at: ScreenPoint, margin: number): boolean;
  /** Whether the view has room in the page; hidden in the midst of a drag, it has no pointer in it. */
  isSeen(): boolean;
  gesture(gesture: DecalGesture): void;
  readonly others: FindStamps;
  /** Round the chart at a place of the texture; null beside all charts. */
  chartAt(uv: Uv): UvBounds | null;
}

/** CSS pixels. */
const STEM = 28;
const KNOB_MARGIN = 14;
/** Edge middles of the picture at which the handle that turns may stand, the first that is in view; y up. */
const KNOB_SIDES = [
  [0, 0.5],
  [0, -0.5],
  [0.5, 0],
  [-0.5, 0],
] as const;

interface StampDrag {
  readonly id: string;
  /** What it began with. */
  readonly press: PointerEvent;
  readonly pointerId: number;
  readonly kind: DecalGesture["kind"];
  readonly handle: HandleName | null;
  readonly start: UvProjector;
  readonly from: Uv;
  /** What it comes into line with. */
  others: readonly UvProjector[] | null;
  projector: UvProjector;
}

export class StampGizmo {
  readonly #root: HTMLElement;
  readonly #hooks: StampGizmoHooks;
  readonly #overlay: GizmoOverlay;
  readonly #lines: AlignmentLines;
  readonly #corner: ClientCorner;
  readonly #abort = new AbortController();
  #decal: ViewerDecal | null = null;
  #drag: StampDrag | null = null;
  /** A finger is down beside the stamp: the view's, and so are those that come to it. */
  #pans = false;
  /** A press that is handed to the view after all comes by here a second time. */
  #passOn: Event | null = null;
  /** In a drag it stays at its side. */
  #knobSide: (typeof KNOB_SIDES)[number] = KNOB_SIDES[0];

  constructor(root: HTMLElement, hooks: StampGizmoHooks) {
    this.#root = root;
    this.#hooks = hooks;
    this.#overlay = new GizmoOverlay(root);
    this.#lines = new AlignmentLines(root);
    this.#corner = new ClientCorner(root);
    const early = { capture: true, signal: this.#abort.signal };
    root.addEventListener("pointerdown", (event) => this.#onDown(event), early);
    root.addEventListener("pointermove", (event) => this.#onMove(event), early);
    root.addEventListener("pointerup", (event) => this.#onEnd(event, "end"), early);
    root.addEventListener("pointercancel", (event) => this.#onEnd(event, "cancel"), early);
    // Whatever took the pointer, no release will be told.
    root.addEventListener("lostpointercapture", (event) => this.#onEnd(event, "end"), early);
    root.addEventListener("pointerleave", () => this.#light(null), early);
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
    this.#lines.dispose();
  }

  get #stamp(): UvProjector | null {
    const projector = this.#drag?.projector ?? this.#decal?.projector;
    return projector?.kind === "uv" ? projector : null;
  }

  #onDown(event: PointerEvent): void {
    const [decal, start] = [this.#decal, this.#stamp];
    if (event === this.#passOn || decal === null || start === null || decal.locked === true || event.button !== 0)
      return;
    if (this.#drag !== null) {
      this.#onSecond(this.#drag, event);
      return;
    }
    if (this.#pans && !event.isPrimary) return;
    const handle = this.#handleAt(event);
    const from = this.#uvOf(event);
    this.#pans = handle === null && !stampHolds(start, from);
    if (this.#pans) return;
    event.stopImmediatePropagation();
    this.#root.setPointerCapture(event.pointerId);
    const kind = handle === null ? "slide" : handle === "rotate" ? "rotate" : "scale";
    const { pointerId } = event;
    const drag: StampDrag = {
      ...{ id: decal.id, press: event, pointerId, kind, handle, start, from },
      ...{ others: null, projector: start },
    };
    this.#drag = drag;
    this.#root.dataset.gesture = kind;
    this.#overlay.startGesture(handle);
    this.#tell(drag, "start");
    if (handle === null) drag.others = this.#hooks.others(decal.id);
  }

  /** A second finger turns the drag into the view's pinch. A palm beside a pen is nobody's. */
  #onSecond(drag: StampDrag, event: PointerEvent): void {
    const { press } = drag;
    if (event.pointerType !== "touch" || press.pointerType !== "touch") {
      event.stopImmediatePropagation();
      return;
    }
    this.#stop();
    this.#tell(drag, "end");
    this.#pans = true;
    const again = new PointerEvent("pointerdown", press);
    this.#passOn = again;
    this.#root.dispatchEvent(again);
    this.#passOn = null;
  }

  #onMove(event: PointerEvent): void {
    const drag = this.#drag;
    if (drag === null && event.pointerType !== "touch") {
      this.#light(event.buttons === 0 ? this.#handleAt(event) : null);
    }
    if (drag === null || drag.pointerId !== event.pointerId) return;
    event.stopImmediatePropagation();
    if (!this.#hooks.isSeen()) return;
    const from = event.shiftKey && drag.handle === null ? this.#hooks.pixelOf(drag.from) : null;
    drag.projector = this.#inLine(drag, dragged(drag, this.#uvOf(event, from), event), event);
    this.#tell(drag, "move");
    this.draw();
  }

  /** Shift, which holds a slide to an axis, and Ctrl or Cmd leave it where the pointer has it. */
  #inLine({ others }: StampDrag, stamp: UvProjector, event: PointerEvent): UvProjector {
    if (others === null || event.shiftKey || event.ctrlKey || event.metaKey) {
      this.#lines.draw([]);
      return stamp;
    }
    const { pixelOf, chartAt } = this.#hooks;
    const [origin, far] = [pixelOf([0, 0]), pixelOf([1, 1])];
    const reach: Uv = [ALIGNMENT_REACH / (far.x - origin.x), ALIGNMENT_REACH / (far.y - origin.y)];
    const aligned = stampInLine(stamp, others, chartAt(stamp.center), reach);
    this.#lines.draw(aligned.lines.map(([start, end]) => [pixelOf(start), pixelOf(end)]));
    return aligned.stamp;
  }

  #onEnd(event: PointerEvent, phase: "end" | "cancel"): void {
    this.#pans = false;
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
    this.#lines.draw([]);
    this.#overlay.endGesture();
    this.draw();
  }

  #tell({ id, kind, projector }: StampDrag, phase: DecalGesture["phase"]): void {
    this.#hooks.gesture({ id, kind, phase, projector, material: null });
  }

  #light(handle: HandleName | null): void {
    this.#overlay.hover(handle);
    this.#root.dataset.cursor = handle === null ? "" : "handle";
  }

  #handleAt({ clientX, clientY, pointerType }: PointerEvent): HandleName | null {
    return this.#overlay.handleAt(this.#corner.pointOf(clientX, clientY), pointerType);
  }

  /** @param from Where a slide began that is held to an axis. */
  #uvOf(event: PointerEvent, from: ScreenPoint | null = null): Uv {
    const point = this.#corner.pointOf(event.clientX, event.clientY);
    const { x, y } = from === null ? point : heldToAxis(from, point);
    return this.#hooks.uvOf(x, y);
  }

  #pictureOf(stamp: UvProjector): GizmoPicture {
    const at = (x: number, y: number): ScreenPoint => this.#hooks.pixelOf(uvOfStamp(stamp, x, y));
    const [sw, se, ne, nw] = [at(-0.5, -0.5), at(0.5, -0.5), at(0.5, 0.5), at(-0.5, 0.5)];
    const middle = at(0, 0);
    const handles = new Map<HandleName, HandlePlace>();
    const free = this.#decal?.locked !== true;
    const room = { middle, reach: this.#overlay.reach };
    const knobAt = ([x, y]: readonly [number, number]): ScreenPoint => {
      const foot = at(x, y);
      const stem = distance(middle, foot) + Math.max(STEM, 2 * room.reach);
      return pushedOut(foot, middle, Math.max(stem, Math.SQRT2 * 2 * room.reach));
    };
    if (this.#drag === null) {
      this.#knobSide = KNOB_SIDES.find((side) => this.#hooks.holds(knobAt(side), KNOB_MARGIN)) ?? KNOB_SIDES[0];
    }
    const [footX, footY] = this.#knobSide;
    const [foot, knob] = [at(footX, footY), knobAt(this.#knobSide)];
    if (free) {
      const pixelOf = (name: ScaleHandleName): ScreenPoint => at(sideOf(name).x / 2, sideOf(name).y / 2);
      for (const [name, place] of scaleHandlePlaces(pixelOf, room)) handles.set(name, { ...place, hidden: false });
      handles.set("rotate", { ...knob, angle: degreesOf(foot, knob) + 90, hidden: false, cursor: "grab" });
    }
    return {
      ...{ outlineHidden: "", box: "", boxHidden: "", arrow: "", arrowHead: "", hover: "", beside: "", stand: null },
      outline: [line(sw, se), line(se, ne), line(ne, nw), line(nw, sw)].join(""),
      guide: free ? line(foot, knob) : "",
      middle,
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
