/**
 * Rotations as people set them: where the decal faces (heading and tilt) and how it is turned about that direction
 * (spin). R = Ry(heading) · Rx(-tilt) · Rz(spin), so a decal on a wall that faces +Z is 0, 0, 0; heading 90 faces +X,
 * tilt 90 faces up, spin turns the picture counter-clockwise as the viewer sees it. All in degrees.
 */
import type { Quaternion } from "../../engine/engine-api.ts";

export interface Orientation {
  /** -180 to 180. */
  readonly heading: number;
  /** -90 to 90. */
  readonly tilt: number;
  /** -180 to 180. */
  readonly spin: number;
}

const RADIANS = Math.PI / 180;

/** Within this of straight up or down, heading and spin turn about one axis: the heading is then kept as it was. */
const POLE_DEGREES = 89.99;

export function wrapDegrees(angle: number): number {
  const wrapped = ((((angle + 180) % 360) + 360) % 360) - 180;
  return wrapped === -180 ? 180 : wrapped;
}

export function quaternionOf({ heading, tilt, spin }: Orientation): Quaternion {
  const [sy, cy] = halfAngle(heading);
  const [sx, cx] = halfAngle(-tilt);
  const [sz, cz] = halfAngle(spin);
  return [
    cy * sx * cz + sy * cx * sz,
    sy * cx * cz - cy * sx * sz,
    cy * cx * sz - sy * sx * cz,
    cy * cx * cz + sy * sx * sz,
  ];
}

/** `hint` gives the heading where the direction alone does not (straight up and down). */
export function orientationOf([x, y, z, w]: Quaternion, hint?: Orientation): Orientation {
  // Rows of the rotation matrix that the order Y·X·Z needs.
  const m02 = 2 * (x * z + w * y);
  const m12 = 2 * (y * z - w * x);
  const m22 = 1 - 2 * (x * x + y * y);
  const tilt = Math.asin(Math.max(-1, Math.min(1, m12))) / RADIANS;
  if (Math.abs(tilt) > POLE_DEGREES) {
    const m00 = 1 - 2 * (y * y + z * z);
    const m20 = 2 * (x * z - w * y);
    const heading = hint?.heading ?? 0;
    const turned = Math.atan2(-m20, m00) / RADIANS;
    return { heading, tilt, spin: wrapDegrees(tilt > 0 ? turned - heading : heading - turned) };
  }
  const m10 = 2 * (x * y + w * z);
  const m11 = 1 - 2 * (x * x + z * z);
  return { heading: Math.atan2(m02, m22) / RADIANS, tilt, spin: Math.atan2(m10, m11) / RADIANS };
}

/** Turns about the decal's own direction, degrees counter-clockwise as the viewer sees it. */
export function spun([x, y, z, w]: Quaternion, degrees: number): Quaternion {
  const [s, c] = halfAngle(degrees);
  return [x * c + y * s, y * c - x * s, z * c + w * s, w * c - z * s];
}

function halfAngle(degrees: number): [number, number] {
  const half = (degrees * RADIANS) / 2;
  return [Math.sin(half), Math.cos(half)];
}
