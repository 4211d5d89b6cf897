/**
 * What a flat stamp comes into line with in its texture: the edges and middles of the texture, of the chart that it lies on, and
 * of other stamps. An edge comes to an edge, a middle to a middle. Pure.
 */
import type { UvProjector } from "../engine/engine-api.ts";
import { stampBounds, type Uv } from "./stamp-drag.ts";
import type { UvBounds } from "./uv-charts.ts";

/** A line in the texture, from one place to another. */
export type UvLine = readonly [Uv, Uv];

const WHOLE: UvBounds = { low: [0, 0], high: [1, 1] };
/** Of the texture: nearer than rounding brings them, two lines are one. */
const SAME = 1e-9;

/**
 * @param chart round the chart under its middle; null where there is none
 * @param reach how far it may go to come into line, in u and in v
 * @returns the stamp there, and the lines that it lies in then; itself and none where nothing is near
 */
export function stampInLine(
  stamp: UvProjector,
  others: readonly UvProjector[],
  chart: UvBounds | null,
  reach: Uv,
): { readonly stamp: UvProjector; readonly lines: readonly UvLine[] } {
  const beside = [WHOLE, ...(chart ? [chart] : []), ...others.map((other) => stampBounds([other]))];
  const own = stampBounds([stamp]);
  const ways = ([0, 1] as const).map((axis) => wayInto(own, beside, axis, reach[axis]));
  const [right, down] = [ways[0] ?? 0, ways[1] ?? 0];
  const center: Uv = [stamp.center[0] + right, stamp.center[1] + down];
  const moved = { ...stamp, center };
  const now = stampBounds([moved]);
  const lines = ([0, 1] as const).flatMap((axis) => (ways[axis] === null ? [] : linesThrough(now, beside, axis)));
  return { stamp: ways.every((way) => way === null) ? stamp : moved, lines };
}

/** The shortest way along an axis onto a line of one of the others; null where none is within reach. */
function wayInto(own: UvBounds, others: readonly UvBounds[], axis: 0 | 1, reach: number): number | null {
  let shortest: number | null = null;
  for (const other of others) {
    for (const [from, to] of pairsOf(own, other, axis)) {
      const way = to - from;
      if (Math.abs(way) <= reach && Math.abs(way) < Math.abs(shortest ?? Number.POSITIVE_INFINITY)) shortest = way;
    }
  }
  return shortest;
}

/** The lines across an axis that are shared with others, each as long as both reach. */
function linesThrough(own: UvBounds, others: readonly UvBounds[], axis: 0 | 1): UvLine[] {
  const across = axis === 0 ? 1 : 0;
  const found = new Map<number, [number, number]>();
  for (const other of others) {
    for (const [from, to] of pairsOf(own, other, axis)) {
      if (Math.abs(to - from) > SAME) continue;
      const known = [...found.keys()].find((at) => Math.abs(at - to) <= SAME) ?? to;
      const [low, high] = found.get(known) ?? [own.low[across], own.high[across]];
      found.set(known, [Math.min(low, other.low[across]), Math.max(high, other.high[across])]);
    }
  }
  const at = (along: number, place: number): Uv => (axis === 0 ? [place, along] : [along, place]);
  return [...found].map(([place, [low, high]]) => [at(low, place), at(high, place)]);
}

/** Middle with middle, each edge with each edge. */
function pairsOf(own: UvBounds, other: UvBounds, axis: 0 | 1): (readonly [number, number])[] {
  const edges = (of: UvBounds): readonly number[] => [of.low[axis], of.high[axis]];
  const middle = (of: UvBounds): number => (of.low[axis] + of.high[axis]) / 2;
  return [[middle(own), middle(other)], ...edges(own).flatMap((from) => edges(other).map((to) => [from, to] as const))];
}
