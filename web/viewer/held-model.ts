/** A shown model with what hands need of it to point at: its surface at rest. Replaced as a whole. */
import type { Ray, Vector3 } from "three";
import type { ViewPoint } from "./projector-align.ts";
import { DOUBLE_SIDED, gatherRestingSurface, type RestingSurface, triangleSubset } from "./resting-surface.ts";
import type { StillModel } from "./still-model.ts";
import { SurfaceQuery, type SurfaceSample } from "./surface-query.ts";

export class HeldModel {
  /** All triangles at rest, hidden or not: what decides which materials a decal reaches. */
  readonly whole: SurfaceQuery;
  protected readonly surface: RestingSurface;
  /** The visible triangles. */
  protected visible: RestingSurface;
  #query: SurfaceQuery;
  #concealed: SurfaceQuery | null = null;

  constructor({ scene, hidden }: StillModel) {
    this.surface = gatherRestingSurface(scene);
    this.whole = new SurfaceQuery(this.surface);
    this.visible = this.surface;
    this.#query = this.whole;
    if (hidden.size > 0) this.leaveOut(hidden);
  }

  /** The visible triangles at rest. */
  get query(): SurfaceQuery {
    return this.#query;
  }

  /** The hidden triangles at rest, seen from both sides; null where nothing is hidden. */
  get concealed(): SurfaceQuery | null {
    return this.#concealed;
  }

  /** What a ray of the view meets, told as it lies at rest. */
  pick(ray: Ray): SurfaceSample | null {
    return this.#query.raycast(ray.origin, ray.direction);
  }

  /** From where, and which way up, the resting surface near a point is seen. */
  viewAtRest(_point: Vector3, view: ViewPoint): ViewPoint {
    return view;
  }

  protected leaveOut(parts: ReadonlySet<number>): void {
    this.visible = parts.size === 0 ? this.surface : triangleSubset(this.surface, (mesh) => !parts.has(mesh));
    this.#query = parts.size === 0 ? this.whole : new SurfaceQuery(this.visible);
    this.#concealed = null;
    if (parts.size > 0) {
      const hidden = triangleSubset(this.surface, (mesh) => parts.has(mesh));
      hidden.flagsOfTriangle.forEach((flags, triangle) => {
        hidden.flagsOfTriangle[triangle] = flags | DOUBLE_SIDED;
      });
      this.#concealed = hidden.index.length > 0 ? new SurfaceQuery(hidden) : null;
    }
  }
}
