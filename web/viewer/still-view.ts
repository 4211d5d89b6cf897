/**
 * The model on its stage, with its live texture: all that shows a product, and nothing yet that takes hold of it. Hands come
 * later, with `ModelViewer`, and go on from what is shown.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { ModelInfo, TargetInfo, TargetUpdate } from "../engine/engine-api.ts";
import { adoptStyle } from "./adopt-style.ts";
import { frameModel } from "./camera-framing.ts";
import type { Orbit } from "./camera-orbit.ts";
import type { CameraStand } from "./camera-rig.ts";
import { EventHub } from "./event-hub.ts";
import { type CameraLimits, ModelCamera } from "./model-camera.ts";
import { loadModelScene } from "./model-scene.ts";
import { Stage } from "./stage.ts";
import { StillModel } from "./still-model.ts";
import { UpdateQueue } from "./update-queue.ts";
import type { ModelView, ModelViewerEvents, ViewerDecal } from "./viewer-api.ts";
import { VIEW_STYLE } from "./viewer-style.ts";

export interface ModelViewOptions {
  /** Accessible name of the view; default "3D view". */
  readonly label?: string;
}

/** What takes hold of a view, and is told what happens on its stage. */
export interface ViewHands {
  modelShown(model: StillModel): void;
  /** Before the model is freed. */
  modelGone(): void;
  setDecals(decals: readonly ViewerDecal[], selectedId: string | null): void;
  /** As `StageHooks`. */
  beforeFrame(delta: number): boolean;
  drawOver(): void;
  cameraMoved(): void;
  /** The view is of no use any more. */
  letGo(): void;
}

export class StillView implements ModelView {
  readonly element: HTMLElement;
  readonly stage: Stage;
  readonly events = new EventHub<ModelViewerEvents>();
  readonly #camera: ModelCamera;
  #hands: ViewHands | null = null;
  #model: StillModel | null = null;
  /** The newest load; an older one that ends later is dropped. */
  #loading = 0;
  #decals: readonly ViewerDecal[] = [];
  #selectedId: string | null = null;
  #upload = { milliseconds: 0, bytes: 0 };
  readonly #updates = new UpdateQueue(
    (update) => this.#applyNow(update),
    (task) => this.stage.whenGpuDone(task),
  );
  #disposed = false;

  /** Fills `host`, which must have a size of its own. Throws a TexelcastError without WebGL 2. */
  constructor(host: HTMLElement, options: ModelViewOptions = {}) {
    adoptStyle(host, VIEW_STYLE);
    const root = document.createElement("div");
    root.className = "tcv-root";
    root.tabIndex = 0;
    root.setAttribute("role", "application");
    root.setAttribute("aria-label", options.label ?? "3D view");
    host.append(root);
    this.element = root;
    this.stage = new Stage(root, {
      beforeFrame: (delta) => this.#hands?.beforeFrame(delta) ?? false,
      drawOver: () => this.#hands?.drawOver(),
      afterFrame: (cameraMoved) => {
        if (cameraMoved) this.#hands?.cameraMoved();
      },
      contextRestored: () => {
        this.events.emit("graphics", { lost: false });
        this.#refill();
      },
      contextGone: () => this.events.emit("graphics", { lost: true }),
    });
    this.#camera = new ModelCamera(this.stage);
  }

  get model(): StillModel | null {
    return this.#model;
  }

  get decals(): readonly ViewerDecal[] {
    return this.#decals;
  }

  /** Tells hands of what is there, and of all that comes. */
  take(hands: ViewHands): void {
    this.#hands = hands;
    if (this.#model !== null) hands.modelShown(this.#model);
    hands.setDecals(this.#decals, this.#selectedId);
    this.stage.requestFrame();
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
    const model = new StillModel(this.stage.renderer, scene);
    this.#model = model;
    const hidden = new Set(model.parts.filter((part) => part.hidden).map(({ id }) => id));
    model.hide(hidden);
    this.stage.show(scene.root, model.bounds);
    this.#hands?.modelShown(model);
    this.#camera.setModel(model.positions);
    frameModel(this.stage, model.positions, false);
  }

  bindTarget(info: TargetInfo): void {
    this.#model?.materials.bind(info);
    this.stage.requestFrame();
  }

  applyUpdate(update: TargetUpdate): boolean {
    return this.#updates.push(update);
  }

  setDecals(decals: readonly ViewerDecal[], selectedId: string | null): void {
    this.#decals = decals;
    this.#selectedId = selectedId;
    this.#hands?.setDecals(decals, selectedId);
  }

  frameModel(): void {
    if (this.#model !== null) frameModel(this.stage, this.#model.positions, true);
  }

  /** The shadow is that of the model at rest. */
  castShadow(): void {
    const model = this.#model;
    if (model !== null) this.stage.castShadow(model.scene.root, model.bounds);
  }

  get stand(): CameraStand {
    return this.stage.rig.stand;
  }

  setCamera(place: Orbit | CameraStand | null, limits: CameraLimits): void {
    this.#camera.setLimits(limits);
    if (place !== null) this.#camera.moveTo(place);
  }

  capture(orbit: Orbit | null, width: number, height: number): Promise<Blob | null> {
    return this.#camera.capture(orbit, width, height);
  }

  on<K extends keyof ModelViewerEvents>(type: K, listener: (event: ModelViewerEvents[K]) => void): () => void {
    return this.events.on(type, listener);
  }

  get statistics(): { frames: number; uploadMilliseconds: number; uploadedBytes: number } {
    return {
      frames: this.stage.frames,
      uploadMilliseconds: this.#upload.milliseconds,
      uploadedBytes: this.#upload.bytes,
    };
  }

  dispose(): void {
    if (this.#disposed) return;
    this.#disposed = true;
    this.#dropModel();
    this.#hands?.letGo();
    this.#hands = null;
    this.stage.dispose();
    this.element.remove();
  }

  #applyNow(update: TargetUpdate): void {
    if (this.#model === null) return;
    this.#upload = this.#model.materials.apply(update);
    this.stage.requestFrame();
  }

  #dropModel(): void {
    if (this.#model === null) return;
    this.#updates.clear();
    this.#hands?.modelGone();
    this.#camera.setModel(null);
    this.#model.dispose();
    this.#model = null;
  }

  #refill(): void {
    const model = this.#model;
    if (model === null) return;
    model.materials.rebuild();
    this.castShadow();
    for (const material of model.materials.boundMaterials) this.events.emit("needsFullUpdate", { material });
  }
}
