/**
 * The 3D view in a customer's hands: the camera, and decals that are chosen, dragged and nudged. The editor's view, with tools,
 * animations and more, is `ModelViewer`.
 */
import type { ModelInfo, PlanarProjector, Projector, TargetInfo, TargetUpdate } from "../engine/engine-api.ts";
import type { Orbit } from "./camera-orbit.ts";
import { DecalHands } from "./decal-hands.ts";
import { tupleOf } from "./decal-pose.ts";
import { HeldModel } from "./held-model.ts";
import type { CameraLimits } from "./model-camera.ts";
import type { ModelLook } from "./model-look.ts";
import { OrbitCamera } from "./orbit-camera.ts";
import type { StillModel } from "./still-model.ts";
import type { StillView } from "./still-view.ts";
import type { ThrownKinds } from "./thrown-kinds.ts";
import type {
  DecalViewer,
  MapPicture,
  ModelViewerEvents,
  SurfaceHit,
  SurfacePlaces,
  ViewerDecal,
} from "./viewer-api.ts";

/** What some decals of a design need beside the hands; null where all are boxes. */
export async function kindsFor(decals: readonly ViewerDecal[]): Promise<ThrownKinds | null> {
  const boxes = decals.every(({ projector }) => projector.kind === "planar");
  return boxes ? null : (await import("./thrown-kinds.ts")).THROWN;
}

export class HeldView implements DecalViewer {
  readonly element: HTMLElement;
  readonly surface: SurfacePlaces;
  readonly #view: StillView;
  readonly #hands: DecalHands;
  readonly #failed: (thrown: unknown) => void;
  #thrown: ThrownKinds | null;
  #model: { readonly still: StillModel; readonly held: HeldModel } | null = null;
  #look: ModelLook | null = null;
  #lookOnly = false;

  /**
   * Takes hold of a view, once: what it shows stays as it is, and it may be used as before.
   *
   * @param thrown of `kindsFor` the view's decals; decals that come later bring theirs
   * @param failed told where they do not come
   */
  constructor(view: StillView, thrown: ThrownKinds | null, failed: (thrown: unknown) => void) {
    const { element: root, stage } = view;
    this.element = root;
    this.#view = view;
    this.#thrown = thrown;
    this.#failed = failed;
    const rig = stage.hold((still) => new OrbitCamera(stage.camera, root, still, () => stage.requestFrame()));
    const hands = new DecalHands({
      view,
      rig,
      model: () => this.#model?.held ?? null,
      thrown: () => this.#thrown,
      posed: () => null,
    });
    this.#hands = hands;
    hands.listen();
    root.addEventListener("keydown", (event) => hands.key(event));
    const { screen } = hands;
    this.surface = {
      near: (position) => hands.near(position),
      atUv: (material, uv) => hands.atUv(material, uv),
      lookAt: () => ({ eye: tupleOf(screen.eye), up: tupleOf(screen.axes.up) }),
    };
    view.take({
      modelShown: (still) => this.#modelShown(still),
      modelGone: () => this.#modelGone(),
      setDecals: (decals, selectedId) => this.#setDecals(decals, selectedId),
      beforeFrame: () => false,
      drawOver: () => undefined,
      cameraMoved: () => hands.gizmo.drawNow(),
      letGo: () => hands.dispose(),
    });
  }

  /** Decals stay where they are; the view can be turned all the same. */
  set lookOnly(value: boolean) {
    this.#lookOnly = value;
    this.#hands.suspended = value;
    this.element.style.cursor = value ? "grab" : "";
  }

  setModel(info: ModelInfo): Promise<void> {
    return this.#view.setModel(info);
  }

  bindTarget(info: TargetInfo): void {
    this.#view.bindTarget(info);
  }

  applyUpdate(update: TargetUpdate): void {
    this.#view.applyUpdate(update);
  }

  setDecals(decals: readonly ViewerDecal[], selectedId: string | null): void {
    this.#view.setDecals(decals, selectedId);
  }

  frameModel(): void {
    this.#view.frameModel();
  }

  picture(width: number, height: number): string | null {
    return this.#view.picture(width, height);
  }

  setCamera(orbit: Orbit | null, limits: CameraLimits): void {
    this.#view.setCamera(orbit, limits);
  }

  capture(orbit: Orbit | null, width: number, height: number): Promise<Blob | null> {
    return this.#view.capture(orbit, width, height);
  }

  on<K extends keyof ModelViewerEvents>(type: K, listener: (event: ModelViewerEvents[K]) => void): () => void {
    return this.#view.on(type, listener);
  }

  get statistics(): DecalViewer["statistics"] {
    return this.#view.statistics;
  }

  clickAt(clientX: number, clientY: number): void {
    this.#hands.clickAt(clientX, clientY);
  }

  surfaceAtCentre(): SurfaceHit | null {
    return this.#hands.surfaceAtCentre();
  }

  surfaceAtPointer(clientX: number, clientY: number): SurfaceHit | null {
    return this.#hands.surfaceAtPointer(clientX, clientY);
  }

  projectorAt(hit: SurfaceHit, width: number, aspect: number, keep?: PlanarProjector): PlanarProjector {
    return this.#hands.projectorAt(hit, width, aspect, keep);
  }

  nudge(projector: Projector, rightMetres: number, upMetres: number): Projector {
    return this.#hands.nudge(projector, rightMetres, upMetres);
  }

  materialsReached(projector: Projector, backfaces: boolean): readonly number[] {
    return this.#hands.materialsReached(projector, backfaces);
  }

  /** Shows pictures in place of the textures, by material (others grey), as flat colours; null shows the textures again. */
  async showMaps(pictures: ReadonlyMap<number, MapPicture> | null): Promise<void> {
    const { ModelLook } = await import("./model-look.ts");
    if (this.#model === null) return;
    this.#look ??= new ModelLook(this.#model.still.scene);
    this.#look.setMaps(pictures);
    this.#view.stage.requestFrame();
  }

  dispose(): void {
    this.#view.dispose();
  }

  #modelShown(still: StillModel): void {
    const held = new HeldModel(still);
    this.#model = { still, held };
    this.#hands.gizmo.setSurface(held.query);
    this.#hands.gizmo.enabled = !this.#lookOnly;
  }

  #modelGone(): void {
    this.#hands.gizmo.setSurface(null);
    this.#look?.dispose();
    this.#look = null;
    this.#model = null;
  }

  #setDecals(decals: readonly ViewerDecal[], selectedId: string | null): void {
    this.#hands.gizmo.setDecals(decals, selectedId);
    if (this.#thrown === null) void this.#bringKinds(decals).catch(this.#failed);
  }

  async #bringKinds(decals: readonly ViewerDecal[]): Promise<void> {
    this.#thrown = (await kindsFor(decals)) ?? this.#thrown;
    if (this.#thrown !== null) this.#hands.gizmo.drawNow();
  }
}
