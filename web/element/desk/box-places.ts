/** A print zone that is a box, on the surface: its middle, and where it ends. */
import { Vector3 } from "three";
import { type DecalPose, fromLocal, poseOf, toLocal, tupleOf } from "../../viewer/decal-pose.ts";
import type { SurfaceHit, SurfacePlaces } from "../../viewer/viewer-api.ts";
import { type BoxZone, zoneHolds } from "./zone-holds.ts";

type Surface = Pick<SurfacePlaces, "near">;

/** Points along each of the box's four sides. */
const SIDE_POINTS = 24;
/** A point on the box's side itself may be held or not, by rounding. */
const INWARDS = 1e-3;
/** Halvings of the way from the zone's middle to the box's side, where the surface turns away or leaves the box before. */
const HALVINGS = 12;
/** A line along the box's depth has met the surface after a few tangent planes, or never does. */
const TANGENTS = 6;
/** Of the box's longer side: how near to the line that is. */
const NEAR = 2e-3;
/** The cosine of an angle at which the surface stands along the line, and no plane leads on. */
const ALONG = 0.005;

/** Of the box's depth: where its middle line is looked for on the surface. */
const DEPTHS = [0, 0.25, 0.5, -0.25, -0.5];

/** The surface about the box's middle line that the zone holds. Null where it holds none there. */
export function boxMiddle(zone: BoxZone, surface: Surface): SurfaceHit | null {
  const pose = poseOf({ ...zone.shape, kind: "planar" });
  for (const depth of DEPTHS) {
    const hit = surface.near(tupleOf(fromLocal(pose, 0, 0, depth * pose.size.z)));
    if (hit && zoneHolds(zone, hit)) return hit;
  }
  return null;
}

/** By lines from a middle outwards, the last place of each that the zone holds; of the lines that hold any. */
export function boxRim(zone: BoxZone, surface: Surface, middle: SurfaceHit): SurfaceHit[] {
  const pose = poseOf({ ...zone.shape, kind: "planar" });
  const from = toLocal(pose, new Vector3(...middle.position));
  return outline(pose).flatMap(([x, y]) => {
    const heldAt = (share: number): SurfaceHit | null => {
      const hit = onLine(pose, surface, from.x + share * (x - from.x), from.y + share * (y - from.y), from.z);
      return hit && zoneHolds(zone, hit) ? hit : null;
    };
    let last = heldAt(1 - INWARDS);
    if (last) return last;
    let [held, left] = [0, 1];
    for (let halving = 0; halving < HALVINGS; halving++) {
      const share = (held + left) / 2;
      const hit = heldAt(share);
      if (hit) [last, held] = [hit, share];
      else left = share;
    }
    return last ?? [];
  });
}

/** The surface on a line along the box's depth, about as far in as `z`. Null where there is none. */
function onLine(pose: DecalPose, surface: Surface, x: number, y: number, z: number): SurfaceHit | null {
  const near = NEAR * Math.max(pose.size.x, pose.size.y);
  const turn = pose.rotation.clone().invert();
  for (let tangent = 0; tangent < TANGENTS; tangent++) {
    const hit = surface.near(tupleOf(fromLocal(pose, x, y, z)));
    if (hit === null) return null;
    const at = toLocal(pose, new Vector3(...hit.position));
    if (Math.hypot(at.x - x, at.y - y) <= near) return hit;
    const normal = new Vector3(...hit.normal).applyQuaternion(turn);
    if (Math.abs(normal.z) < ALONG) return null;
    z = at.z - (normal.x * (x - at.x) + normal.y * (y - at.y)) / normal.z;
  }
  return null;
}

/** Points all along the box's sides, as its decal sees them. */
function outline({ size }: DecalPose): [number, number][] {
  const shares = Array.from({ length: SIDE_POINTS }, (_, step) => step / SIDE_POINTS - 0.5);
  return shares.flatMap((share): [number, number][] => [
    [share * size.x, -size.y / 2],
    [size.x / 2, share * size.y],
    [-share * size.x, size.y / 2],
    [-size.x / 2, -share * size.y],
  ]);
}
