/**
 * A box with rounded edges and corners: a sphere of the bevel's radius swept over a smaller box. Its pattern is a band
 * around the four sides (seam at the middle of the back) and a cap each for top and bottom; band and caps meet half
 * way round the bevel, where the surface has turned by 45 degrees.
 */

import { type Chart, type ChartVertex, fromVertices, gridChart, joinCharts } from "./chart.ts";
import type { Vec3 } from "./vector.ts";

export interface BevelledBoxOptions {
  readonly name: string;
  /** Full extents, metres. */
  readonly size: Vec3;
  readonly bevel: number;
  /** Pieces of each quarter turn; even. */
  readonly steps?: number;
  /** Further rings at these heights from the centre, metres: where the box is to bend. */
  readonly rings?: readonly number[];
}

interface OutlinePoint {
  /** Centre of the corner's sphere, before height. */
  readonly x: number;
  readonly z: number;
  /** Direction from it, radians from +Z towards +X. */
  readonly angle: number;
  /** Distance along the outline, metres. */
  readonly travelled: number;
}

/** Band, top and bottom, around the origin. */
export function bevelledBox(options: BevelledBoxOptions): Chart[] {
  const { name, size, bevel } = options;
  const steps = options.steps ?? 6;
  const half: Vec3 = [size[0] / 2 - bevel, size[1] / 2 - bevel, size[2] / 2 - bevel];
  if (half.some((extent) => extent < 0)) throw new RangeError(`bevelledBox ${name}: the bevel is wider than the box`);
  const outline = boxOutline(half, bevel, steps);
  return [
    band(name, half, bevel, steps, outline, options.rings ?? []),
    cap(`${name} top`, half, bevel, steps, outline, 1),
    cap(`${name} bottom`, half, bevel, steps, outline, -1),
  ];
}

function boxOutline(half: Vec3, bevel: number, steps: number): OutlinePoint[] {
  const [hx, , hz] = half;
  const quarter = Math.PI / 2;
  const points: OutlinePoint[] = [{ x: 0, z: -hz, angle: -Math.PI, travelled: 0 }];
  const corners = [
    { x: -hx, z: -hz, from: -2, straight: hx },
    { x: -hx, z: hz, from: -1, straight: 2 * hz },
    { x: hx, z: hz, from: 0, straight: 2 * hx },
    { x: hx, z: -hz, from: 1, straight: 2 * hz },
  ];
  let travelled = 0;
  for (const corner of corners) {
    travelled += corner.straight;
    for (let step = 0; step <= steps; step++) {
      const angle = quarter * (corner.from + step / steps);
      points.push({ x: corner.x, z: corner.z, angle, travelled: travelled + (bevel * quarter * step) / steps });
    }
    travelled += bevel * quarter;
  }
  // The seam's second side repeats the first one's angle, so both have the same bits.
  points.push({ x: 0, z: -hz, angle: -Math.PI, travelled: travelled + hx });
  return points;
}

function onSphere(point: OutlinePoint, height: number, elevation: number, bevel: number): [Vec3, Vec3] {
  const flat = Math.cos(elevation);
  const normal: Vec3 = [Math.sin(point.angle) * flat, Math.sin(elevation), Math.cos(point.angle) * flat];
  return [[point.x + normal[0] * bevel, height + normal[1] * bevel, point.z + normal[2] * bevel], normal];
}

function band(
  name: string,
  half: Vec3,
  bevel: number,
  steps: number,
  outline: readonly OutlinePoint[],
  rings: readonly number[],
): Chart {
  const rows: { height: number; elevation: number; down: number }[] = [];
  const eighth = Math.PI / 4;
  const arc = bevel * eighth;
  for (let step = 0; step <= steps / 2; step++) {
    const share = (2 * step) / steps;
    rows.push({ height: half[1], elevation: eighth * (1 - share), down: arc * share });
  }
  for (const ring of [...rings].sort((a, b) => b - a)) {
    if (Math.abs(ring) < half[1] - 1e-6) rows.push({ height: ring, elevation: 0, down: arc + half[1] - ring });
  }
  for (let step = 0; step <= steps / 2; step++) {
    const share = (2 * step) / steps;
    rows.push({ height: -half[1], elevation: -eighth * share, down: arc + 2 * half[1] + arc * share });
  }
  return gridChart(name, rows.length, outline.length, (row, column) => {
    const { height, elevation, down } = rows[row] as (typeof rows)[number];
    const point = outline[column] as OutlinePoint;
    const [position, normal] = onSphere(point, height, elevation, bevel);
    return { position, normal, flat: [point.travelled, down] };
  });
}

function cap(
  name: string,
  half: Vec3,
  bevel: number,
  steps: number,
  outline: readonly OutlinePoint[],
  side: 1 | -1,
): Chart {
  const vertexAt = (point: OutlinePoint, turned: number): ChartVertex => {
    const elevation = (Math.PI / 2) * (1 - turned);
    const [position, normal] = onSphere(point, side * half[1], side * elevation, bevel);
    const arc = bevel * (Math.PI / 2) * turned;
    return {
      position,
      normal,
      flat: [point.x + arc * Math.sin(point.angle), side * (point.z + arc * Math.cos(point.angle))],
    };
  };
  // Rows go outward on the top and inward at the bottom: the pattern's mirror image there keeps triangles outward.
  const rows = Array.from({ length: steps / 2 + 1 }, (_, step) => step / steps);
  if (side < 0) rows.reverse();
  const ring = gridChart(name, rows.length, outline.length, (row, column) =>
    vertexAt(outline[column] as OutlinePoint, rows[row] as number),
  );
  const corners = [0, 1, 2, 3].map((corner) => outline[1 + corner * (steps + 1)] as OutlinePoint);
  const flatVertices = [outline[0] as OutlinePoint, ...corners].map((point) => vertexAt(point, 0));
  const fan = [1, 2, 3].map((corner) => [0, corner, corner + 1] as const);
  const middle = fromVertices(name, flatVertices, side > 0 ? fan : fan.map(([a, b, c]) => [a, c, b] as const));
  return joinCharts(name, [ring, middle]);
}
