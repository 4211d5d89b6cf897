/** What the gizmo's handles do to a box: scale about the opposite side or the centre, turn, set the depth. Pure. */
import { Quaternion, Vector3 } from "three";
import { type DecalPose, fromLocal, rollOf, wrapAngle } from "./decal-pose.ts";

/** Which side of the box's rectangle a handle sits on: -1, 0 or 1 along x and y. Corners have both, edges one. */
export interface HandleSide {
  readonly x: -1 | 0 | 1;
  readonly y: -1 | 0 | 1;
}

/** The bounds of any extent of a box, metres. */
export interface SizeLimits {
  readonly least: number;
  readonly most: number;
}

/** The least depth that a drag makes, as a share of the smaller side: on a mug, less cuts the picture to a stripe. */
const LEAST_DEPTH = 0.25;

/**
 * Scales a box by a handle.
 * @param start the pose at the drag's beginning
 * @param travel how far the pointer moved since then in the box's own frame (x, y in metres)
 * @param fromCentre keep the centre in place instead of the opposite corner or edge
 *
 * A corner keeps the box's proportions, depth included; an edge changes its own axis alone. The box does not turn
 * inside out: extents stop at the limits.
 */
export function scaleByHandle(
  start: DecalPose,
  side: HandleSide,
  travel: { readonly x: number; readonly y: number },
  fromCentre: boolean,
  limits: SizeLimits,
): DecalPose {
  const reach = fromCentre ? 2 : 1;
  const size = start.size.clone();
  if (side.x !== 0 && side.y !== 0) {
    // The pointer's travel counts along the diagonal, so that the corner keeps under it as well as the proportions allow.
    const diagonalSquared = size.x ** 2 + size.y ** 2;
    const along = (side.x * travel.x * size.x + side.y * travel.y * size.y) / diagonalSquared;
    size.multiplyScalar(limitFactor(start.size, 1 + reach * along, limits));
  } else if (side.x !== 0) {
    size.x = clamp(size.x + reach * side.x * travel.x, limits);
  } else {
    size.y = clamp(size.y + reach * side.y * travel.y, limits);
  }
  const shift = fromCentre
    ? new Vector3()
    : new Vector3((side.x * (size.x - start.size.x)) / 2, (side.y * (size.y - start.size.y)) / 2, 0);
  return { position: fromLocal(start, shift.x, shift.y, 0), rotation: start.rotation.clone(), size };
}

/**
 * Turns a box about its own +Z.
 * @param turn radians since the drag's beginning, anticlockwise as the box's viewer sees it
 * @param snap radians: the roll against upright goes in steps of this; null for none
 */
export function rotateByHandle(start: DecalPose, turn: number, snap: number | null): DecalPose {
  let applied = turn;
  if (snap !== null) {
    const roll = rollOf(start.rotation);
    applied = Math.round((roll + turn) / snap) * snap - roll;
  }
  const rotation = start.rotation
    .clone()
    .multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), wrapAngle(applied)))
    .normalize();
  return { position: start.position.clone(), rotation, size: start.size.clone() };
}

/**
 * Sets the depth: the +Z face follows the pointer by `travel` metres, the -Z face mirrors it, the centre stays. It stops before
 * the picture is lost; who wants it thinner types a number.
 */
export function deepenByHandle(start: DecalPose, travel: number, limits: SizeLimits): DecalPose {
  const size = start.size.clone();
  const least = Math.min(size.z, Math.max(limits.least, LEAST_DEPTH * Math.min(size.x, size.y)));
  size.z = clamp(size.z + 2 * travel, { ...limits, least });
  return { position: start.position.clone(), rotation: start.rotation.clone(), size };
}

function clamp(value: number, limits: SizeLimits): number {
  return Math.min(limits.most, Math.max(limits.least, value));
}

/** The nearest factor to `factor` that keeps width and height within the limits. */
function limitFactor(size: Vector3, factor: number, limits: SizeLimits): number {
  const least = limits.least / Math.min(size.x, size.y);
  const most = limits.most / Math.max(size.x, size.y);
  return Math.min(Math.max(most, 1e-6), Math.max(least, factor));
}
