/** Directions in model space, and the turns that they are the axes of. */
import type { Quaternion, Vec3 } from "../../engine/engine-api.ts";

export const scaled = (a: Vec3, factor: number): Vec3 => [a[0] * factor, a[1] * factor, a[2] * factor];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** Never 0, for what is divided by it. */
export const lengthOf = (a: Vec3): number => Math.sqrt(dot(a, a)) || 1e-9;
export const unit = (a: Vec3): Vec3 => scaled(a, 1 / lengthOf(a));
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** The turn whose axes are the columns, by Shepperd's method. */
export function turnOfAxes(x: Vec3, y: Vec3, z: Vec3): Quaternion {
  const parts = [1 + x[0] + y[1] + z[2], 1 + x[0] - y[1] - z[2], 1 - x[0] + y[1] - z[2], 1 - x[0] - y[1] + z[2]];
  const largest = parts.indexOf(Math.max(...parts));
  const s = 2 * Math.sqrt(parts[largest] as number);
  if (largest === 0) return [(y[2] - z[1]) / s, (z[0] - x[2]) / s, (x[1] - y[0]) / s, s / 4];
  if (largest === 1) return [s / 4, (y[0] + x[1]) / s, (z[0] + x[2]) / s, (y[2] - z[1]) / s];
  if (largest === 2) return [(y[0] + x[1]) / s, s / 4, (z[1] + y[2]) / s, (z[0] - x[2]) / s];
  return [(z[0] + x[2]) / s, (z[1] + y[2]) / s, s / 4, (x[1] - y[0]) / s];
}
