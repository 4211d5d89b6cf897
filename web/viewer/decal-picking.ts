/** Which decal a point of the surface, or a ray beside the model, belongs to. */
import { Plane, type Ray, Vector3 } from "three";
import { axisOf, type DecalPose, toLocal } from "./decal-pose.ts";
import { reachesPoint } from "./projector-sight.ts";
import type { SurfaceSample } from "./surface-query.ts";
import type { ViewerDecal } from "./viewer-api.ts";

/** The visible decals whose volume holds the point and looks at it, topmost first; `decals` lie bottom to top. */
export function decalsAt(decals: readonly ViewerDecal[], sample: SurfaceSample): ViewerDecal[] {
  return decals
    .filter(
      (decal) => decal.visible && decal.materials.includes(sample.material) && reachesPoint(decal.projector, sample),
    )
    .reverse();
}

/** Where a ray meets a box's rectangle (its middle plane, within its width and height) from the front; null beside it. */
export function rectangleHit(pose: DecalPose, ray: Ray): Vector3 | null {
  const point = planeHit(pose, 0, ray);
  if (point === null || axisOf(pose, 2).dot(ray.direction) >= 0) {
    return null;
  }
  const local = toLocal(pose, point);
  return Math.abs(local.x) <= pose.size.x / 2 && Math.abs(local.y) <= pose.size.y / 2 ? point : null;
}

/** Where a ray meets the plane of a box's rectangle, raised by `height` metres; null along it or behind the ray. */
export function planeHit(pose: DecalPose, height: number, ray: Ray): Vector3 | null {
  const normal = axisOf(pose, 2);
  // At grazing angles a pixel is worth metres, so a handle would run away.
  if (Math.abs(normal.dot(ray.direction)) < 0.04) {
    return null;
  }
  const point = pose.position.clone().addScaledVector(normal, height);
  return ray.intersectPlane(new Plane().setFromNormalAndCoplanarPoint(normal, point), new Vector3());
}
