/** The editor's 3D view: hands on decals, tools, animations and looks, on a view that shows the model. */
import { Vector3 } from "three";
import { TexelcastError } from "../core/texelcast-error.ts";
import type { Projector, Vec3 } from "../engine/engine-api.ts";
import { adoptStyle } from "./adopt-style.ts";
import { AlignedSlides, type FindSurroundings, type ModelMiddle, middlePlane } from "./aligned-slide.ts";
import { centredOn } from "./alignment-planes.ts";
import { arrangementOf } from "./arrangement.ts";
import { ClipClock } from "./clip-clock.ts";
import { frameDecal } from "./decal-framing.ts";
import { DecalHands } from "./decal-hands.ts";
import { poseOf, projectorOf } from "./decal-pose.ts";
import { GradientHandles, type GradientLabels, type GradientPlace } from "./gradient-handles.ts";
import { HeldCamera } from "./held-camera.ts";
import { landingOn } from "./landing-on-view.ts";
import { ModelDisplay } from "./model-display.ts";
import { guideOf } from "./model-parts.ts";
import { placerFor } from "./model-placer.ts";
import { ModelTools } from "./model-tools.ts";
import { scaleOf } from "./page-scale.ts";
import { pictureBox } from "./projector-outline.ts";
import type { Alignment, ProjectorPlacer } from "./projector-placer.ts";
import { ShownModel } from "./shown-model.ts";
import type { Stage } from "./stage.ts";
import type { StillModel } from "./still-model.ts";
import { type ModelViewOptions, StillView } from "./still-view.ts";
import { THROWN } from "./thrown-kinds.ts";
import type { BrushRing, ToolInput, ToolSurface } from "./tool-input.ts";
import { TOOL_STYLE } from "./tool-style.ts";
import { ViewInHands } from "./view-in-hands.ts";
import { pictureOf } from "./view-picture.ts";
import type {
  AnimationState,
  Arrangement,
  ClipInfo,
  GuideEntry,
  Landing,
  MapPicture,
  ModelLook,
  ModelPart,
  ModelViewer,
  TexturePlace,
} from "./viewer-api.ts";
import { WiderCanvas } from "./wider-canvas.ts";

/** Builds a viewer that fills `host`, which must have a size of its own. Throws a TexelcastError without WebGL 2. */
export function createModelViewer(host: HTMLElement, options: ModelViewOptions = {}): ModelViewer {
  return new ThreeModelViewer(new StillView(host, options));
}

class ThreeModelViewer extends ViewInHands implements ModelViewer {
  readonly #stage: Stage;
  readonly #held: HeldCamera;
  protected readonly hands: DecalHands;
  readonly #tools: ModelTools;
  readonly #gradient: GradientHandles;
  readonly #display: ModelDisplay;
  readonly #slides: AlignedSlides;
  readonly #clock: ClipClock;
  #model: ShownModel | null = null;

  constructor(view: StillView) {
    super(view);
    const { element: root, events } = view;
    this.#stage = view.stage;
    this.#held = view.stage.hold(
      (still) => new HeldCamera(this.#stage.camera, root, still, () => this.#stage.requestFrame()),
    );
    const hands = new DecalHands({
      view,
      rig: this.#held,
      model: () => this.#model,
      thrown: () => THROWN,
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
      aligned: (slide, decal) => this.#slides.over(slide, decal),
    });
    this.hands = hands;
    const { screen, gizmo } = hands;
    adoptStyle(root, TOOL_STYLE);
    root.classList.add("tcv-model");
    const canvas = new WiderCanvas(this.#stage.camera, this.#stage.canvas, screen);
    this.#display = new ModelDisplay(root, this.#stage, screen);
    this.#gradient = new GradientHandles(root, screen, {
      pick: (at) => hands.sampleAt(at),
      atRest: () => this.#model !== null && !this.#model.animation.posed,
      changed: (place, phase) => events.emit("gradient", { place, phase }),
    });
    this.#slides = new AlignedSlides(root, screen, () =>
      this.#model === null || this.#model.animation.posed ? null : this.#model.query,
    );
    events.on("gesture", ({ phase }) => phase !== "move" && this.#slides.hideLines());
    // Before the decals' own input, which it keeps from what a tool takes.
    this.#tools = new ModelTools(root, screen, {
      query: () => this.#model?.query ?? null,
      concealed: () => this.#model?.concealed ?? null,
      pick: (ray) => this.#model?.pick(ray) ?? null,
      toDrawn: (point) => this.#model?.toPosed(point) ?? point,
    });
    hands.listen();
    this.#clock = new ClipClock(root, {
      animation: () => this.#model?.animation ?? null,
      isOnModel: (event) => hands.sampleAt(screen.pointOf(event.clientX, event.clientY)) !== null,
      tell: (state) => events.emit("animation", state),
      changed: () => this.#followModel(),
    });
    // The arrow keys are a tool's before they are the decal's or the camera's.
    root.addEventListener("keydown", (event) => !this.#tools.active && hands.key(event));
    view.take({
      modelShown: (model) => this.#modelShown(model),
      modelGone: () => this.#modelGone(),
      setDecals: (decals, selectedId) => gizmo.setDecals(decals, selectedId),
      beforeFrame: (delta) => {
        this.#display.beforeFrame();
        const angle = this.#display.turned(delta);
        if (angle > 0) this.#held.turn(angle);
        const moves = this.#clock.advance(delta) || angle > 0;
        canvas.widen();
        return moves;
      },
      drawOver: () => {
        this.#display.drawOver();
        canvas.narrow();
      },
      cameraMoved: () => this.#followCamera(),
      letGo: () => this.#letGo(),
    });
  }

  #modelShown(still: StillModel): void {
    const model = new ShownModel(still);
    this.#model = model;
    this.#display.setModel(model);
    this.#surfaceChanged();
    this.hands.gizmo.enabled = !this.#tools.active;
  }

  #modelGone(): void {
    const model = this.#model;
    if (model === null) {
      return;
    }
    this.hands.gizmo.setSurface(null);
    this.#tools.setSurface(null);
    this.#display.setModel(null);
    model.dispose();
    this.#model = null;
  }

  async picture(width: number, height: number): Promise<string | null> {
    return this.#model && pictureOf(this.#stage, width, height);
  }

  keepCamera(): () => void {
    const bring = this.#held.keep();
    return () => {
      bring();
      this.#stage.requestFrame();
    };
  }

  convertProjector(projector: Projector, kind: Projector["kind"], material: number): Projector | null {
    return this.#placer(projector, material).converted(projector, kind);
  }

  alignProjector(projector: Projector, how: Alignment, material: number): Projector {
    return this.#placer(projector, material).aligned(projector, how);
  }

  arrangement(projectors: readonly Projector[]): Arrangement | null {
    return this.#model && arrangementOf(this.#model.query, projectors);
  }

  landing(width: number, aspect: number): Landing | null {
    return this.#model && landingOn(this.hands, this.#model.query, width, aspect, this.#tools);
  }

  centred(projector: Projector, middles: readonly ModelMiddle[]): Projector {
    const query = this.#model?.query;
    if (query === undefined || projector.kind !== "planar") return projector;
    const centred = centredOn(query, poseOf(projector), middles.map(middlePlane));
    return centred === null ? projector : projectorOf(centred);
  }

  setSurroundings(find: FindSurroundings): void {
    this.#slides.find = find;
  }

  setTool(input: ToolInput | null): void {
    this.#tools.tool = input;
    this.hands.suspended = input !== null;
    this.#held.setTwoFingersOrbit(input !== null);
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

  frameDecal(id: string): void {
    const decal = this.view.decals.find((candidate) => candidate.id === id);
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
      this.view.castShadow();
    }
    this.#stage.requestFrame();
  }

  #surfaceChanged(): void {
    const query = this.#model?.query ?? null;
    this.hands.gizmo.setSurface(query);
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

  clientPosition(position: Vec3): { x: number; y: number } | null {
    const point = this.#model && this.hands.screen.project(this.#model.toPosed(new Vector3(...position)));
    const box = this.element.getBoundingClientRect();
    const scale = scaleOf(this.element, box.width);
    return point && { x: point.x / scale + box.left, y: point.y / scale + box.top };
  }

  #letGo(): void {
    this.#clock.dispose();
    this.#tools.dispose();
    this.#gradient.dispose();
    this.#slides.dispose();
    this.#display.dispose();
    this.hands.dispose();
  }

  #placer(projector: Projector, material: number): ProjectorPlacer {
    if (this.#model === null) {
      throw new TexelcastError("no-model", "There is no model to place a decal on.", { hint: "Open a model first." });
    }
    return placerFor(this.#model, this.hands.screen, projector, material);
  }

  #followCamera(): void {
    this.hands.gizmo.drawNow();
    this.#tools.cameraMoved();
    this.#gradient.drawNow();
    this.#slides.hideLines();
    this.#display.moved();
  }

  /** What lies on the surface moves with it. */
  #followModel(): void {
    this.#followCamera();
    this.#stage.requestFrame();
  }
}
