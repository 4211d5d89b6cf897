/** The editor's tools in the 3D view: their pointer, their ring, and the places of the surface that they ask for. */
import { type Ray, Vector3 } from "three";
import type { PerspectiveProjector, Vec3 } from "../engine/engine-api.ts";
import { SurfaceRing } from "./brush-ring.ts";
import { smoothedNear } from "./decal-placement.ts";
import { tangentPart, tupleOf } from "./decal-pose.ts";
import type { ScreenPoint, ScreenSpace } from "./screen-space.ts";
import { hitOf } from "./surface-hit.ts";
import type { SurfaceQuery, SurfaceSample } from "./surface-query.ts";
import { type SurfaceSight, seenFrom } from "./surface-sight.ts";
import { type TexelPlaces, texelPlaces } from "./texel-places.ts";
import type { BrushRing, ToolInput, ToolSurface } from "./tool-input.ts";
import { ToolPointer } from "./tool-pointer.ts";
import type { SurfaceHit } from "./viewer-api.ts";

/** Points of a circle as it is shown in the texture. */
const CIRCLE_POINTS = 40;

export interface ModelToolsHooks {
  /** The visible surface at rest; null while there is nothing to paint on. */
  query(): SurfaceQuery | null;
  /** The hidden surface at rest, seen from both sides; null where nothing is hidden. */
  concealed(): SurfaceQuery | null;
  /** What a ray of the view meets, told as it lies at rest. */
  pick(ray: Ray): SurfaceSample | null;
  /** Where a point of the resting surface is drawn. */
  toDrawn(point: Vector3): Vector3;
}

export class ModelTools implements ToolSurface {
  readonly #pointer: ToolPointer;
  readonly #ring: SurfaceRing;
  readonly #screen: ScreenSpace;
  readonly #hooks: ModelToolsHooks;

  constructor(root: HTMLElement, screen: ScreenSpace, hooks: ModelToolsHooks) {
    this.#screen = screen;
    this.#hooks = hooks;
    this.#ring = new SurfaceRing(root, screen, hooks.toDrawn);
    this.#pointer = new ToolPointer(root, {
      kind: "model",
      hitAt: (at) => this.#hitAt(at),
      uvAt: (at) => this.#hitAt(at)?.uv ?? null,
      placeOf: (hit) => screen.project(new Vector3(...hit.position)),
    });
  }

  get active(): boolean {
    return this.#pointer.tool !== null;
  }

  set tool(input: ToolInput | null) {
    this.#pointer.tool = input;
    if (input === null) this.#ring.show(null);
  }

  setSurface(query: SurfaceQuery | null): void {
    this.#ring.setSurface(query);
  }

  showRing(ring: BrushRing | null): void {
    this.#ring.show(ring);
  }

  cameraMoved(): void {
    this.#ring.drawNow();
  }

  near(position: Vec3, width = 0): SurfaceHit | null {
    const query = this.#hooks.query();
    const sample = query?.closest(new Vector3(...position));
    if (!query || !sample) return null;
    const normal = width > 0 ? smoothedNear(query, sample, new Vector3(width, width, 0)).normal : sample.normal;
    return hitOf({ ...sample, normal });
  }

  atUv(material: number, uv: readonly [number, number]): SurfaceHit | null {
    const query = this.#hooks.query();
    const place = query?.triangleAtUv(material, uv) ?? null;
    return query && place && hitOf(query.at(place.triangle, place.shares));
  }

  freeAbove(position: Vec3, normal: Vec3, reach: number): number {
    return this.#hooks.concealed()?.raycast(new Vector3(...position), new Vector3(...normal), reach)?.distance ?? reach;
  }

  /** The circle of the tangent plane, carried into the texture by the triangle's own affine map. */
  circleInTexture(hit: SurfaceHit, radius: number): readonly (readonly [number, number])[] {
    const query = this.#hooks.query();
    const place = query?.triangleAtUv(hit.material, hit.uv) ?? null;
    if (query === null || place === null) return [];
    const { u, v } = query.uvGradients(place.triangle);
    const normal = new Vector3(...hit.normal);
    const x = tangentPart(Math.abs(normal.y) < 0.9 ? new Vector3(0, 1, 0) : new Vector3(1, 0, 0), normal).normalize();
    const y = normal.clone().cross(x);
    return Array.from({ length: CIRCLE_POINTS }, (_, step) => {
      const angle = (2 * Math.PI * step) / CIRCLE_POINTS;
      const away = x
        .clone()
        .multiplyScalar(Math.cos(angle) * radius)
        .addScaledVector(y, Math.sin(angle) * radius);
      return [hit.uv[0] + u.dot(away), hit.uv[1] + v.dot(away)] as const;
    });
  }

  /** The inverse of the triangle's affine map: u and v to metres along it. */
  placesInModel(hit: SurfaceHit, uvs: readonly (readonly [number, number])[]): readonly Vec3[] {
    const query = this.#hooks.query();
    const place = query?.triangleAtUv(hit.material, hit.uv) ?? null;
    if (query === null || place === null) return [];
    const { u, v } = query.uvGradients(place.triangle);
    const normal = u.clone().cross(v);
    const alongU = v.clone().cross(normal);
    const alongV = normal.clone().cross(u);
    alongU.divideScalar(alongU.dot(u) || 1);
    alongV.divideScalar(alongV.dot(v) || 1);
    const origin = new Vector3(...hit.position);
    return uvs.map((uv) =>
      tupleOf(
        origin
          .clone()
          .addScaledVector(alongU, uv[0] - hit.uv[0])
          .addScaledVector(alongV, uv[1] - hit.uv[1]),
      ),
    );
  }

  texelPlaces(material: number, width: number, height: number): TexelPlaces | null {
    const query = this.#hooks.query();
    return query && texelPlaces(query, material, width, height);
  }

  lookAt(hit: SurfaceHit): { readonly eye: Vec3; readonly up: Vec3 } {
    const place = new Vector3(...hit.position);
    const drawn = this.#hooks.toDrawn(place);
    const { eye } = this.#screen;
    if (drawn.equals(place)) return { eye: tupleOf(eye), up: tupleOf(this.#screen.axes.up) };
    const above = place.clone().addScaledVector(new Vector3(...hit.normal), eye.distanceTo(drawn));
    const isLevel = Math.abs(hit.normal[1]) > 0.99;
    return { eye: tupleOf(above), up: isLevel ? [0, 0, -1] : [0, 1, 0] };
  }

  seenFrom(eye: PerspectiveProjector, width: number, height: number): SurfaceSight | null {
    const query = this.#hooks.query();
    return query && seenFrom(query.surface, eye, width, height);
  }

  metresPerPixel(hit: SurfaceHit): number {
    return this.#screen.metresPerPixel(this.#hooks.toDrawn(new Vector3(...hit.position)));
  }

  dispose(): void {
    this.#pointer.dispose();
    this.#ring.dispose();
  }

  #hitAt(at: ScreenPoint): SurfaceHit | null {
    const sample = this.#hooks.pick(this.#screen.rayThrough(at));
    return sample && hitOf(sample);
  }
}
