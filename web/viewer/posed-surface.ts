/**
 * The model's surface as an animation has posed it. Everything is painted at rest, so this surface is only for looking:
 * a ray meets the posed triangle, and the place in that triangle (the shares of its corners) is the place at rest.
 */
import type { Ray, Vector3 } from "three";
import type { ModelScene } from "./model-scene.ts";
import { type RestingSurface, writePose } from "./resting-surface.ts";
import { SurfaceQuery, type SurfaceSample } from "./surface-query.ts";

export class PosedSurface {
  readonly #scene: ModelScene;
  readonly #surface: RestingSurface;
  readonly #query: SurfaceQuery;
  readonly #rest: SurfaceQuery;

  /** @param surface the triangles that can be picked, at rest, and `rest` the query on them */
  constructor(scene: ModelScene, surface: RestingSurface, rest: SurfaceQuery) {
    this.#scene = scene;
    this.#rest = rest;
    this.#surface = { ...surface, positions: surface.positions.slice(), normals: surface.normals.slice() };
    writePose(scene, this.#surface);
    this.#query = new SurfaceQuery(this.#surface);
  }

  /** The pose has changed. */
  refresh(): void {
    writePose(this.#scene, this.#surface);
    this.#query.refit();
  }

  /** For questions about what is seen: positions are those of the pose. */
  get query(): SurfaceQuery {
    return this.#query;
  }

  get positions(): Float32Array {
    return this.#surface.positions;
  }

  /** The first posed triangle along the ray, and what lies there at rest; `distance` is that along the ray. */
  pick(ray: Ray): SurfaceSample | null {
    const hit = this.#query.raycast(ray.origin, ray.direction);
    if (hit === null) {
      return null;
    }
    return { ...this.#rest.at(hit.triangle, this.#query.sharesOf(hit)), distance: hit.distance };
  }

  /** Where a point of the resting surface, or close to it, stands in the pose. */
  toPosed(point: Vector3): Vector3 {
    const near = this.#rest.closest(point);
    if (near === null) {
      return point.clone();
    }
    const posed = this.#query.at(near.triangle, this.#rest.sharesOf(near));
    // What stood off the surface stands off it by as much again.
    return posed.position.clone().addScaledVector(posed.normal, point.clone().sub(near.position).dot(near.normal));
  }
}
