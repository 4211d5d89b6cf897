/**
 * The projectors as three.js mathematics: what of the picture a point of the surface sees (spec.md, section 3). No DOM, no
 * scene.
 */
import { Quaternion, Vector3 } from "three";
import type { CylindricalProjector, PerspectiveProjector, Projector, UvProjector } from "../engine/engine-api.ts";
import { containsPoint, facesNormal, poseOf } from "./decal-pose.ts";

/** What a projector may ask of a point of the surface. */
export interface SeenPoint {
  readonly position: Vector3;
  /** Unit. */
  readonly normal: Vector3;
  /** Texture coordinates, not wrapped. */
  readonly uv: readonly [number, number];
}

/** True where the projector's volume holds the point and its light meets the surface's front. */
export function reachesPoint(projector: Projector, point: SeenPoint): boolean {
  if (projector.kind === "planar") {
    const pose = poseOf(projector);
    return containsPoint(pose, point.position) && facesNormal(pose, point.normal);
  }
  if (projector.kind === "uv") {
    return isInside(stampPoint(projector, point.uv));
  }
  const local = toView(projector, point.position);
  const normal = point.normal.clone().applyQuaternion(rotationOf(projector).invert());
  if (projector.kind === "perspective") {
    const depth = -local.z;
    const inDepth = depth >= projector.near && depth <= projector.far;
    return inDepth && normal.dot(local) < 0 && isInside(slidePoint(projector, local));
  }
  const fromAxis = Math.hypot(local.x, local.z);
  const inDepth = fromAxis > 0 && Math.abs(fromAxis - projector.radius) <= projector.depth;
  return inDepth && normal.x * local.x + normal.z * local.z > 0 && isInside(labelPoint(projector, local));
}

/** A point of model space along a posed projector's own axes, metres from its position. */
export function toView(projector: Exclude<Projector, UvProjector>, point: Vector3): Vector3 {
  return point
    .clone()
    .sub(new Vector3(...projector.position))
    .applyQuaternion(rotationOf(projector).invert());
}

export function rotationOf(projector: Exclude<Projector, UvProjector>): Quaternion {
  return new Quaternion(...projector.rotation).normalize();
}

function isInside({ x, y }: { readonly x: number; readonly y: number }): boolean {
  return Math.abs(x) <= 0.5 && Math.abs(y) <= 0.5;
}

function slidePoint({ fov, aspect }: PerspectiveProjector, local: Vector3): { x: number; y: number } {
  const halfHeight = -local.z * Math.tan((fov * Math.PI) / 360);
  return { x: local.x / (2 * halfHeight * aspect), y: local.y / (2 * halfHeight) };
}

function labelPoint({ arc, height }: CylindricalProjector, local: Vector3): { x: number; y: number } {
  return { x: Math.atan2(local.x, local.z) / ((arc * Math.PI) / 180), y: local.y / height };
}

/** Surfaces repeat their texture; the stamp lies in it once. */
function stampPoint({ center, size, angle }: UvProjector, [u, v]: readonly [number, number]): { x: number; y: number } {
  const right = u - Math.floor(u) - center[0];
  const down = v - Math.floor(v) - center[1];
  const radians = (angle * Math.PI) / 180;
  const [sine, cosine] = [Math.sin(radians), Math.cos(radians)];
  return { x: (right * cosine + down * sine) / size[0], y: (right * sine - down * cosine) / size[1] };
}
