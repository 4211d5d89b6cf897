/** Where a decal's box lies well on a surface: first placement, keyboard steps, the foot beneath a box. */
import { Quaternion, Vector3 } from "three";
import {
  axisOf,
  type DecalPose,
  fromLocal,
  minimalRotation,
  rollOf,
  type SurfacePoint,
  tangentPart,
  UP_MODEL,
  uprightFrame,
  uprightness,
} from "./decal-pose.ts";
import { DecalSlide } from "./decal-slide.ts";
import type { SurfaceQuery, SurfaceSample } from "./surface-query.ts";

/** The camera's axes in model space, unit. */
export interface ViewAxes {
  readonly right: Vector3;
  readonly up: Vector3;
}

/** The normal is averaged over this share of the decal's longer side... */
const AVERAGING_SHARE = 0.35;
/** ...but over no more of the model than this, in radii, or a large decal would not follow its shape at all. */
const MOST_AVERAGING = 0.3;
/** Below this slope (sine of the angle between normal and vertical) "upright" is the camera's matter, not the model's. */
const LEVEL_BELOW = 0.35;
/** Depth of a new box in its longer side, before the surface's shape is looked at. */
const USUAL_DEPTH = 0.5;
/** Rays along each side of the box when its depth is chosen. */
const DEPTH_SAMPLES = 5;

/** How wide a decal looks at the surface when it takes its normal there, metres. */
export function averagingRadius(query: SurfaceQuery, size: Vector3): number {
  return Math.min(AVERAGING_SHARE * Math.max(size.x, size.y), MOST_AVERAGING * query.bounds.radius);
}

/** A surface point with its normal averaged as a decal of this size wants it. */
export function smoothed(query: SurfaceQuery, place: SurfaceSample, size: Vector3): SurfacePoint {
  return { position: place.position, normal: query.smoothNormal(place, averagingRadius(query, size)) };
}

/**
 * The same for a point that may lie beside the surface: the normal is that of the surface nearest to it, to the side that the
 * point's own looks to.
 */
export function smoothedNear(query: SurfaceQuery, place: SurfacePoint, size: Vector3): SurfacePoint {
  const nearest = query.closest(place.position);
  if (nearest === null) return place;
  const { normal } = smoothed(query, nearest, size);
  if (normal.dot(place.normal) < 0) normal.negate();
  return { position: place.position, normal };
}

/**
 * A box centred on `place`, its +Z the surface's normal, upright to the model (to the camera on level surfaces).
 * Its depth reaches over the surface's shape, and not to another surface behind that faces the same way.
 * `keep` hands over its roll and its depth.
 */
export function placeOnSurface(
  query: SurfaceQuery,
  place: SurfacePoint,
  width: number,
  aspect: number,
  view: ViewAxes,
  keep: DecalPose | null,
): DecalPose {
  const height = width / aspect;
  const size = new Vector3(width, height, USUAL_DEPTH * Math.max(width, height));
  const { normal } = smoothedNear(query, place, size);
  const up = uprightness(normal) > LEVEL_BELOW ? UP_MODEL : levelUp(normal, view);
  const rotation = uprightFrame(normal, up) ?? new Quaternion();
  const pose: DecalPose = { position: place.position.clone(), rotation, size };
  if (keep !== null) {
    rotation.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), rollOf(keep.rotation)));
    size.z = keep.size.z;
    return pose;
  }
  size.z = fittingDepth(query, pose);
  // What is seen is painted: what lies over its middle and is not seen there, as the near wall of a thin leg that is turned inside
  // out, would occlude it, unless it is as near as that.
  const least = query.bounds.radius / 1e3;
  const cover = query.distanceAlong(fromLocal(pose, 0, 0, least), normal, size.z / 2 - least);
  return cover === null ? pose : cutAbove(pose, KEPT_CLEARANCE * cover);
}

/** The box with no more than `free` of it above its middle. */
function cutAbove(pose: DecalPose, free: number): DecalPose {
  const top = pose.size.z / 2;
  const position = fromLocal(pose, 0, 0, (free - top) / 2);
  return { ...pose, position, size: pose.size.clone().setZ(top + free) };
}

/**
 * A box of another size reaches as deep for its size as it did before: one that covered the surface's shape goes on to, one
 * that was made shallower is as much shallower than that.
 */
export function resized(query: SurfaceQuery, before: DecalPose, after: DecalPose): DecalPose {
  if (before.size.x === after.size.x && before.size.y === after.size.y) return after;
  const usual = ({ position, rotation, size: { x, y } }: DecalPose): number =>
    fittingDepth(query, { position, rotation, size: new Vector3(x, y, USUAL_DEPTH * Math.max(x, y)) });
  const depth = (after.size.z * usual(after)) / usual(before);
  return { ...after, size: after.size.clone().setZ(depth) };
}

/** The box turned so that it faces along a normal: the least leaning one leaves the most room under a layer. */
export function laidFlat(pose: DecalPose, normal: Vector3): DecalPose {
  const rotation = minimalRotation(axisOf(pose, 2), normal).multiply(pose.rotation).normalize();
  return { ...pose, rotation };
}

/** A box keeps this share of the way to what is hidden above it. */
const KEPT_CLEARANCE = 0.9;

/**
 * A box on the visible surface, cut off on its outer side where it would reach a hidden one that lies over it: a decal
 * that is placed under a hidden layer is painted there, and not on the layer.
 */
export function beneath(concealed: SurfaceQuery, query: SurfaceQuery, pose: DecalPose): DecalPose {
  const outward = axisOf(pose, 2);
  const top = pose.size.z / 2;
  let free = top;
  for (const [x, y] of gridOf(DEPTH_SAMPLES)) {
    const above = fromLocal(pose, x * pose.size.x, y * pose.size.y, top);
    const foot = query.raycast(above, outward.clone().negate(), pose.size.z);
    if (foot !== null) {
      const cover = concealed.raycast(foot.position, outward, foot.distance);
      const height = top - foot.distance;
      if (cover !== null) free = Math.min(free, height + KEPT_CLEARANCE * cover.distance);
    }
  }
  return cutAbove(pose, free);
}

/** The surface point beneath (or above) a box's centre along its own axis; the nearest one where the axis meets none. */
export function footOf(query: SurfaceQuery, pose: DecalPose): SurfaceSample | null {
  const origin = fromLocal(pose, 0, 0, pose.size.z / 2);
  return query.raycast(origin, axisOf(pose, 2).negate(), pose.size.z) ?? query.closest(pose.position);
}

/**
 * Moves a box by steps as the view sees them, metres, along the surface: turning with it, keeping its lift. Where the
 * surface ends the box stays.
 */
export function nudgeOnSurface(
  query: SurfaceQuery,
  pose: DecalPose,
  view: ViewAxes,
  rightMetres: number,
  upMetres: number,
): DecalPose {
  const foot = footOf(query, pose);
  if (foot === null) {
    return pose;
  }
  const start = smoothed(query, foot, pose.size);
  const right = tangentPart(view.right, start.normal).normalize();
  const up = tangentPart(view.up, start.normal).normalize();
  const target = start.position.clone().addScaledVector(right, rightMetres).addScaledVector(up, upMetres);
  const step = Math.hypot(rightMetres, upMetres);
  const landing =
    query.raycast(target.clone().addScaledVector(start.normal, step), start.normal.clone().negate(), step * 3) ??
    query.closest(target);
  // Off the edge of an open sheet the nearest point is the edge itself: no way on.
  if (landing === null || landing.position.distanceTo(start.position) < step * 1e-3) {
    return pose;
  }
  return new DecalSlide(pose, start).step(smoothed(query, landing, pose.size));
}

/** On a floor, up is where the camera's up (or its view, from straight above) runs along it. */
export function levelUp(normal: Vector3, view: ViewAxes): Vector3 {
  return tangentPart(view.up, normal).lengthSq() > 0.01 ? view.up : view.right.clone().cross(normal).negate();
}

/**
 * Twice the deepest drop of the surface below the box's middle plane, with some room; never more than half way to the
 * next surface that would be painted too where nothing occludes.
 */
export function fittingDepth(query: SurfaceQuery, pose: DecalPose): number {
  const forward = axisOf(pose, 2);
  const backward = forward.clone().negate();
  const reach = Math.max(pose.size.x, pose.size.y);
  let drop = 0;
  let behind = Number.POSITIVE_INFINITY;
  for (const [x, y] of gridOf(DEPTH_SAMPLES)) {
    const origin = fromLocal(pose, x * pose.size.x, y * pose.size.y, reach);
    const [first, second] = query.raycastFacing(origin, backward, reach * 6);
    if (first !== undefined) {
      const depth = first.distance - reach;
      // A sample far below is another part of the model, seen past an edge.
      if (Math.abs(depth) < reach * 0.75) drop = Math.max(drop, Math.abs(depth));
      behind = Math.min(behind, depth >= reach * 0.75 ? depth : (second?.distance ?? Number.POSITIVE_INFINITY) - reach);
    }
  }
  const wanted = Math.max(pose.size.z, 2.3 * drop);
  return Math.max(Math.min(wanted, 2 * 0.8 * Math.max(behind, 0)), 2.05 * drop, reach * 0.02);
}

function gridOf(count: number): [number, number][] {
  const steps = Array.from({ length: count }, (_, step) => step / (count - 1) - 0.5);
  return steps.flatMap((y) => steps.map((x): [number, number] => [x, y]));
}
