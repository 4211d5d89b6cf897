/** The 3D view with hands: picking, the decal gizmo, tools and looks, on a view that shows the model. */
import { type Ray, Vector3 } from "three";
import { TexelcastError } from "../core/texelcast-error.ts";
import type { ModelInfo, PlanarProjector, Projector, TargetInfo, TargetUpdate, Vec3 } from "../engine/engine-api.ts";
import type { Orbit } from "./camera-orbit.ts";
import { ClipClock } from "./clip-clock.ts";
import { frameDecal } from "./decal-framing.ts";
import { DecalGizmo } from "./decal-gizmo.ts";
import { poseOf } from "./decal-pose.ts";
import { GIZMO_STYLE } from "./gizmo-style.ts";
import { GradientHandles, type GradientLabels, type GradientPlace } from "./gradient-handles.ts";
import { HeldCamera } from "./held-camera.ts";
import type { CameraLimits } from "./model-camera.ts";
import { ModelDisplay } from "./model-display.ts";
import { guideOf } from "./model-parts.ts";
import { ModelPlacement } from "./model-placement.ts";
import { hitOf, ModelTools } from "./model-tools.ts";
import { pictureBox } from "./projector-outline.ts";
import type { Alignment } from "./projector-placer.ts";
import { reachVolume } from "./reached-materials.ts";
import { type ScreenPoint, ScreenSpace } from "./screen-space.ts";
import { ShownModel } from "./shown-model.ts";
import type { Stage } from "./stage.ts";
import type { StillModel } from "./still-model.ts";
import { type ModelViewOptions, StillView } from "./still-view.ts";
import type { SurfaceSample } from "./surface-query.ts";
import type { BrushRing, ToolInput, ToolSurface } from "./tool-input.ts";
import { ViewInput } from "./view-input.ts";
import type {
  AnimationState,
  ClipInfo,
  GuideEntry,
  MapPicture,
  ModelLook,
  ModelPart,
  ModelViewer,
  ModelViewerEvents,
  SurfaceHit,
  TexturePlace,
  ViewerDecal,
} from "./viewer-api.ts";
import { adoptStyle } from "./viewer-style.ts";

/** Builds a viewer that fills `host`, which must have a size of its own. Throws a TexelcastError without WebGL 2. */
export function createModelViewer(host: HTMLElement, options: ModelViewOptions = {}): ModelViewer {
  return withHands(new StillView(host, options));
}

/** Takes hold of a view, once: what it shows stays as it is, and it may be used as before. */
export function withHands(view: StillView): ModelViewer {
  return new ThreeModelViewer(view);
}

class ThreeModelViewer implements ModelViewer {
  readonly element: HTMLElement;
  readonly #view: StillView;
  readonly #stage: Stage;
  readonly #held: HeldCamera;
  readonly #screen: ScreenSpace;
  readonly #gizmo: DecalGizmo;
  readonly #tools: ModelTools;
  readonly #gradient: GradientHandles;
  readonly #input: ViewInput;
  readonly #display: ModelDisplay;
  readonly #clock: ClipClock;
  #model: ShownModel | null = null;

  constructor(view: StillView) {
    const { element: root, events } = view;
    adoptStyle(root, GIZMO_STYLE);
    this.element = root;
    this.#view = view;
    this.#stage = view.stage;
    this.#held = view.stage.hold(
      (still) => new HeldCamera(this.#stage.camera, root, still, () => this.#stage.requestFrame()),
    );
    this.#screen = new ScreenSpace(this.#stage.camera, root);
    this.#gizmo = new DecalGizmo({
      root,
      screen: this.#screen,
      gesture: (gesture) => events.emit("gesture", gesture),
      dragging: (active) => {
        this.#stage.inGesture = active;
      },
      posed: () => {
        const model = this.#model;
        if (model === null || !model.animation.posed) {
          return null;
        }
        return {
          drawn: model.drawn,
          toPosed: (point) => model.toPosed(point),
          motionAt: (point) => model.motionAt(point),
          moving: this.#clock.runs,
        };
      },
    });
    this.#display = new ModelDisplay(root, this.#stage, this.#screen);
    const pick = (ray: Ray) => this.#model?.pick(ray) ?? null;
    const toDrawn = (point: Vector3) => this.#model?.toPosed(point) ?? point;
    this.#gradient = new GradientHandles(root, this.#screen, {
      pick: (at) => this.#sampleAt(at),
      atRest: () => this.#model !== null && !this.#model.animation.posed,
      changed: (place, phase) => events.emit("gradient", { place, phase }),
    });
    // Before the decals' own input, which it keeps from what a tool takes.
    this.#tools = new ModelTools(root, this.#screen, {
      query: () => this.#model?.query ?? null,
      concealed: () => this.#model?.concealed ?? null,
      pick,
      toDrawn,
    });
    this.#input = new ViewInput(root, this.#gizmo, this.#screen, {
      pick,
      isPosed: () => this.#model?.animation.posed ?? false,
      select: (id) => events.emit("select", { id }),
      hover: (sample) => events.emit("hover", { hit: sample && hitOf(sample) }),
      setPanning: (pans) => this.#held.setPanning(pans),
    });
    this.#clock = new ClipClock(root, {
      animation: () => this.#model?.animation ?? null,
      isOnModel: (event) => this.#sampleAt(this.#screen.pointOf(event.clientX, event.clientY)) !== null,
      tell: (state) => events.emit("animation", state),
      changed: () => this.#followModel(),
    });
    root.addEventListener("keydown", (event) => this.#onKey(event));
    view.take({
      modelShown: (model) => this.#modelShown(model),
      modelGone: () => this.#modelGone(),
      setDecals: (decals, selectedId) => this.#gizmo.setDecals(decals, selectedId),
      beforeFrame: (delta) => {
        this.#display.beforeFrame();
        return this.#clock.advance(delta);
      },
      drawOver: () => this.#display.drawOver(),
      cameraMoved: () => this.#followCamera(),
      letGo: () => this.#letGo(),
    });
  }

  async setModel(info: ModelInfo): Promise<void> {
    await this.#view.setModel(info);
  }

  #modelShown(still: StillModel): void {
    const model = new ShownModel(still);
    this.#model = model;
    this.#display.setModel(model);
    this.#surfaceChanged();
    this.#gizmo.enabled = !this.#tools.active;
  }

  #modelGone(): void {
    const model = this.#model;
    if (model === null) {
      return;
    }
    this.#gizmo.setSurface(null);
    this.#tools.setSurface(null);
    this.#display.setModel(null);
    model.dispose();
    this.#model = null;
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

  surfaceAtCentre(): SurfaceHit | null {
    const { clientWidth: width, clientHeight: height } = this.element;
    // Outwards in rings: the first that meets the model is nearest to the middle, to within a ring's width.
    for (let ring = 0; ring <= 12; ring++) {
      const around = ring === 0 ? 1 : 6 + ring * 2;
      for (let step = 0; step < around; step++) {
        const angle = (2 * Math.PI * step) / around;
        const reach = (ring / 12) * 0.5;
        const hit = this.#sampleAt({
          x: width * (0.5 + reach * Math.sin(angle)),
          y: height * (0.5 + reach * Math.cos(angle)),
        });
        if (hit !== null) {
          return hitOf(hit);
        }
      }
    }
    return null;
  }

  surfaceAtPointer(clientX: number, clientY: number): SurfaceHit | null {
    const sample = this.#sampleAt(this.#screen.pointOf(clientX, clientY));
    return sample && hitOf(sample);
  }

  projectorAt(hit: SurfaceHit, width: number, aspect: number, keep?: PlanarProjector): PlanarProjector {
    return this.#placement.at(hit, width, aspect, keep);
  }

  nudge(projector: Projector, rightMetres: number, upMetres: number): Projector {
    return this.#placement.nudged(projector, rightMetres, upMetres);
  }

  convertProjector(projector: Projector, kind: Projector["kind"], material: number): Projector | null {
    return this.#placement.placer(projector, material).converted(projector, kind);
  }

  alignProjector(projector: Projector, how: Alignment, material: number): Projector {
    return this.#placement.placer(projector, material).aligned(projector, how);
  }

  get #placement(): ModelPlacement {
    return new ModelPlacement(this.#requireModel(), this.#screen);
  }

  materialsReached(projector: Projector, backfaces: boolean): readonly number[] {
    const volume = reachVolume(projector, backfaces);
    return (volume && this.#model?.whole.materialsWithin(volume)) ?? [];
  }

  setTool(input: ToolInput | null): void {
    this.#tools.tool = input;
    this.#input.suspended = input !== null;
    this.#held.setTwoFingersOrbit(input !== null);
    this.#gizmo.enabled = input === null;
    this.#gradient.enabled = input === null;
  }

  setGradient(place: GradientPlace | null, labels: GradientLabels): void {
    this.#gradient.show(place, labels);
  }

  setRing(ring: BrushRing | null): void {
    this.#tools.showRing(ring);
  }

  setPixelated(material: number, pixelated: boolean | null): void {
    this.#model?.materials.setPixelated(material, pixelated);
    this.#stage.requestFrame();
  }

  get surface(): ToolSurface {
    return this.#tools;
  }

  frameModel(): void {
    this.#view.frameModel();
  }

  frameDecal(id: string): void {
    const decal = this.#view.decals.find((candidate) => candidate.id === id);
    if (decal === undefined || this.#model === null) {
      return;
    }
    const { projector } = decal;
    const pose = projector.kind === "planar" ? poseOf(projector) : pictureBox(this.#model.query, projector);
    if (pose === null) {
      this.frameModel();
    } else {
      frameDecal(this.#stage, { ...pose, position: this.#model.toPosed(pose.position) });
    }
  }

  get clips(): readonly ClipInfo[] {
    return this.#model?.animation.clips ?? [];
  }

  setAnimation(change: Partial<AnimationState>): void {
    this.#clock.set(change);
  }

  get parts(): readonly ModelPart[] {
    return this.#model?.parts ?? [];
  }

  setHiddenParts(ids: ReadonlySet<number>): void {
    const model = this.#model;
    if (model === null) {
      return;
    }
    model.hide(ids);
    this.#display.partsChanged();
    this.#surfaceChanged();
    if (!model.animation.posed) {
      this.#view.castShadow();
    }
    this.#stage.requestFrame();
  }

  #surfaceChanged(): void {
    const query = this.#model?.query ?? null;
    this.#gizmo.setSurface(query);
    this.#tools.setSurface(query);
  }

  guideOf(material: number): readonly GuideEntry[] {
    return this.#model === null ? [] : guideOf(this.#model.scene, material);
  }

  setLook(look: ModelLook): void {
    this.#display.setLook(look);
  }

  setMapPictures(pictures: ReadonlyMap<number, MapPicture> | null): void {
    this.#display.setMaps(pictures);
  }

  highlightChart(place: TexturePlace | null): void {
    this.#display.highlight(place);
  }

  setMarker(place: TexturePlace | null): void {
    this.#display.mark(place);
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

  clientPosition(position: Vec3): { x: number; y: number } | null {
    const point = this.#model && this.#screen.project(this.#model.toPosed(new Vector3(...position)));
    const box = this.element.getBoundingClientRect();
    return point && { x: point.x + box.left, y: point.y + box.top };
  }

  on<K extends keyof ModelViewerEvents>(type: K, listener: (event: ModelViewerEvents[K]) => void): () => void {
    return this.#view.on(type, listener);
  }

  get statistics(): ModelViewer["statistics"] {
    return this.#view.statistics;
  }

  clickAt(clientX: number, clientY: number): void {
    this.#input.clickAt(clientX, clientY);
  }

  dispose(): void {
    this.#view.dispose();
  }

  #letGo(): void {
    this.#clock.dispose();
    this.#input.dispose();
    this.#tools.dispose();
    this.#gradient.dispose();
    this.#display.dispose();
    this.#gizmo.dispose();
    this.#screen.dispose();
  }

  #requireModel(): ShownModel {
    if (this.#model === null) {
      throw new TexelcastError("no-model", "There is no model to place a decal on.", { hint: "Open a model first." });
    }
    return this.#model;
  }

  #sampleAt(point: ScreenPoint): SurfaceSample | null {
    return this.#model?.pick(this.#screen.rayThrough(point)) ?? null;
  }

  #followCamera(): void {
    this.#gizmo.drawNow();
    this.#tools.cameraMoved();
    this.#gradient.drawNow();
    this.#display.moved();
  }

  /** What lies on the surface moves with it. */
  #followModel(): void {
    this.#followCamera();
    this.#stage.requestFrame();
  }

  /** The arrow keys are the tool's or the selected decal's, which the editor moves; without one they turn the camera. */
  #onKey(event: KeyboardEvent): void {
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey && !event.defaultPrevented;
    if (!plain || this.#tools.active || this.#gizmo.selectedDecal !== null) {
      return;
    }
    if (event.key === "0") {
      this.frameModel();
    } else if (this.#held.step(event.key, this.#stage.animates)) {
      this.#stage.requestFrame();
    } else {
      return;
    }
    event.preventDefault();
  }
}
