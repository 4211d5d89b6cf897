/**
 * A decal's box as three.js mathematics: where it is, what lies in it, and which way up it stands. No DOM, no scene.
 * Decal space and the meaning of `PlanarProjector` are spec.md, sections 1 and 3.
 */
import { Matrix4, Quaternion, Vector3 } from "three";
import type { PlanarProjector, Vec3 } from "../engine/engine-api.ts";

/** A planar projector in three's own types; `size` are full extents in metres, `rotation` is unit. */
export interface DecalPose {
  readonly position: Vector3;
  readonly rotation: Quaternion;
  readonly size: Vector3;
}

/** A place on the surface: metres, model space; the normal is unit. */
export interface SurfacePoint {
  readonly position: Vector3;
  readonly normal: Vector3;
}

/** Up, wherever the model does not say otherwise (glTF: +Y). */
export const UP_MODEL: Readonly<Vector3> = new Vector3(0, 1, 0);

export function poseOf(projector: PlanarProjector): DecalPose {
  return {
    position: new Vector3(...projector.position),
    rotation: new Quaternion(...projector.rotation).normalize(),
    size: new Vector3(...projector.size),
  };
}

export function projectorOf(pose: DecalPose): PlanarProjector {
  const rotation = pose.rotation.clone().normalize();
  return {
    kind: "planar",
    position: tupleOf(pose.position),
    rotation: [rotation.x, rotation.y, rotation.z, rotation.w],
    size: tupleOf(pose.size),
  };
}

export function tupleOf(vector: Vector3): Vec3 {
  return [vector.x, vector.y, vector.z];
}

/** The box's axis in model space, unit: 0 is +X (picture's right), 1 is +Y (its top), 2 is +Z (towards the viewer). */
export function axisOf(pose: DecalPose, axis: 0 | 1 | 2): Vector3 {
  return new Vector3().setComponent(axis, 1).applyQuaternion(pose.rotation);
}

/** A point of the box's own metric frame (metres from its centre along its axes) in model space. */
export function fromLocal(pose: DecalPose, x: number, y: number, z: number): Vector3 {
  return new Vector3(x, y, z).applyQuaternion(pose.rotation).add(pose.position);
}

/** Model space to the box's own metric frame: metres from its centre along its axes. */
export function toLocal(pose: DecalPose, point: Vector3): Vector3 {
  return point.clone().sub(pose.position).applyQuaternion(pose.rotation.clone().invert());
}

/** Spec.md, section 4, test 1 on the point itself: inside the box, its faces included. */
export function containsPoint(pose: DecalPose, point: Vector3): boolean {
  const local = toLocal(pose, point);
  return (
    Math.abs(local.x) <= pose.size.x / 2 && Math.abs(local.y) <= pose.size.y / 2 && Math.abs(local.z) <= pose.size.z / 2
  );
}

/** Spec.md, section 4, test 2: the surface looks towards the projector. */
export function facesNormal(pose: DecalPose, normal: Vector3): boolean {
  return axisOf(pose, 2).dot(normal) > 0;
}

/** The shortest turn that takes `from` to `to` (both unit). Opposite directions turn about the vertical where they can. */
export function minimalRotation(from: Vector3, to: Vector3): Quaternion {
  if (from.dot(to) > -0.999999) {
    return new Quaternion().setFromUnitVectors(from, to);
  }
  const axis = tangentPart(UP_MODEL, from);
  const safeAxis = axis.lengthSq() > 1e-6 ? axis.normalize() : new Vector3(1, 0, 0);
  return new Quaternion().setFromAxisAngle(safeAxis, Math.PI);
}

/**
 * The frame that stands upright on a surface: +Z is the normal, +Y as near to `up` as the surface lets it.
 * Null where the normal is (almost) parallel to `up`, since every direction is as upright as any other there.
 */
export function uprightFrame(normal: Vector3, up: Readonly<Vector3> = UP_MODEL): Quaternion | null {
  const y = tangentPart(up, normal);
  if (y.lengthSq() < 1e-8) {
    return null;
  }
  y.normalize();
  const x = new Vector3().crossVectors(y, normal).normalize();
  return new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(x, y, normal));
}

/** How much "upright" means on this surface: 1 on a wall, 0 on a floor (the sine of the angle between normal and up). */
export function uprightness(normal: Vector3): number {
  return Math.sqrt(Math.max(0, 1 - normal.dot(UP_MODEL) ** 2));
}

/**
 * Turn of the box about its own +Z away from upright, radians in (-pi, pi], anticlockwise as its viewer sees it.
 * On floors and ceilings it is measured from the picture's top pointing to -Z (floor) or +Z (ceiling).
 */
export function rollOf(rotation: Quaternion): number {
  const z = new Vector3(0, 0, 1).applyQuaternion(rotation);
  const upright = uprightFrame(z, UP_MODEL) ?? uprightFrame(z, new Vector3(0, 0, -Math.sign(z.y) || -1));
  if (upright === null) {
    return 0;
  }
  const relative = upright.invert().multiply(rotation);
  return wrapAngle(2 * Math.atan2(relative.z, relative.w));
}

/** Into (-pi, pi]. */
export function wrapAngle(angle: number): number {
  const turn = 2 * Math.PI;
  const wrapped = angle - turn * Math.floor(angle / turn);
  return wrapped > Math.PI ? wrapped - turn : wrapped;
}

/** The part of `vector` that lies in the plane of `normal` (unit). */
export function tangentPart(vector: Readonly<Vector3>, normal: Vector3): Vector3 {
  return new Vector3().copy(vector).addScaledVector(normal, -normal.dot(vector as Vector3));
}

/** The box's eight corners, x fastest, then y, then z; each from low to high. */
export function boxCorners(pose: DecalPose): Vector3[] {
  const corners: Vector3[] = [];
  for (const z of [-0.5, 0.5]) {
    for (const y of [-0.5, 0.5]) {
      for (const x of [-0.5, 0.5]) {
        corners.push(fromLocal(pose, x * pose.size.x, y * pose.size.y, z * pose.size.z));
      }
    }
  }
  return corners;
}
