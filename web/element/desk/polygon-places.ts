/**
 * A print zone that is a polygon of the texture, on the surface. How large such a zone is, and how far a place is from its rim, only
 * the surface tells: so the rim is laid onto it, point by point, and distances are those of space.
 */
import { Line3, Vector3 } from "three";
import type { SurfaceHit, SurfacePlaces } from "../../viewer/viewer-api.ts";
import { type PolygonZone, polygonHolds, type Uv, zoneHolds } from "./zone-holds.ts";

type Surface = Pick<SurfacePlaces, "near" | "atUv">;

/** Points along the whole rim, about. */
const RIM_POINTS = 160;
/** Places that are looked at along each side of the polygon's box; even, so that its middle is one of them. */
const GRID = 40;
/** How much a place at the box's side is worth less than one in its middle: of a strip, all along its middle line are as deep. */
const ASIDE = 0.05;
/** A point on the rim itself may lie in the next chart, or wrap to the other side of the texture. */
const INWARDS = 1e-3;
/** Of the way to the box's middle: where the rim lies between charts, steps in which the surface is looked for. */
const STEP_INWARDS = 0.05;
/** The place that is farthest from the zone's rim, by what else it is worth. Null where the zone lies on no surface. */
export function deepestPlace(
  zone: PolygonZone,
  surface: Surface,
  worthOf: (hit: SurfaceHit) => number = () => 1,
): SurfaceHit | null {
  const { polygon } = zone.shape;
  const rim = polygonRim(zone, surface).map(({ position }) => new Vector3(...position));
  const sides = rim.map((to, index) => new Line3(rim.at(index - 1), to));
  const closest = new Vector3();
  const [low, high] = boxOf(polygon);
  let best: SurfaceHit | null = null;
  let most = 0;
  for (let row = 0; row <= GRID; row++) {
    for (let column = 0; column <= GRID; column++) {
      const share: Uv = [column / GRID, row / GRID];
      const uv: Uv = [low[0] + (high[0] - low[0]) * share[0], low[1] + (high[1] - low[1]) * share[1]];
      const hit = polygonHolds(polygon, uv) ? surface.atUv(zone.material, uv) : null;
      if (hit === null) continue;
      const position = new Vector3(...hit.position);
      // A zone that is the whole texture has no rim.
      const depth = sides.reduce(
        (least, side) => Math.min(least, side.closestPointToPoint(position, true, closest).distanceTo(position)),
        Number.MAX_VALUE,
      );
      const worth = (depth * worthOf(hit)) / (1 + ASIDE * Math.hypot(share[0] - 0.5, share[1] - 0.5));
      if (worth > most) {
        most = worth;
        best = hit;
      }
    }
  }
  return best;
}

/** Where the zone ends on the surface. */
export function polygonRim(zone: PolygonZone, surface: Surface): SurfaceHit[] {
  const { polygon } = zone.shape;
  const sides = polygon.map((to, index) => ({ from: polygon.at(index - 1) ?? to, to }));
  const lengthOf = ({ from, to }: { readonly from: Uv; readonly to: Uv }): number =>
    Math.hypot(to[0] - from[0], to[1] - from[1]);
  const whole = sides.reduce((sum, side) => sum + lengthOf(side), 0);
  return sides.flatMap((side) => {
    const count = Math.max(1, Math.ceil((RIM_POINTS * lengthOf(side)) / whole));
    return Array.from({ length: count }, (_, step): Uv => {
      const share = step / count;
      return [mixed(side.from[0], side.to[0], share), mixed(side.from[1], side.to[1], share)];
    }).flatMap((uv) => rimAt(zone, surface, uv) ?? []);
  });
}

/**
 * The surface at a point of the rim, or, where that lies between charts, the end of the chart inwards of it. Null where the zone goes
 * on beyond that end, in another chart, or the surface ends with it.
 */
function rimAt(zone: PolygonZone, surface: Surface, uv: Uv): SurfaceHit | null {
  const [low, high] = boxOf(zone.shape.polygon);
  const inwards = (share: number): SurfaceHit | null =>
    surface.atUv(zone.material, [
      mixed(uv[0], (low[0] + high[0]) / 2, share),
      mixed(uv[1], (low[1] + high[1]) / 2, share),
    ]);
  const own = inwards(INWARDS);
  if (own !== null) return own;
  for (let share = STEP_INWARDS; share < 1; share += STEP_INWARDS) {
    const end = inwards(share);
    const before = end && inwards(share + STEP_INWARDS);
    if (end === null || before === null) continue;
    const onwards = new Vector3(...end.position).multiplyScalar(2).sub(new Vector3(...before.position));
    const beyond = surface.near([onwards.x, onwards.y, onwards.z]);
    return beyond === null || zoneHolds(zone, beyond) ? null : end;
  }
  return null;
}

function boxOf(polygon: readonly Uv[]): readonly [low: Uv, high: Uv] {
  const [us, vs] = [polygon.map(([u]) => u), polygon.map(([, v]) => v)];
  return [
    [Math.min(...us), Math.min(...vs)],
    [Math.max(...us), Math.max(...vs)],
  ];
}

const mixed = (from: number, to: number, share: number): number => from + (to - from) * share;
