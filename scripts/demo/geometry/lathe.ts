/** Surfaces of revolution about +Y. The angle runs from +Z (front) towards +X, so columns go right as seen from outside. */

import { type Chart, gridChart } from "./chart.ts";
import type { ProfilePoint } from "./profile.ts";
import type { Vec3 } from "./vector.ts";

const pointAt = (point: ProfilePoint, angle: number): Vec3 => [
  point.x * Math.sin(angle),
  point.y,
  point.x * Math.cos(angle),
];

const normalAt = (point: ProfilePoint, angle: number): Vec3 => [
  point.normal[0] * Math.sin(angle),
  point.normal[1],
  point.normal[0] * Math.cos(angle),
];

export interface BandOptions {
  readonly segments: number;
  /** Where the seam lies, radians from +Z towards +X. */
  readonly seamAngle: number;
  /** The pattern is as wide as the circumference at this radius, metres. */
  readonly patternRadius: number;
}

/** A run of profile turned to a band; the direction of travel points up on the pattern. */
export function latheBand(name: string, run: readonly ProfilePoint[], options: BandOptions): Chart {
  const last = run[run.length - 1] as ProfilePoint;
  return gridChart(name, run.length, options.segments + 1, (row, column) => {
    const point = run[run.length - 1 - row] as ProfilePoint;
    const turn = (2 * Math.PI * column) / options.segments;
    // The last column repeats the first one's angle bit by bit, so the seam has no crack.
    const angle = options.seamAngle + (column === options.segments ? 0 : turn);
    return {
      position: pointAt(point, angle),
      normal: normalAt(point, angle),
      flat: [turn * options.patternRadius, last.length - point.length],
    };
  });
}

/**
 * A run of profile that starts or ends on the axis, turned to a disc. The pattern keeps the distance along the surface from the
 * centre; +X of the model points right on it.
 */
export function latheDisc(name: string, run: readonly ProfilePoint[], segments: number): Chart {
  const startsOnAxis = (run[0] as ProfilePoint).x < 1e-9;
  const outward = startsOnAxis ? run : [...run].reverse();
  const centre = (outward[0] as ProfilePoint).length;
  // Rows run towards the right-hand side of the columns' direction; which radial direction that is depends on the face.
  const faceUp = !startsOnAxis;
  const rows = faceUp ? outward : [...outward].reverse();
  return gridChart(name, rows.length, segments + 1, (row, column) => {
    const point = rows[row] as ProfilePoint;
    const angle = column === segments ? 0 : (2 * Math.PI * column) / segments;
    const distance = Math.abs(point.length - centre);
    const down = faceUp ? 1 : -1;
    return {
      position: pointAt(point, angle),
      normal: normalAt(point, angle),
      flat: [distance * Math.sin(angle), down * distance * Math.cos(angle)],
    };
  });
}
