/**
 * What a decal that slides comes into line with: planes that its middle is brought onto, along the surface. A model has such planes
 * (its middles), and so has each decal that lies beside it: one down its middle, one across.
 */
import type { Vector3 } from "three";
import { nudgeOnSurface } from "./decal-placement.ts";
import { axisOf, type DecalPose, tangentPart } from "./decal-pose.ts";
import type { SurfaceQuery } from "./surface-query.ts";

/** Metres, model space. */
export interface AlignmentPlane {
  readonly point: Vector3;
  /** Unit. */
  readonly normal: Vector3;
  /** The decal whose middle it goes through; null of one of the model's own. */
  readonly of: DecalPose | null;
}

/** Where a plane asks a decal's middle to go. */
export interface AlignmentWay {
  readonly plane: AlignmentPlane;
  /** In the decal's own plane, metres: the shortest way. */
  readonly way: Vector3;
}

/** Cosine: decals that look further apart than this do not lie beside each other. */
const SAME_SIDE = 0.7;
/** Sine of the angle between plane and picture: nearer to each other, the way from one onto the other leads off the decal's place. */
const LEAST_CROSSING = 0.5;
/** Cosine: ways that are more alike than this do not both have room. */
const ALIKE = 0.6;
const STEPS = 8;
/** Of the decal's longer side: as far from a plane as still lies in it, and as near as is sought for. */
const IN_LINE = 1e-3;
const SOUGHT = 1e-6;

/** The two of a decal. */
export function planesOf(other: DecalPose): AlignmentPlane[] {
  return ([0, 1] as const).map((axis) => ({ point: other.position, normal: axisOf(other, axis), of: other }));
}

/** Slid along the surface into the middle of its width: of those planes the one that runs most as its picture's height does. Null as below. */
export function centredOn(query: SurfaceQuery, pose: DecalPose, planes: readonly AlignmentPlane[]): DecalPose | null {
  const right = axisOf(pose, 0);
  const along = (plane: AlignmentPlane): number => Math.abs(plane.normal.dot(right));
  const ways = waysOnto(planes, pose);
  const [nearest] = ways.map(({ plane }) => plane).sort((one, other) => along(other) - along(one));
  return nearest === undefined ? null : broughtOnto(query, pose, [nearest]);
}

/** How far a decal's middle is from a plane, metres, to the side of its normal. */
export function distanceFrom({ point, normal }: AlignmentPlane, { position }: DecalPose): number {
  return normal.dot(position) - normal.dot(point);
}

/** The planes that a decal can be brought onto where it lies, each with the way there. */
export function waysOnto(planes: readonly AlignmentPlane[], pose: DecalPose): AlignmentWay[] {
  const forward = axisOf(pose, 2);
  return planes.flatMap((plane) => {
    const slope = tangentPart(plane.normal, forward);
    const isBeside = plane.of === null || axisOf(plane.of, 2).dot(forward) >= SAME_SIDE;
    if (!isBeside || slope.length() < LEAST_CROSSING) return [];
    return [{ plane, way: slope.multiplyScalar(-distanceFrom(plane, pose) / slope.lengthSq()) }];
  });
}

/** Of planes in the order in which they are wanted the first, and the next one that leaves it in its place. */
export function chosenPlanes(ways: readonly AlignmentWay[], pose: DecalPose): AlignmentPlane[] {
  const forward = axisOf(pose, 2);
  const slopeOf = ({ plane }: AlignmentWay): Vector3 => tangentPart(plane.normal, forward).normalize();
  const [first] = ways;
  if (first === undefined) return [];
  const second = ways.find((way) => Math.abs(slopeOf(way).dot(slopeOf(first))) < ALIKE);
  return second === undefined ? [first.plane] : [first.plane, second.plane];
}

/** The decal slid along the surface onto one plane or two that cross. Null where the surface does not lead there. */
export function broughtOnto(
  query: SurfaceQuery,
  start: DecalPose,
  planes: readonly AlignmentPlane[],
): DecalPose | null {
  const side = Math.max(start.size.x, start.size.y);
  const farthest = (pose: DecalPose): number =>
    Math.max(0, ...planes.map((plane) => Math.abs(distanceFrom(plane, pose))));
  let pose = start;
  // The surface is no plane: each step makes good what the one before missed by that.
  for (let step = 0; step < STEPS && farthest(pose) > SOUGHT * side; step++) {
    const way = wayOnto(planes, pose);
    if (way === null) break;
    const length = way.length();
    const direction = way.divideScalar(length);
    pose = nudgeOnSurface(query, pose, { right: direction, up: axisOf(pose, 2) }, length, 0);
  }
  return farthest(pose) <= IN_LINE * side ? pose : null;
}

/** The planes that a decal lies in, of those that it can be brought onto. */
export function planesThrough(planes: readonly AlignmentPlane[], pose: DecalPose): AlignmentPlane[] {
  const near = IN_LINE * Math.max(pose.size.x, pose.size.y);
  return waysOnto(planes, pose)
    .map(({ plane }) => plane)
    .filter((plane) => Math.abs(distanceFrom(plane, pose)) <= near);
}

/** In the decal's own plane, to where it lies in all of them. */
function wayOnto(planes: readonly AlignmentPlane[], pose: DecalPose): Vector3 | null {
  const forward = axisOf(pose, 2);
  const [first, second] = planes.map((plane) => ({
    slope: tangentPart(plane.normal, forward),
    left: -distanceFrom(plane, pose),
  }));
  if (first === undefined || first.slope.lengthSq() < 1e-6) return null;
  if (second === undefined) return first.slope.multiplyScalar(first.left / first.slope.lengthSq());
  const [aa, ab, bb] = [first.slope.lengthSq(), first.slope.dot(second.slope), second.slope.lengthSq()];
  const area = aa * bb - ab * ab;
  if (area < 1e-6) return null;
  return first.slope
    .multiplyScalar((first.left * bb - second.left * ab) / area)
    .addScaledVector(second.slope, (second.left * aa - first.left * ab) / area);
}
