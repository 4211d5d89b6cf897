/** Turns a projector where it lies: to the surface's direction, upright, to the camera. Its place and size stay. */
import { Matrix4, Quaternion, Vector3 } from "three";
import type {
  CylindricalProjector,
  PerspectiveProjector,
  PlanarProjector,
  Projector,
  UvProjector,
} from "../engine/engine-api.ts";
import { fittingDepth, footOf, levelUp, smoothed, smoothedNear } from "./decal-placement.ts";
import {
  poseOf,
  projectorOf,
  rollOf,
  tangentPart,
  tupleOf,
  UP_MODEL,
  uprightFrame,
  uprightness,
} from "./decal-pose.ts";
import { type PicturePlace, stampAt } from "./picture-place.ts";
import { rotationOf } from "./projector-sight.ts";
import { wrapAround } from "./projector-wrap.ts";
import type { SurfaceQuery } from "./surface-query.ts";

export type Alignment = "surface" | "upright" | "view";

/** Where the camera is and which way it is held, model space. */
export interface ViewPoint {
  readonly eye: Vector3;
  readonly right: Vector3;
  readonly up: Vector3;
}

/** Below this (sine of the angle to vertical) a surface is a floor, on which the camera says which way up is. */
const FLOOR = 0.35;

/**
 * - surface: a box looks straight at the surface under its middle; an eye stands before it; a label's cylinder is fitted
 *   to it anew. A flat stamp has no direction of its own.
 * - upright: the picture's top points up the model as far as the surface lets it; on floors, up the view.
 * - view: a box faces the camera; an eye keeps its place and stands as the camera is held; a label turns its middle to
 *   the camera; a stamp's top points up the view.
 *
 * @param place where its picture lies; null where it meets no surface
 * @returns the projector itself where there is nothing to align to
 */
export function aligned(
  query: SurfaceQuery,
  projector: Projector,
  how: Alignment,
  view: ViewPoint,
  place: PicturePlace | null,
): Projector {
  if (projector.kind === "planar") return alignedBox(query, projector, how, view);
  if (place === null) return projector;
  if (projector.kind === "perspective") return alignedEye(query, projector, how, view, place);
  if (projector.kind === "cylindrical") return alignedLabel(query, projector, how, view, place);
  return alignedStamp(query, projector, how, view, place);
}

/** Which way is up for a picture that looks along `normal`. */
function upFor(normal: Vector3, view: ViewPoint): Vector3 {
  return uprightness(normal) > FLOOR ? new Vector3().copy(UP_MODEL) : levelUp(normal, view);
}

function alignedBox(query: SurfaceQuery, projector: PlanarProjector, how: Alignment, view: ViewPoint): Projector {
  const pose = poseOf(projector);
  if (how === "upright") {
    const forward = new Vector3(0, 0, 1).applyQuaternion(pose.rotation);
    return projectorOf({ ...pose, rotation: uprightFrame(forward, upFor(forward, view)) ?? pose.rotation });
  }
  if (how === "surface") {
    const foot = footOf(query, pose);
    if (foot === null) return projector;
    const { normal } = smoothed(query, foot, pose.size);
    const roll = new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), rollOf(pose.rotation));
    const rotation = (uprightFrame(normal, upFor(normal, view)) ?? pose.rotation.clone()).multiply(roll);
    const turned = { ...pose, position: foot.position.clone(), rotation };
    return projectorOf({ ...turned, size: deepEnough(query, turned) });
  }
  const towards = view.eye.clone().sub(pose.position).normalize();
  const turned = { ...pose, rotation: uprightFrame(towards, view.up) ?? pose.rotation };
  return projectorOf({ ...turned, size: deepEnough(query, turned) });
}

/** A box that now stands askew on the surface may have to reach deeper; never less deep than it was. */
function deepEnough(query: SurfaceQuery, pose: ReturnType<typeof poseOf>): Vector3 {
  return pose.size.clone().setZ(Math.max(pose.size.z, fittingDepth(query, pose)));
}

function alignedEye(
  query: SurfaceQuery,
  projector: PerspectiveProjector,
  how: Alignment,
  view: ViewPoint,
  place: PicturePlace,
): Projector {
  const eye = new Vector3(...projector.position);
  const distance = eye.distanceTo(place.position);
  if (how === "surface") {
    const size = new Vector3(place.right.length(), place.up.length(), 0);
    const { normal } = smoothedNear(query, place, size);
    const moved = place.position.clone().addScaledVector(normal, distance);
    const y = new Vector3(0, 1, 0).applyQuaternion(rotationOf(projector));
    const up = tangentPart(y, normal).lengthSq() > 0.05 ? y : upFor(normal, view);
    const rotation = uprightFrame(normal, up);
    return rotation === null ? projector : { ...projector, position: tupleOf(moved), rotation: fourOf(rotation) };
  }
  const backward = new Vector3(0, 0, 1).applyQuaternion(rotationOf(projector));
  const rotation = uprightFrame(backward, how === "view" ? view.up : upFor(backward, view));
  return rotation === null ? projector : { ...projector, rotation: fourOf(rotation) };
}

function alignedLabel(
  query: SurfaceQuery,
  projector: CylindricalProjector,
  how: Alignment,
  view: ViewPoint,
  place: PicturePlace,
): Projector {
  const position = new Vector3(...projector.position);
  if (how === "surface") {
    const fitted = wrapAround(query, place);
    return fitted === null ? projector : { ...fitted, height: projector.height };
  }
  const rotation = rotationOf(projector);
  const outward = new Vector3(0, 0, 1).applyQuaternion(rotation);
  if (how === "view") {
    const axis = new Vector3(0, 1, 0).applyQuaternion(rotation);
    const towards = tangentPart(view.eye.clone().sub(position), axis);
    if (towards.lengthSq() < 1e-18) return projector;
    return { ...projector, rotation: fourOf(frameOf(axis, towards.normalize())) };
  }
  // The axis stands up; the middle keeps its direction as far as that lets it.
  const level = tangentPart(outward, new Vector3().copy(UP_MODEL));
  if (level.lengthSq() < 1e-6) return projector;
  return { ...projector, rotation: fourOf(frameOf(new Vector3().copy(UP_MODEL), level.normalize())) };
}

function alignedStamp(
  query: SurfaceQuery,
  projector: UvProjector,
  how: Alignment,
  view: ViewPoint,
  place: PicturePlace,
): Projector {
  if (how === "surface") return projector;
  const up = tangentPart(how === "view" ? view.up : upFor(place.normal, view), place.normal);
  if (up.lengthSq() < 1e-8) return projector;
  up.normalize();
  const right = new Vector3().crossVectors(up, place.normal);
  const turned = stampAt(query, {
    ...place,
    right: right.multiplyScalar(place.right.length()),
    up: up.multiplyScalar(place.up.length()),
  });
  return turned === null ? projector : { ...projector, angle: turned.angle };
}

/** The rotation whose +Y and +Z these are; both unit and at right angles. */
function frameOf(y: Vector3, z: Vector3): Quaternion {
  return new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(new Vector3().crossVectors(y, z), y, z));
}

function fourOf({ x, y, z, w }: Quaternion): [number, number, number, number] {
  return [x, y, z, w];
}
