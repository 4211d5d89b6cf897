/** The 3D view: the model, its live texture, picking and the decal gizmo, behind one interface. */
import { type Ray, Vector3 } from "three";
import { TexelcastError } from "../core/texelcast-error.ts";
import type { ModelInfo, PlanarProjector, Projector, TargetInfo, TargetUpdate, Vec3 } from "../engine/engine-api.ts";
import { frameDecal, frameModel, stepCamera } from "./camera-framing.ts";
import type { Orbit } from "./camera-orbit.ts";
import { ClipClock } from "./clip-clock.ts";
import { DecalGizmo } from "./decal-gizmo.ts";
import { poseOf } from "./decal-pose.ts";
import { EventHub } from "./event-hub.ts";
import { GradientHandles, type GradientLabels, type GradientPlace } from "./gradient-handles.ts";
import { type CameraLimits, ModelCamera } from "./model-camera.ts";
import { ModelDisplay } from "./model-display.ts";
import { guideOf } from "./model-parts.ts";
import { ModelPlacement } from "./model-placement.ts";
import { loadModelScene } from "./model-scene.ts";
import { hitOf, ModelTools } from "./model-tools.ts";
import { pictureBox } from "./projector-outline.ts";
import type { Alignment } from "./projector-placer.ts";
import { reachVolume } from "./reached-materials.ts";
import { type ScreenPoint, ScreenSpace } from "./screen-space.ts";
import { ShownModel } from "./shown-model.ts";
import { Stage } from "./stage.ts";
import type { SurfaceSample } from "./surface-query.ts";
import type { BrushRing, ToolInput, ToolSurface } from "./tool-input.ts";
import { UpdateQueue } from "./update-queue.ts";
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
import { adoptViewerStyle } from "./viewer-style.ts";

export interface ModelViewerOptions {
  /** Accessible name of the view; default "3D view". */
  readonly label?: string;
}

/** Builds a viewer that fills `host`, which must have a size of its own. Throws a TexelcastError without WebGL 2. */
export function createModelViewer(host: HTMLElement, options: ModelViewerOptions = {}): ModelViewer {
  return new ThreeModelViewer(host, options);
}

class ThreeModelViewer implements ModelViewer {
  readonly element: HTMLElement;
  readonly #stage: Stage;
  readonly #screen: ScreenSpace;
  readonly #gizmo: DecalGizmo;
  readonly #tools: ModelTools;
  readonly #gradient: GradientHandles;
  readonly #input: ViewInput;
  readonly #display: ModelDisplay;
  readonly #camera: ModelCamera;
  readonly #clock: ClipClock;
  readonly #events = new EventHub<ModelViewerEvents>();
  #model: ShownModel | null = null;
  /** The newest load; an older one that ends later is dropped. */
  #loading = 0;
  #decals: readonly ViewerDecal[] = [];
  #upload = { milliseconds: 0, bytes: 0 };
  readonly #updates = new UpdateQueue(
    (update) => this.#applyNow(update),
    (task) => this.#stage.whenGpuDone(task),
  );
  #disposed = false;

  constructor(host: HTMLElement, options: ModelViewerOptions) {
    adoptViewerStyle(host);
    const root = document.createElement("div");
    root.className = "tcv-root";
    root.tabIndex = 0;
    root.setAttribute("role", "application");
    root.setAttribute("aria-label", options.label ?? "3D view");
    host.append(root);
    this.element = root;
    this.#stage = new Stage(root, {
      beforeFrame: (delta) => this.#advance(delta),
      drawOver: () => this.#display.drawOver(),
      afterFrame: (cameraMoved) => {
        if (cameraMoved) {
          this.#followCamera();
        }
      },
      contextRestored: () => this.#refill(),
    });
    this.#screen = new ScreenSpace(this.#stage.camera, root);
    this.#gizmo = new DecalGizmo({
      root,
      screen: this.#screen,
      gesture: (gesture) => this.#events.emit("gesture", gesture),
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
    this.#camera = new ModelCamera(this.#stage);
    const pick = (ray: Ray) => this.#model?.pick(ray) ?? null;
    const toDrawn = (point: Vector3) => this.#model?.toPosed(point) ?? point;
    this.#gradient = new GradientHandles(root, this.#screen, {
      pick: (at) => this.#sampleAt(at),
      atRest: () => this.#model !== null && !this.#model.animation.posed,
      changed: (place, phase) => this.#events.emit("gradient", { place, phase }),
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
      select: (id) => this.#events.emit("select", { id }),
      hover: (sample) => this.#events.emit("hover", { hit: sample && hitOf(sample) }),
      setPanning: (pans) => this.#stage.setPanning(pans),
    });
    this.#clock = new ClipClock(root, {
      animation: () => this.#model?.animation ?? null,
      isOnModel: (event) => this.#sampleAt(this.#screen.pointOf(event.clientX, event.clientY)) !== null,
      tell: (state) => this.#events.emit("animation", state),
      changed: () => this.#followModel(),
    });
    root.addEventListener("keydown", (event) => this.#onKey(event));
  }

  async setModel(info: ModelInfo): Promise<void> {
    this.#loading += 1;
    const load = this.#loading;
    const scene = await loadModelScene(info);
    if (load !== this.#loading || this.#disposed) {
      scene.dispose();
      throw new TexelcastError("cancelled", `${info.name} was replaced by another model before it was shown.`);
    }
    this.#dropModel();
    const model = new ShownModel(this.#stage.renderer, scene);
    this.#model = model;
    this.#stage.show(scene.root, model.bounds);
    this.#display.setModel(model);
    this.setHiddenParts(new Set(model.parts.filter(({ hidden }) => hidden).map(({ id }) => id)));
    this.#gizmo.enabled = !this.#tools.active;
    this.#camera.setModel(model.positions);
    frameModel(this.#stage, model.positions, false);
  }

  bindTarget(info: TargetInfo): void {
    this.#model?.materials.bind(info);
    this.#stage.requestFrame();
  }

  applyUpdate(update: TargetUpdate): void {
    this.#updates.push(update);
  }

  setDecals(decals: readonly ViewerDecal[], selectedId: string | null): void {
    this.#decals = decals;
    this.#gizmo.setDecals(decals, selectedId);
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
    this.#stage.setTwoFingersOrbit(input !== null);
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
    if (this.#model !== null) {
      frameModel(this.#stage, this.#model.positions, true);
    }
  }

  frameDecal(id: string): void {
    const decal = this.#decals.find((candidate) => candidate.id === id);
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
    this.#gizmo.setSurface(model.query);
    this.#tools.setSurface(model.query);
    // The shadow is that of the model at rest.
    if (!model.animation.posed) {
      this.#stage.castShadow(model.scene.root, model.bounds);
    }
    this.#stage.requestFrame();
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
    return this.#model === null ? null : this.#stage.picture(width, height);
  }

  setCamera(orbit: Orbit | null, limits: CameraLimits): void {
    this.#camera.setLimits(limits);
    if (orbit !== null) {
      this.#camera.moveTo(orbit);
    }
  }

  capture(orbit: Orbit | null, width: number, height: number): Promise<Blob | null> {
    return this.#camera.capture(orbit, width, height);
  }

  clientPosition(position: Vec3): { x: number; y: number } | null {
    const point = this.#model && this.#screen.project(this.#model.toPosed(new Vector3(...position)));
    const box = this.element.getBoundingClientRect();
    return point && { x: point.x + box.left, y: point.y + box.top };
  }

  on<K extends keyof ModelViewerEvents>(type: K, listener: (event: ModelViewerEvents[K]) => void): () => void {
    return this.#events.on(type, listener);
  }

  get statistics(): { frames: number; uploadMilliseconds: number; uploadedBytes: number } {
    return {
      frames: this.#stage.frames,
      uploadMilliseconds: this.#upload.milliseconds,
      uploadedBytes: this.#upload.bytes,
    };
  }

  dispose(): void {
    this.#disposed = true;
    this.#clock.dispose();
    this.#input.dispose();
    this.#tools.dispose();
    this.#gradient.dispose();
    this.#dropModel();
    this.#display.dispose();
    this.#gizmo.dispose();
    this.#screen.dispose();
    this.#stage.dispose();
    this.element.remove();
  }

  #applyNow(update: TargetUpdate): void {
    if (this.#model !== null) {
      this.#upload = this.#model.materials.apply(update);
      this.#stage.requestFrame();
    }
  }

  #requireModel(): ShownModel {
    if (this.#model === null) {
      throw new TexelcastError("no-model", "There is no model to place a decal on.", { hint: "Open a model first." });
    }
    return this.#model;
  }

  #dropModel(): void {
    const model = this.#model;
    if (model !== null) {
      this.#gizmo.setSurface(null);
      this.#tools.setSurface(null);
      this.#updates.clear();
      this.#display.setModel(null);
      this.#camera.setModel(null);
      model.dispose();
      this.#model = null;
    }
  }

  #sampleAt(point: ScreenPoint): SurfaceSample | null {
    return this.#model?.pick(this.#screen.rayThrough(point)) ?? null;
  }

  #advance(delta: number): boolean {
    this.#display.beforeFrame();
    return this.#clock.advance(delta);
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

  #refill(): void {
    const model = this.#model;
    if (model === null) {
      return;
    }
    model.materials.rebuild();
    this.#stage.castShadow(model.scene.root, model.bounds);
    for (const material of model.materials.boundMaterials) {
      this.#events.emit("needsFullUpdate", { material });
    }
  }

  /** The arrow keys are the tool's or the selected decal's, which the editor moves; without one they turn the camera. */
  #onKey(event: KeyboardEvent): void {
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey && !event.defaultPrevented;
    if (!plain || this.#tools.active || this.#gizmo.selectedDecal !== null) {
      return;
    }
    if (event.key === "0") {
      this.frameModel();
    } else if (!stepCamera(this.#stage, event.key)) {
      return;
    }
    event.preventDefault();
  }
}
