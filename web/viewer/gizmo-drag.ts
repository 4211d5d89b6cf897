/** A drag in progress: what the pointer's way makes of a decal's box, and how that reads. */
import { type Ray, Vector3 } from "three";
import type { SizeLimits } from "./decal-handles.ts";
import { deepenByHandle, type HandleSide, rotateByHandle, scaleByHandle } from "./decal-handles.ts";
import { planeHit } from "./decal-picking.ts";
import { smoothed, smoothedNear } from "./decal-placement.ts";
import { axisOf, type DecalPose, rollOf, type SurfacePoint, toLocal } from "./decal-pose.ts";
import { DecalSlide } from "./decal-slide.ts";
import type { ScaleHandleName } from "./gizmo-overlay.ts";
import type { SurfaceQuery, SurfaceSample } from "./surface-query.ts";
import type { DecalGesture } from "./viewer-api.ts";

/** The pointer at a moment of a drag. */
export interface DragPointer {
  readonly ray: Ray;
  readonly alt: boolean;
  readonly shift: boolean;
  /** On a posed model: what the pointer meets, as it lies at rest. Left out at rest, where the ray itself is asked. */
  readonly met?: SurfaceSample | null;
}

export interface GizmoDrag {
  readonly kind: DecalGesture["kind"];
  /** The pose at this place of the pointer; null where it says nothing (beside the model, along the plane). */
  move(pointer: DragPointer): DecalPose | null;
  /** glTF material of the surface that the decal was dragged onto; null while that is unknown. */
  readonly material: number | null;
  /** What the gesture has come to, for the label at the pointer; null for none. */
  readout(pose: DecalPose): string | null;
}

export const SNAP = Math.PI / 12;

/** A surface that looks away from the eye by more than this is behind the silhouette: the decal stays in front. */
const SILHOUETTE = 0.25;

/** Slides along the surface by the point that was grabbed, which may lie beside the model on the box's rectangle. */
export function slideDrag(query: SurfaceQuery, start: DecalPose, grab: SurfacePoint): GizmoDrag {
  const slide = new DecalSlide(start, smoothedNear(query, grab, start.size));
  const lift = heightOver(query, start);
  let last = grab.position;
  let material: number | null = null;
  return {
    kind: "slide",
    get material() {
      return material;
    },
    readout: () => null,
    move({ ray, met }) {
      const target =
        met === undefined ? (query.raycast(ray.origin, ray.direction) ?? silhouettePoint(query, ray, last)) : met;
      if (target === null) {
        return null;
      }
      last = target.position;
      material = target.material;
      return settle(query, slide.step(smoothed(query, target, start.size)), lift);
    },
  };
}

export function scaleDrag(
  start: DecalPose,
  name: ScaleHandleName,
  height: number,
  from: Ray,
  limits: SizeLimits,
): GizmoDrag {
  const side = sideOf(name);
  const begin = localHit(start, height, from);
  return {
    kind: "scale",
    material: null,
    readout: (pose) => formatLengths([pose.size.x, pose.size.y]),
    move({ ray, alt }) {
      const now = localHit(start, height, ray);
      if (begin === null || now === null) {
        return null;
      }
      return scaleByHandle(start, side, { x: now.x - begin.x, y: now.y - begin.y }, alt, limits);
    },
  };
}

export function rotateDrag(start: DecalPose, height: number, from: Ray): GizmoDrag {
  const begin = localHit(start, height, from);
  return {
    kind: "rotate",
    material: null,
    readout: (pose) => formatDegrees(rollOf(pose.rotation)),
    move({ ray, shift }) {
      const now = localHit(start, height, ray);
      if (begin === null || now === null) {
        return null;
      }
      const turn = Math.atan2(now.y, now.x) - Math.atan2(begin.y, begin.x);
      return rotateByHandle(start, turn, shift ? SNAP : null);
    },
  };
}

export function depthDrag(start: DecalPose, from: Ray, limits: SizeLimits): GizmoDrag {
  const begin = alongAxis(start, from);
  return {
    kind: "depth",
    material: null,
    readout: (pose) => formatLengths([pose.size.z]),
    move({ ray }) {
      const now = alongAxis(start, ray);
      return begin === null || now === null ? null : deepenByHandle(start, now - begin, limits);
    },
  };
}

export function formatDegrees(radians: number): string {
  return `${Math.round((radians * 180) / Math.PI)}°`.replace("-", "−");
}

/** "8.2 × 4.1 cm": one unit for all, the one that gives the largest a readable number. */
export function formatLengths(metres: readonly number[]): string {
  const largest = Math.max(...metres);
  const [unit, factor] =
    largest < 0.01 ? (["mm", 1000] as const) : largest < 1 ? (["cm", 100] as const) : (["m", 1] as const);
  const numbers = metres.map((length) => {
    const value = length * factor;
    return value.toFixed(value < 10 ? 2 : value < 100 ? 1 : 0);
  });
  return `${numbers.join(" × ")} ${unit}`;
}

/** Beside the model the decal follows along its silhouette: the surface point nearest to the pointer's ray. */
function silhouettePoint(query: SurfaceQuery, ray: Ray, last: Vector3): SurfaceSample | null {
  const beside = ray.closestPointToPoint(last, new Vector3());
  const nearest = query.closest(beside);
  return nearest !== null && nearest.normal.dot(ray.direction) < SILHOUETTE ? nearest : null;
}

/**
 * A decal that is held at its rim would rise off a surface that curves away under its centre. It is lowered (or raised)
 * along its own axis, which leaves the picture under the pointer where it is.
 */
function settle(query: SurfaceQuery, pose: DecalPose, lift: number | null): DecalPose {
  const now = heightOver(query, pose);
  if (lift === null || now === null) {
    return pose;
  }
  return { ...pose, position: pose.position.clone().addScaledVector(axisOf(pose, 2), lift - now) };
}

/** Height of a box's centre over the surface along its own axis, metres; null where there is none close by. */
function heightOver(query: SurfaceQuery, pose: DecalPose): number | null {
  const forward = axisOf(pose, 2);
  const reach = Math.max(pose.size.z / 2, 0.35 * Math.max(pose.size.x, pose.size.y));
  const origin = pose.position.clone().addScaledVector(forward, reach);
  const depth = query.distanceAlong(origin, forward.negate(), 2 * reach);
  return depth === null ? null : depth - reach;
}

export function sideOf(name: ScaleHandleName): HandleSide {
  return {
    x: name.includes("e") ? 1 : name.includes("w") ? -1 : 0,
    y: name.includes("n") ? 1 : name.includes("s") ? -1 : 0,
  };
}

function localHit(pose: DecalPose, height: number, ray: Ray): Vector3 | null {
  const hit = planeHit(pose, height, ray);
  return hit === null ? null : toLocal(pose, hit);
}

/** How far along a box's +Z axis, from its centre in metres, the ray passes nearest; null where both run alike. */
export function alongAxis(pose: DecalPose, ray: Ray): number | null {
  const axis = axisOf(pose, 2);
  const slant = axis.dot(ray.direction);
  const between = pose.position.clone().sub(ray.origin);
  const denominator = 1 - slant * slant;
  return denominator < 1e-3 ? null : (slant * between.dot(ray.direction) - between.dot(axis)) / denominator;
}
