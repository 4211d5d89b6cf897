/** A shown model with all that hands need of it: what they point at, its animation, its looks. Replaced as a whole. */
import { type Box3, Matrix4, type Ray, type Vector3 } from "three";
import { ModelAnimation } from "./model-animation.ts";
import { ModelLook } from "./model-look.ts";
import type { ModelScene } from "./model-scene.ts";
import type { PaintedMaterials } from "./painted-materials.ts";
import { PosedSurface } from "./posed-surface.ts";
import type { ViewPoint } from "./projector-align.ts";
import { DOUBLE_SIDED, gatherRestingSurface, type RestingSurface, triangleSubset } from "./resting-surface.ts";
import type { StillModel } from "./still-model.ts";
import { type SurfaceChart, SurfaceCharts } from "./surface-charts.ts";
import { SurfaceQuery, type SurfaceSample } from "./surface-query.ts";
import type { ModelPart, TexturePlace } from "./viewer-api.ts";

export class ShownModel {
  readonly scene: ModelScene;
  readonly bounds: Box3;
  readonly parts: readonly ModelPart[];
  readonly materials: PaintedMaterials;
  readonly #still: StillModel;
  readonly animation: ModelAnimation;
  readonly look: ModelLook;
  /** All triangles at rest, hidden or not: what decides which materials a decal reaches. */
  readonly whole: SurfaceQuery;
  readonly #surface: RestingSurface;
  #visible: RestingSurface;
  #query: SurfaceQuery;
  #concealed: SurfaceQuery | null = null;
  #charts: SurfaceCharts;
  #posed: PosedSurface | null = null;
  /** The pose that `#posed` shows. */
  #shownPose = 0;

  constructor(still: StillModel) {
    const { scene } = still;
    this.#still = still;
    this.scene = scene;
    this.#surface = gatherRestingSurface(scene);
    this.bounds = still.bounds;
    this.parts = still.parts;
    this.materials = still.materials;
    this.whole = new SurfaceQuery(this.#surface);
    this.#visible = this.#surface;
    this.#query = this.whole;
    this.#charts = new SurfaceCharts(this.#surface);
    this.animation = new ModelAnimation(scene);
    this.look = new ModelLook(scene);
    if (still.hidden.size > 0) this.#leaveOut(still.hidden);
  }

  /** The visible triangles at rest. */
  get query(): SurfaceQuery {
    return this.#query;
  }

  /** The hidden triangles at rest, seen from both sides; null where nothing is hidden. */
  get concealed(): SurfaceQuery | null {
    return this.#concealed;
  }

  /** Vertices at rest, three numbers each. */
  get positions(): Float32Array {
    return this.#surface.positions;
  }

  /** Neither drawn nor met by the pointer; what is painted does not heed it. */
  hide(parts: ReadonlySet<number>): void {
    this.#still.hide(parts);
    this.#leaveOut(parts);
  }

  #leaveOut(parts: ReadonlySet<number>): void {
    this.#posed = null;
    this.#visible = parts.size === 0 ? this.#surface : triangleSubset(this.#surface, (mesh) => !parts.has(mesh));
    this.#query = parts.size === 0 ? this.whole : new SurfaceQuery(this.#visible);
    this.#concealed = null;
    if (parts.size > 0) {
      const hidden = triangleSubset(this.#surface, (mesh) => parts.has(mesh));
      hidden.flagsOfTriangle.forEach((flags, triangle) => {
        hidden.flagsOfTriangle[triangle] = flags | DOUBLE_SIDED;
      });
      this.#concealed = hidden.index.length > 0 ? new SurfaceQuery(hidden) : null;
    }
    this.#charts = new SurfaceCharts(this.#visible);
  }

  /** What a ray of the view meets, told as it lies at rest. */
  pick(ray: Ray): SurfaceSample | null {
    return this.animation.posed ? this.#pose().pick(ray) : this.#query.raycast(ray.origin, ray.direction);
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
  viewAtRest(point: Vector3, view: ViewPoint): ViewPoint {
    return this.animation.posed ? this.#pose().viewAtRest(point, view) : view;
  }

  /** The surface as it is drawn: for what hides what on the screen. */
  get drawn(): SurfaceQuery {
    return this.animation.posed ? this.#pose().query : this.#query;
  }

  /** Vertices as they are drawn, three numbers each. */
  get drawnPositions(): Float32Array {
    return this.animation.posed ? this.#pose().positions : this.#visible.positions;
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
      this.#posed = new PosedSurface(this.scene, this.#visible, this.#query);
    } else if (this.#shownPose !== this.animation.pose) {
      this.#posed.refresh();
    }
    this.#shownPose = this.animation.pose;
    return this.#posed;
  }
}
