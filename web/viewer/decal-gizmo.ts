/** The decals under the pointer: selecting, dragging, hovering; and the drawing of the selected one. */
import type { Vector3 } from "three";
import type { SizeLimits } from "./decal-handles.ts";
import { drapeOutline, type OutlinePoint } from "./decal-outline.ts";
import { decalsAt, rectangleHit } from "./decal-picking.ts";
import { axisOf, type DecalPose, poseOf, projectorOf, type SurfacePoint } from "./decal-pose.ts";
import { FrameTask } from "./frame-task.ts";
import { type DragPointer, depthDrag, type GizmoDrag, rotateDrag, scaleDrag, slideDrag } from "./gizmo-drag.ts";
import { GizmoOverlay, type HandleName } from "./gizmo-overlay.ts";
import { drawGizmo, type GizmoView, handleHeight, hoverPath } from "./gizmo-picture.ts";
import type { ScreenPoint, ScreenSpace } from "./screen-space.ts";
import type { SurfaceQuery, SurfaceSample } from "./surface-query.ts";
import type { DecalGesture, ViewerDecal } from "./viewer-api.ts";

/** What the gizmo needs of the view around it. */
export interface GizmoHost {
  readonly root: HTMLElement;
  readonly screen: ScreenSpace;
  metresPerPixel(point: Vector3): number;
  gesture(gesture: DecalGesture): void;
  /** A drag began or ended, whatever became of it. */
  dragging(active: boolean): void;
}

/** A decal with what was computed from it. */
interface PosedDecal {
  readonly decal: ViewerDecal;
  readonly pose: DecalPose;
}

interface ActiveDrag {
  readonly id: string;
  readonly drag: GizmoDrag;
  readonly handle: HandleName | null;
  readonly start: DecalPose;
  readonly material: number;
  pose: DecalPose;
}

export class DecalGizmo {
  readonly #host: GizmoHost;
  readonly #overlay: GizmoOverlay;
  readonly #drawTask = new FrameTask(() => this.drawNow());
  readonly #dragTask = new FrameTask(() => this.#moveDrag());
  #query: SurfaceQuery | null = null;
  #enabled = true;
  #decals: readonly ViewerDecal[] = [];
  #selected: PosedDecal | null = null;
  #hovered: PosedDecal | null = null;
  #drag: ActiveDrag | null = null;
  #pointer: (DragPointer & { at: ScreenPoint }) | null = null;
  /** Draping casts a ray for each point, so it is kept while the box stays where it is. */
  #outlines = new WeakMap<DecalPose, OutlinePoint[]>();

  constructor(host: GizmoHost) {
    this.#host = host;
    this.#overlay = new GizmoOverlay(host.root);
  }

  /** The surface that decals lie on; null while there is no model. */
  setSurface(query: SurfaceQuery | null): void {
    this.cancel();
    this.#query = query;
    this.#outlines = new WeakMap();
    this.#hovered = null;
    this.#drawTask.request();
  }

  /** Off while an animation plays: the decals' places are those of the resting model. */
  set enabled(value: boolean) {
    this.#enabled = value;
    if (!value) {
      this.cancel();
      this.#hovered = null;
    }
    this.#drawTask.request();
  }

  setDecals(decals: readonly ViewerDecal[], selectedId: string | null): void {
    this.#decals = decals;
    const selected = decals.find((decal) => decal.id === selectedId) ?? null;
    this.#selected = selected && { decal: selected, pose: this.#poseFor(selected) };
    const hovered = decals.find((decal) => decal.id === this.#hovered?.decal.id) ?? null;
    this.#hovered = hovered && { decal: hovered, pose: poseOf(hovered.projector) };
    if (this.#drag !== null && !decals.some((decal) => decal.id === this.#drag?.id)) {
      this.#stopDrag();
    }
    this.#drawTask.request();
  }

  get selectedDecal(): ViewerDecal | null {
    return this.#selected?.decal ?? null;
  }

  handleAt(target: EventTarget | null): HandleName | null {
    return this.#overlay.handleAt(target);
  }

  /** The decals that a press at this sample can mean, topmost first. */
  decalsAt(sample: SurfaceSample): ViewerDecal[] {
    return this.#enabled ? decalsAt(this.#decals, sample) : [];
  }

  /** Where a press takes hold of the selected decal: on the surface inside its box, or beside the model on its rectangle. */
  grabOfSelected(pointer: DragPointer, sample: SurfaceSample | null): SurfacePoint | null {
    const selected = this.#selected;
    if (!this.#enabled || selected === null || selected.decal.locked === true || !selected.decal.visible) {
      return null;
    }
    if (sample !== null) {
      return decalsAt([selected.decal], sample).length > 0 ? sample : null;
    }
    const position = rectangleHit(selected.pose, pointer.ray);
    return position === null ? null : { position, normal: axisOf(selected.pose, 2) };
  }

  startSlide(decal: ViewerDecal, grab: SurfacePoint): void {
    if (this.#query !== null) {
      const pose = poseOf(decal.projector);
      this.#startDrag(decal, pose, slideDrag(this.#query, pose, grab), null);
    }
  }

  /** Returns false where the handle has no decal to act on. */
  startHandle(handle: HandleName, pointer: DragPointer): boolean {
    const selected = this.#selected;
    if (this.#query === null || selected === null) {
      return false;
    }
    const { pose, decal } = selected;
    const limits = this.#limits(this.#query);
    const height = handleHeight(handle, this.#outlineOf(pose));
    const drag =
      handle === "rotate"
        ? rotateDrag(pose, height, pointer.ray)
        : handle === "depth"
          ? depthDrag(pose, pointer.ray, limits)
          : scaleDrag(pose, handle, height, pointer.ray, limits);
    this.#startDrag(decal, pose, drag, handle);
    return true;
  }

  /** The pointer of the drag moved, or a modifier key changed. */
  moveTo(pointer: DragPointer & { at: ScreenPoint }): void {
    this.#pointer = pointer;
    this.#dragTask.request();
  }

  /** The pointer was released. */
  finish(): void {
    this.#dragTask.flush();
    const active = this.#drag;
    if (active !== null) {
      this.#stopDrag();
      this.#emit(active, "end", active.pose);
    }
  }

  /** Gives the decal back its place of before the drag. Returns whether there was one. */
  cancel(): boolean {
    const active = this.#drag;
    if (active === null) {
      return false;
    }
    this.#stopDrag();
    this.#emit(active, "cancel", active.start);
    return true;
  }

  hover(decal: ViewerDecal | null): void {
    if (decal?.id !== this.#hovered?.decal.id) {
      this.#hovered = decal && { decal, pose: poseOf(decal.projector) };
      this.#drawTask.request();
    }
  }

  /** Draws at once: with the frame in which the camera moved. */
  drawNow(): void {
    this.#drawTask.cancel();
    const selected = this.#drag === null ? this.#selected : this.#draggedDecal();
    if (this.#query === null || !this.#enabled || (selected === null && this.#hovered === null)) {
      this.#overlay.draw(null);
      return;
    }
    const view: GizmoView = {
      screen: this.#host.screen,
      query: this.#query,
      metresPerPixel: (point) => this.#host.metresPerPixel(point),
    };
    const hovered = this.#drag === null && this.#hovered?.decal.id !== selected?.decal.id ? this.#hovered : null;
    const hover = hovered === null ? "" : hoverPath(view, this.#outlineOf(hovered.pose));
    if (selected === null) {
      this.#overlay.draw({ ...NOTHING, hover });
      return;
    }
    const outline = this.#outlineOf(selected.pose);
    const handles = selected.decal.locked !== true;
    this.#overlay.draw(drawGizmo(view, selected.pose, outline, { handles, hover }));
  }

  dispose(): void {
    this.#drawTask.cancel();
    this.#dragTask.cancel();
    this.#overlay.dispose();
  }

  #startDrag(decal: ViewerDecal, pose: DecalPose, drag: GizmoDrag, handle: HandleName | null): void {
    this.#drag = { id: decal.id, drag, handle, start: pose, material: decal.material, pose };
    this.#host.root.dataset.gesture = drag.kind;
    this.#overlay.setActive(handle);
    this.#host.dragging(true);
    this.#emit(this.#drag, "start", pose);
  }

  #stopDrag(): void {
    this.#drag = null;
    this.#pointer = null;
    this.#dragTask.cancel();
    delete this.#host.root.dataset.gesture;
    this.#overlay.setActive(null);
    this.#host.dragging(false);
    this.#overlay.setReadout(null);
    this.#drawTask.request();
  }

  #moveDrag(): void {
    const active = this.#drag;
    const pointer = this.#pointer;
    const pose = active !== null && pointer !== null ? active.drag.move(pointer) : null;
    if (active === null || pointer === null || pose === null) {
      return;
    }
    active.pose = pose;
    const text = active.drag.readout(pose);
    this.#overlay.setReadout(text === null ? null : { text, ...pointer.at });
    this.#emit(active, "move", pose);
    this.drawNow();
  }

  #emit(active: ActiveDrag, phase: DecalGesture["phase"], pose: DecalPose): void {
    const material = phase === "cancel" ? active.material : (active.drag.material ?? active.material);
    this.#host.gesture({ id: active.id, kind: active.drag.kind, phase, projector: projectorOf(pose), material });
  }

  /** The decal under way, where the drag has it: the design may lag a frame behind. */
  #draggedDecal(): PosedDecal | null {
    const active = this.#drag;
    const decal = this.#decals.find((candidate) => candidate.id === active?.id);
    return active === null || decal === undefined ? null : { decal, pose: active.pose };
  }

  #poseFor(decal: ViewerDecal): DecalPose {
    const same = this.#selected?.decal.projector === decal.projector ? this.#selected.pose : null;
    return same ?? poseOf(decal.projector);
  }

  #outlineOf(pose: DecalPose): OutlinePoint[] {
    const known = this.#outlines.get(pose);
    if (known !== undefined || this.#query === null) {
      return known ?? [];
    }
    const outline = drapeOutline(this.#query, pose);
    this.#outlines.set(pose, outline);
    return outline;
  }

  #limits(query: SurfaceQuery): SizeLimits {
    return { least: query.bounds.radius * 1e-3, most: query.bounds.radius * 8 };
  }
}

const NOTHING = {
  outline: "",
  outlineHidden: "",
  box: "",
  boxHidden: "",
  guide: "",
  arrow: "",
  arrowHead: "",
  hover: "",
  handles: new Map(),
} as const;
