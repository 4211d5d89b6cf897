/** A view whose decals can be taken hold of, whoever does more with it: what hands answer, and what the view itself does. */
import type { ModelInfo, PlanarProjector, Projector, TargetInfo, TargetUpdate } from "../engine/engine-api.ts";
import type { Orbit } from "./camera-orbit.ts";
import type { CameraStand } from "./camera-rig.ts";
import type { DecalHands } from "./decal-hands.ts";
import type { CameraLimits } from "./model-camera.ts";
import type { StillView } from "./still-view.ts";
import type { DecalViewer, Landing, ModelViewerEvents, SurfaceHit, SurfacePlaces, ViewerDecal } from "./viewer-api.ts";

export abstract class ViewInHands implements DecalViewer {
  readonly element: HTMLElement;
  protected readonly view: StillView;
  protected abstract readonly hands: DecalHands;
  abstract landing(width: number, aspect: number): Landing | null | Promise<Landing | null>;
  abstract readonly surface: SurfacePlaces;

  constructor(view: StillView) {
    this.element = view.element;
    this.view = view;
  }

  setModel(info: ModelInfo): Promise<void> {
    return this.view.setModel(info);
  }

  bindTarget(info: TargetInfo): void {
    this.view.bindTarget(info);
  }

  applyUpdate(update: TargetUpdate): boolean {
    return this.view.applyUpdate(update);
  }

  setDecals(decals: readonly ViewerDecal[], selectedId: string | null): void {
    this.view.setDecals(decals, selectedId);
  }

  frameModel(): void {
    this.view.frameModel();
  }

  get stand(): CameraStand {
    return this.view.stand;
  }

  setCamera(place: Orbit | CameraStand | null, limits: CameraLimits): void {
    this.view.setCamera(place, limits);
  }

  capture(orbit: Orbit | null, width: number, height: number): Promise<Blob | null> {
    return this.view.capture(orbit, width, height);
  }

  on<K extends keyof ModelViewerEvents>(type: K, listener: (event: ModelViewerEvents[K]) => void): () => void {
    return this.view.on(type, listener);
  }

  get statistics(): DecalViewer["statistics"] {
    return this.view.statistics;
  }

  clickAt(clientX: number, clientY: number): void {
    this.hands.clickAt(clientX, clientY);
  }

  surfaceAtCentre(): SurfaceHit | null {
    return this.hands.surfaceAtCentre();
  }

  surfaceAtPointer(clientX: number, clientY: number): SurfaceHit | null {
    return this.hands.surfaceAtPointer(clientX, clientY);
  }

  projectorAt(hit: SurfaceHit, width: number, aspect: number, keep?: PlanarProjector): PlanarProjector {
    return this.hands.projectorAt(hit, width, aspect, keep);
  }

  nudge(projector: Projector, rightMetres: number, upMetres: number): Projector {
    return this.hands.nudge(projector, rightMetres, upMetres);
  }

  resized(before: Projector, after: Projector): Projector {
    return this.hands.resized(before, after);
  }

  materialsReached(projector: Projector, backfaces: boolean): readonly number[] {
    return this.hands.materialsReached(projector, backfaces);
  }

  dispose(): void {
    this.view.dispose();
  }
}
