/** The decals under the pointer: selecting, dragging, hovering; and the drawing of the selected one. */
import { type Matrix4, Vector3 } from "three";
import type { CylindricalProjector, PerspectiveProjector, PlanarProjector, Projector } from "../engine/engine-api.ts";
import { boxDrag, type PictureGrab, type ProjectorDrag } from "./box-drag.ts";
import type { SizeLimits } from "./decal-handles.ts";
import { drapeOutline, type OutlinePoint, POINTS_PER_EDGE, POINTS_PER_EDGE_SLIDING } from "./decal-outline.ts";
import { decalsAt, rectangleHit } from "./decal-picking.ts";
import { axisOf, poseOf } from "./decal-pose.ts";
import { FrameTask } from "./frame-task.ts";
import { type DragPointer, depthDrag, rotateDrag, scaleDrag, slideDrag } from "./gizmo-drag.ts";
import { GizmoOverlay, type GizmoPicture, type HandleName, type HandleStand } from "./gizmo-overlay.ts";
import { drawGizmo, drawOutline, type GizmoView, handleHeight, hoverPath, outlineIndexOf } from "./gizmo-picture.ts";
import { carried, dragAtRest, pointerAtRest } from "./posed-gizmo.ts";
import type { ScreenPoint, ScreenSpace } from "./screen-space.ts";
import type { SurfaceQuery, SurfaceSample } from "./surface-query.ts";
import type { ThrownKinds } from "./thrown-kinds.ts";
import type { DecalGesture, ViewerDecal } from "./viewer-api.ts";

/** What the gizmo needs of the view around it. */
export interface GizmoHost {
  readonly root: HTMLElement;
  readonly screen: ScreenSpace;
  gesture(gesture: DecalGesture): void;
  /** A drag began or ended, whatever became of it. */
  dragging(active: boolean): void;
  /** How an animation has posed the model; null at rest. */
  posed(): PosedView | null;
  /** How projectors are drawn and dragged that are no boxes; null while that is not there. */
  thrown(): ThrownKinds | null;
  /** What becomes of a slide that comes into line with what lies beside it; left out where none does. */
  readonly aligned: ((slide: ProjectorDrag, decal: ViewerDecal) => ProjectorDrag) | undefined;
}

/** The model as it is drawn, where that is not how it rests. */
export interface PosedView {
  readonly drawn: SurfaceQuery;
  toPosed(point: Vector3): Vector3;
  /** The rigid motion, from rest to the pose, of the surface near a resting point. */
  motionAt(point: Vector3): Matrix4;
  /** A clip is running: a line on the surface would run after it. */
  readonly moving: boolean;
}

/** A decal, and where it is taken hold of. */
export interface Held {
  readonly decal: ViewerDecal;
  readonly grab: PictureGrab;
}

interface ActiveDrag {
  readonly decal: ViewerDecal;
  readonly drag: ProjectorDrag;
  /** Where the drag has brought the decal: the design may lag a frame behind. */
  projector: Projector;
}

export class DecalGizmo {
  readonly #host: GizmoHost;
  readonly #overlay: GizmoOverlay;
  readonly #drawTask = new FrameTask(() => this.drawNow());
  readonly #dragTask = new FrameTask(() => this.#moveDrag());
  #query: SurfaceQuery | null = null;
  #enabled = true;
  #decals: readonly ViewerDecal[] = [];
  #selected: ViewerDecal | null = null;
  #hovered: ViewerDecal | null = null;
  #drag: ActiveDrag | null = null;
  #stand: HandleStand | null = null;
  /** A move is being told: the decals that come back by it are drawn with it. */
  #telling = false;
  #pointer: (DragPointer & { at: ScreenPoint }) | null = null;
  /** Draping casts a ray for each point, so it is kept while the projector stays what it is. */
  #outlines = new WeakMap<Projector, OutlinePoint[]>();

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

  /** Off while a tool has the pointer. */
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
    this.#selected = decals.find((decal) => decal.id === selectedId) ?? null;
    this.#hovered = decals.find((decal) => decal.id === this.#hovered?.id) ?? null;
    if (this.#drag !== null && !decals.some((decal) => decal.id === this.#drag?.decal.id)) {
      this.#stopDrag();
    }
    if (!this.#telling) {
      this.#drawTask.request();
    }
  }

  get selectedDecal(): ViewerDecal | null {
    return this.#selected;
  }

  /** The handle that a pointer at this point of the view takes hold of. */
  handleAt(at: ScreenPoint, pointerType: string): HandleName | null {
    return this.#overlay.handleAt(at, pointerType);
  }

  /** Lights up the handle that a press would take. */
  hoverHandle(name: HandleName | null): void {
    this.#overlay.hover(name);
  }

  /** Bottom to top. */
  get decals(): readonly ViewerDecal[] {
    return this.#decals;
  }

  /** The decals that lie there, topmost first. */
  decalsAt(sample: SurfaceSample): ViewerDecal[] {
    return decalsAt(this.#decals, sample);
  }

  /** Where a press takes hold of what is selected: on the surface it reaches, or beside the model on its box's rectangle. */
  heldAt(pointer: DragPointer, sample: SurfaceSample | null): Held | null {
    const selected = this.#selected;
    if (selected === null || selected.locked === true) {
      return null;
    }
    if (sample !== null) {
      const [decal] = decalsAt(selected.holds ?? [selected], sample);
      return decal ? { decal, grab: sample } : null;
    }
    if (!selected.visible || selected.projector.kind !== "planar" || this.#host.posed() !== null) {
      return null;
    }
    const pose = poseOf(selected.projector);
    const position = rectangleHit(pose, pointer.ray);
    return position === null ? null : { decal: selected, grab: { position, normal: axisOf(pose, 2) } };
  }

  startSlide(decal: ViewerDecal, grab: PictureGrab): void {
    if (this.#query !== null) {
      const { projector } = decal;
      const drag =
        projector.kind === "planar"
          ? boxDrag(slideDrag(this.#query, poseOf(projector), grab))
          : this.#host.thrown()?.drag(this.#query, projector, grab);
      if (drag !== undefined) this.#startDrag(decal, this.#host.aligned?.(drag, decal) ?? drag, null);
    }
  }

  /** Returns false where the handle has no decal to act on. */
  startHandle(handle: HandleName, pointer: DragPointer): boolean {
    const selected = this.#selected;
    if (this.#query === null || selected === null || selected.projector.kind === "uv") {
      return false;
    }
    const { projector } = selected;
    const motion = this.#motionOf(this.#host.posed(), projector);
    const from = motion === null ? pointer : pointerAtRest(pointer, motion);
    const drag =
      projector.kind === "planar"
        ? this.#boxHandle(handle, projector, from)
        : this.#thrownHandle(handle, projector, from);
    if (drag === null) {
      return false;
    }
    this.#startDrag(selected, motion === null ? drag : dragAtRest(drag, motion), handle);
    return true;
  }

  #boxHandle(handle: HandleName, projector: PlanarProjector, pointer: DragPointer): ProjectorDrag | null {
    if (this.#query === null || handle === "near" || handle === "far") {
      return null;
    }
    const pose = poseOf(projector);
    const limits = this.#limits(this.#query);
    const height = handleHeight(handle, this.#outlineOf(projector));
    const drag =
      handle === "rotate"
        ? rotateDrag(pose, height, pointer.ray)
        : handle === "depth"
          ? depthDrag(pose, pointer.ray, limits)
          : scaleDrag(pose, handle, height, pointer.ray, limits);
    return boxDrag(drag);
  }

  #thrownHandle(
    handle: HandleName,
    projector: PerspectiveProjector | CylindricalProjector,
    { ray }: DragPointer,
  ): ProjectorDrag | null {
    const grabbed = this.#outlineOf(projector)[outlineIndexOf(handle)];
    return this.#query && grabbed
      ? (this.#host.thrown()?.handleDrag(projector, handle, grabbed.position, ray, this.#limits(this.#query)) ?? null)
      : null;
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
      this.#emit(active, "end", active.projector);
    }
  }

  /** Gives the decal back its place of before the drag. Returns whether there was one. */
  cancel(): boolean {
    const active = this.#drag;
    if (active === null) {
      return false;
    }
    this.#stopDrag();
    this.#emit(active, "cancel", active.decal.projector);
    // The decals have come back by that: until the next frame the handles would stay where the drag had them.
    this.drawNow();
    return true;
  }

  hover(decal: ViewerDecal | null): void {
    if (decal?.id !== this.#hovered?.id) {
      this.#hovered = decal;
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
    const posed = this.#host.posed();
    if (posed !== null) {
      this.#overlay.draw(posed.moving ? null : this.#posedPicture(posed, selected));
      return;
    }
    const view = this.#viewOf(this.#query);
    const hovered = this.#drag === null && this.#hovered?.id !== selected?.id ? this.#hovered : null;
    const hover = hovered === null ? "" : hoverPath(view, this.#outlineOf(hovered.projector));
    this.#overlay.draw(selected === null ? { ...NOTHING, hover } : this.#pictureOf(view, selected, hover));
  }

  #viewOf(query: SurfaceQuery): GizmoView {
    return { screen: this.#host.screen, query, reach: this.#overlay.reach, stand: this.#stand };
  }

  #pictureOf(view: GizmoView, decal: ViewerDecal, hover: string): GizmoPicture {
    return { ...this.#ownPictureOf(view, decal, hover), beside: this.#besidePath(view, decal) };
  }

  /** Not drawn in a drag: the pictures that are painted there show it. */
  #besidePath(view: GizmoView, { beside = [] }: ViewerDecal): string {
    return this.#drag ? "" : beside.map((each) => hoverPath(view, this.#outlineOf(each))).join("");
  }

  #ownPictureOf(view: GizmoView, decal: ViewerDecal, hover: string): GizmoPicture {
    const { projector } = decal;
    // While it slides a decal is looked at, not its box; and what is not drawn casts no rays in each frame.
    if (this.#drag?.drag.kind === "slide") {
      return { ...NOTHING, ...drawOutline(view, this.#outlineOn(view.query, projector, POINTS_PER_EDGE_SLIDING)) };
    }
    return this.#drawWhole(view, decal, this.#outlineOf(projector), hover);
  }

  /** The box stands at rest; its picture stands where the surface under the decal has been moved to. */
  #posedPicture(posed: PosedView, selected: ViewerDecal | null): GizmoPicture {
    const { drawn, toPosed } = posed;
    const view = this.#viewOf(drawn);
    const onPose = (decal: ViewerDecal): OutlinePoint[] =>
      this.#outlineOf(decal.projector).map((point) => ({ ...point, position: toPosed(point.position) }));
    const hovered = this.#drag === null && this.#hovered?.id !== selected?.id ? this.#hovered : null;
    const hover = hovered === null ? "" : hoverPath(view, onPose(hovered));
    if (selected === null) {
      return { ...NOTHING, hover };
    }
    const { projector } = selected;
    const motion = this.#drag?.drag.kind === "slide" ? null : this.#motionOf(posed, projector);
    if (motion === null || projector.kind === "uv") {
      return { ...NOTHING, hover, ...drawOutline(view, onPose(selected)) };
    }
    return this.#drawWhole(view, { ...selected, projector: carried(projector, motion) }, onPose(selected), hover);
  }

  /** How the pose has moved the surface that a projector's picture lies on; null at rest. */
  #motionOf(posed: PosedView | null, projector: Projector): Matrix4 | null {
    const outline = this.#outlineOf(projector);
    if (posed === null || outline.length === 0) {
      return null;
    }
    const middle = outline.reduce((sum, { position }) => sum.add(position), new Vector3());
    return posed.motionAt(middle.divideScalar(outline.length));
  }

  dispose(): void {
    this.#drawTask.cancel();
    this.#dragTask.cancel();
    this.#overlay.dispose();
  }

  #startDrag(decal: ViewerDecal, drag: ProjectorDrag, handle: HandleName | null): void {
    this.#drag = { decal, drag, projector: decal.projector };
    this.#host.root.dataset.gesture = drag.kind;
    this.#stand = this.#overlay.picture?.stand ?? null;
    this.#overlay.startGesture(handle);
    this.#host.dragging(true);
    this.#emit(this.#drag, "start", decal.projector);
  }

  #stopDrag(): void {
    this.#drag = null;
    this.#stand = null;
    this.#pointer = null;
    this.#dragTask.cancel();
    delete this.#host.root.dataset.gesture;
    this.#overlay.endGesture();
    this.#host.dragging(false);
    this.#overlay.setReadout(null);
    // At once: the handles that stayed behind may be grabbed before the next frame.
    this.drawNow();
  }

  #moveDrag(): void {
    const active = this.#drag;
    const pointer = this.#pointer;
    // In a view that was hidden meanwhile no pointer is anywhere.
    const isSeen = this.#host.screen.size.width > 1;
    const projector = isSeen && active !== null && pointer !== null ? active.drag.move(pointer) : null;
    if (active === null || pointer === null || projector === null) {
      return;
    }
    active.projector = projector;
    const text = active.drag.readout(projector);
    this.#overlay.setReadout(text === null ? null : { text, at: pointer.at, view: this.#host.screen.size });
    this.#telling = true;
    this.#emit(active, "move", projector);
    this.#telling = false;
    this.drawNow();
  }

  #emit({ decal, drag }: ActiveDrag, phase: DecalGesture["phase"], projector: Projector): void {
    const material = phase === "cancel" ? null : drag.material;
    this.#host.gesture({ id: decal.id, kind: drag.kind, phase, projector, material });
  }

  /** The decal under way, where the drag has it. */
  #draggedDecal(): ViewerDecal | null {
    const active = this.#drag;
    const decal = this.#decals.find((candidate) => candidate.id === active?.decal.id);
    return active && decal ? { ...decal, projector: active.projector } : null;
  }

  #outlineOf(projector: Projector): OutlinePoint[] {
    const known = this.#outlines.get(projector);
    if (known !== undefined || this.#query === null) {
      return known ?? [];
    }
    const outline = this.#outlineOn(this.#query, projector, POINTS_PER_EDGE);
    if (projector.kind === "planar" || this.#host.thrown() !== null) this.#outlines.set(projector, outline);
    return outline;
  }

  #drawWhole(
    view: GizmoView,
    { projector, locked }: ViewerDecal,
    outline: readonly OutlinePoint[],
    hover: string,
  ): GizmoPicture {
    const options = { handles: locked !== true, hover };
    return projector.kind === "planar"
      ? drawGizmo(view, poseOf(projector), outline, options)
      : (this.#host.thrown()?.draw(view, projector, outline, options) ?? { ...NOTHING, hover });
  }

  #outlineOn(query: SurfaceQuery, projector: Projector, pointsPerEdge: number): OutlinePoint[] {
    return projector.kind === "planar"
      ? drapeOutline(query, poseOf(projector), pointsPerEdge)
      : (this.#host.thrown()?.outline(query, projector, pointsPerEdge) ?? []);
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
  beside: "",
  middle: null,
  stand: null,
  handles: new Map(),
} as const;
