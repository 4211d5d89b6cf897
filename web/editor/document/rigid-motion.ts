/** Places and rotations in model space: what is carried along with a projector, or shown by a mirror. */
import type { Quaternion, Vec3 } from "./design.ts";

export const plus = ([a, b, c]: Vec3, [x, y, z]: Vec3): Vec3 => [a + x, b + y, c + z];
export const minus = ([a, b, c]: Vec3, [x, y, z]: Vec3): Vec3 => [a - x, b - y, c - z];
export const inverse = ([x, y, z, w]: Quaternion): Quaternion => [-x, -y, -z, w];

/** First `b`, then `a`. */
export const product = ([ax, ay, az, aw]: Quaternion, [bx, by, bz, bw]: Quaternion): Quaternion => [
  aw * bx + ax * bw + ay * bz - az * by,
  aw * by - ax * bz + ay * bw + az * bx,
  aw * bz + ax * by - ay * bx + az * bw,
  aw * bw - ax * bx - ay * by - az * bz,
];

export function turned([x, y, z, w]: Quaternion, [a, b, c]: Vec3): Vec3 {
  const [i, j, k] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * i + y * k - z * j, b + w * j + z * i - x * k, c + w * k + x * j - y * i];
}

interface Pose {
  readonly position: Vec3;
  readonly rotation: Quaternion;
}

/** `other` as one body with what stood at `start` and stands at `now`. */
export function carriedPose({ position, rotation }: Pose, now: Pose, other: Pose): Pose {
  const turn = product(now.rotation, inverse(rotation));
  return {
    position: plus(now.position, turned(turn, minus(other.position, position))),
    rotation: product(turn, other.rotation),
  };
}
