/** A decal's rectangle laid over the surface: the line that shows where the picture is painted. */
import type { Vector3 } from "three";
import { axisOf, type DecalPose, fromLocal } from "./decal-pose.ts";
import type { SurfaceQuery } from "./surface-query.ts";

/** One point of the outline. */
export interface OutlinePoint {
  /** Model space, slightly above the surface. */
  readonly position: Vector3;
  /** Height over the box's middle plane, metres. */
  readonly height: number;
  /** False where the box catches no surface: the line bridges a gap there. */
  readonly onSurface: boolean;
}

/** Points along one edge; the outline has four times as many and closes on itself. */
export const POINTS_PER_EDGE = 20;
/** The same of a decal that slides: its line is drawn anew in each frame, and every point of it casts rays. */
export const POINTS_PER_EDGE_SLIDING = 10;

/** From the bottom left corner anticlockwise as the picture's viewer sees it; corners at multiples of `pointsPerEdge`. */
export function drapeOutline(query: SurfaceQuery, pose: DecalPose, pointsPerEdge = POINTS_PER_EDGE): OutlinePoint[] {
  const backward = axisOf(pose, 2).negate();
  const border = rectangleBorder(pointsPerEdge);
  const heights = border.map(([x, y]) => {
    const origin = fromLocal(pose, x * pose.size.x, y * pose.size.y, pose.size.z / 2);
    const depth = query.distanceAlong(origin, backward, pose.size.z);
    return depth === null ? null : pose.size.z / 2 - depth;
  });
  const filled = bridgeGaps(heights);
  const lift = 0.004 * Math.max(pose.size.x, pose.size.y);
  return border.map(([x, y], point) => {
    const height = filled[point] as number;
    return {
      position: fromLocal(pose, x * pose.size.x, y * pose.size.y, height + lift),
      height,
      onSurface: heights[point] !== null,
    };
  });
}

/** Fills what is missing in a closed line by straight bridges; 0 throughout where all of it is missing. */
export function bridgeGaps(heights: readonly (number | null)[]): number[] {
  const count = heights.length;
  const first = heights.findIndex((height) => height !== null);
  if (first < 0) {
    return heights.map(() => 0);
  }
  const filled = heights.map((height) => height ?? 0);
  let before = first;
  for (let step = 1; step <= count; step++) {
    const point = (first + step) % count;
    if (heights[point] !== null) {
      const span = step + first - before;
      for (let gap = 1; gap < span; gap++) {
        const from = heights[before % count] as number;
        filled[(before + gap) % count] = from + ((heights[point] as number) - from) * (gap / span);
      }
      before = first + step;
    }
  }
  return filled;
}

/** Decal space, x and y, in the outline's order. */
export function rectangleBorder(pointsPerEdge: number): [number, number][] {
  const corners = [
    [-0.5, -0.5],
    [0.5, -0.5],
    [0.5, 0.5],
    [-0.5, 0.5],
  ] as const;
  return corners.flatMap(([x, y], corner) => {
    const [nextX, nextY] = corners[(corner + 1) % 4] as readonly [number, number];
    return Array.from({ length: pointsPerEdge }, (_, step): [number, number] => {
      const share = step / pointsPerEdge;
      return [x + (nextX - x) * share, y + (nextY - y) * share];
    });
  });
}
