/** A held model with all that the editor needs of it: its animation, its looks, its charts. Replaced as a whole. */
import { type Box3, Matrix4, type Ray, type Vector3 } from "three";
import { HeldModel } from "./held-model.ts";
import { ModelAnimation } from "./model-animation.ts";
import { ModelLook } from "./model-look.ts";
import type { ModelScene } from "./model-scene.ts";
import type { PaintedMaterials } from "./painted-materials.ts";
import { PosedSurface } from "./posed-surface.ts";
import type { ViewPoint } from "./projector-align.ts";
import type { StillModel } from "./still-model.ts";
import { type SurfaceChart, SurfaceCharts } from "./surface-charts.ts";
import type { SurfaceQuery, SurfaceSample } from "./surface-query.ts";
import type { ModelPart, TexturePlace } from "./viewer-api.ts";

export class ShownModel extends HeldModel {
  readonly scene: ModelScene;
  readonly bounds: Box3;
  readonly parts: readonly ModelPart[];
  readonly materials: PaintedMaterials;
  readonly #still: StillModel;
  readonly animation: ModelAnimation;
  readonly look: ModelLook;
  #charts: SurfaceCharts;
  #posed: PosedSurface | null = null;
  /** The pose that `#posed` shows. */
  #shownPose = 0;

  constructor(still: StillModel) {
    super(still);
    const { scene } = still;
    this.#still = still;
    this.scene = scene;
    this.bounds = still.bounds;
    this.parts = still.parts;
    this.materials = still.materials;
    this.#charts = new SurfaceCharts(this.visible);
    this.animation = new ModelAnimation(scene);
    this.look = new ModelLook(scene);
  }

  /** Vertices at rest, three numbers each. */
  get positions(): Float32Array {
    return this.surface.positions;
  }

  /** Neither drawn nor met by the pointer; what is painted does not heed it. */
  hide(parts: ReadonlySet<number>): void {
    this.#still.hide(parts);
    this.leaveOut(parts);
    this.#posed = null;
    this.#charts = new SurfaceCharts(this.visible);
  }

  /** What a ray of the view meets, told as it lies at rest. */
  override pick(ray: Ray): SurfaceSample | null {
    return this.animation.posed ? this.#pose().pick(ray) : super.pick(ray);
  }

  /** Where a point of the resting surface stands now. */
  toPosed(point: Vector3): Vector3 {
    return this.animation.posed ? this.#pose().toPosed(point) : point;
  }

  /** `PosedSurface.motionAt`; no motion, while the model rests. */
  motionAt(point: Vector3): Matrix4 {
    return this.animation.posed ? this.#pose().motionAt(point) : new Matrix4();
  }

  /** `PosedSurface.viewAtRest`; the view as it is, while the model rests. */
  override viewAtRest(point: Vector3, view: ViewPoint): ViewPoint {
    return this.animation.posed ? this.#pose().viewAtRest(point, view) : view;
  }

  /** The surface as it is drawn: for what hides what on the screen. */
  get drawn(): SurfaceQuery {
    return this.animation.posed ? this.#pose().query : this.query;
  }

  /** Vertices as they are drawn, three numbers each. */
  get drawnPositions(): Float32Array {
    return this.animation.posed ? this.#pose().positions : this.visible.positions;
  }

  chartAt(place: TexturePlace): SurfaceChart | null {
    return this.#charts.at(place);
  }

  /** Leaves the model as it was shown without hands. */
  dispose(): void {
    this.animation.dispose();
    this.look.dispose();
  }

  /** Brought up to the pose on demand: a clip that nobody points at costs nothing. */
  #pose(): PosedSurface {
    if (this.#posed === null) {
      this.#posed = new PosedSurface(this.scene, this.visible, this.query);
    } else if (this.#shownPose !== this.animation.pose) {
      this.#posed.refresh();
    }
    this.#shownPose = this.animation.pose;
    return this.#posed;
  }
}
