/**
 * The model's surface as an animation has posed it. Everything is painted at rest, so this surface is only for looking:
 * a ray meets the posed triangle, and the place in that triangle (the shares of its corners) is the place at rest.
 */
import { Matrix4, Quaternion, type Ray, type Vector3 } from "three";
import type { ModelScene } from "./model-scene.ts";
import type { ViewPoint } from "./projector-align.ts";
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

  /** The rigid motion that has brought the surface near a resting point to where it stands in the pose. */
  motionAt(point: Vector3): Matrix4 {
    const near = this.#rest.closest(point);
    if (near === null) {
      return new Matrix4();
    }
    const posed = this.#query.at(near.triangle, this.#rest.sharesOf(near)).position;
    const turn = frameOf(this.#query, near.triangle).multiply(frameOf(this.#rest, near.triangle).invert());
    const { x, y, z } = near.position.clone().negate();
    return new Matrix4()
      .makeTranslation(posed)
      .multiply(new Matrix4().makeRotationFromQuaternion(turn))
      .multiply(new Matrix4().makeTranslation(x, y, z));
  }

  /**
   * From where, and which way up, the resting surface near a point is seen as the posed one is seen from `view`: what steps
   * and directions of the view mean for something that lies there.
   */
  viewAtRest(point: Vector3, view: ViewPoint): ViewPoint {
    const toRest = this.motionAt(point).invert();
    return {
      eye: view.eye.clone().applyMatrix4(toRest),
      right: view.right.clone().transformDirection(toRest),
      up: view.up.clone().transformDirection(toRest),
    };
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

/** How a triangle stands: its first edge is +X, its face +Z. */
function frameOf(query: SurfaceQuery, triangle: number): Quaternion {
  const corner = (shares: [number, number, number]): Vector3 => query.at(triangle, shares).position;
  const [a, b, c] = [corner([1, 0, 0]), corner([0, 1, 0]), corner([0, 0, 1])];
  const x = b.sub(a).normalize();
  const z = x.clone().cross(c.sub(a)).normalize();
  if (x.lengthSq() === 0 || z.lengthSq() === 0) {
    return new Quaternion();
  }
  return new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(x, z.clone().cross(x), z));
}
