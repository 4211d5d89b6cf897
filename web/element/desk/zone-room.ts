/** Room for something new in a print zone: where it lies wholly inside, and how wide it may be there. */
import { Vector3 } from "three";
import type { PlanarProjector } from "../../engine/engine-api.ts";
import type { PrintZone } from "../../engine/print-zones.ts";
import { poseOf, toLocal } from "../../viewer/decal-pose.ts";
import { reachesPoint } from "../../viewer/projector-sight.ts";
import type { DecalViewer, SurfaceHit, SurfacePlaces, Vec3 } from "../../viewer/viewer-api.ts";
import { boxRim } from "./box-places.ts";
import { polygonRim } from "./polygon-places.ts";
import { type BoxZone, isPolygon, type Uv, zoneHolds } from "./zone-holds.ts";

export { boxMiddle } from "./box-places.ts";
export { deepestPlace } from "./polygon-places.ts";

type Surface = Pick<SurfacePlaces, "near" | "atUv">;

/** A place, and how wide something may be that lies there. */
export interface RoomyPlace {
  readonly hit: SurfaceHit;
  /** Metres. */
  readonly width: number;
}

/** Of the way from where the customer looks to the zone's deepest place: the first at which something fits is its place. */
const WAY = [0.25, 0.5, 0.75];
/** What is less larger than this is no reason to go farther from where the customer looks. */
const GAIN = 1.1;
/** A width that is shrunk until it fits has come there after a few rounds: the picture turns a little as it shrinks. */
const ROUNDS = 8;
/** So that what touched the rim does not touch it again. */
const INWARDS = 1e-3;

/**
 * Where something of an aspect (width by height) lies wholly inside the zone, so wide (metres) where it can be, else as wide as it
 * can be: as near as about that can be had to the place of the zone that the customer looks at (`seen`).
 *
 * @param deepest of the zone: where there is most room
 */
export function roomIn(
  viewer: Pick<DecalViewer, "projectorAt"> & { readonly surface: Surface },
  zone: PrintZone,
  aspect: number,
  most: number,
  seen: SurfaceHit | null,
  deepest: SurfaceHit,
): RoomyPlace {
  const { surface } = viewer;
  const rim = isPolygon(zone) ? polygonRim(zone, surface) : boxRim(zone as BoxZone, surface, deepest);
  const roomAt = (hit: SurfaceHit): RoomyPlace => {
    return { hit, width: widthInside((width) => viewer.projectorAt(hit, width, aspect), most, rim) };
  };
  const between = (from: SurfaceHit): (SurfaceHit | null)[] =>
    WAY.map((share) => {
      const hit = isPolygon(zone)
        ? surface.atUv(zone.material, mixed(from.uv, deepest.uv, share))
        : surface.near(mixed(from.position, deepest.position, share));
      return hit && zoneHolds(zone, hit) ? hit : null;
    });
  let best: RoomyPlace | null = null;
  for (const hit of seen ? [seen, ...between(seen), deepest] : [deepest]) {
    const place = hit && roomAt(hit);
    if (place && place.width > GAIN * (best?.width ?? 0)) best = place;
    if (best?.width === most) return best;
  }
  // Where the rim could not be told from the place itself, the picture is there nevertheless.
  return best ?? { hit: deepest, width: most };
}

/** The largest width, up to the most, at which no point of the rim is reached. */
function widthInside(
  projectorOf: (width: number) => PlanarProjector,
  most: number,
  rim: readonly SurfaceHit[],
): number {
  let width = most;
  for (let round = 0; round < ROUNDS && width > 0; round++) {
    const projector = projectorOf(width);
    const pose = poseOf(projector);
    const share = rim.reduce((least, { position, normal, uv }) => {
      const point = { position: new Vector3(...position), normal: new Vector3(...normal), uv };
      if (!reachesPoint(projector, point)) return least;
      const { x, y } = toLocal(pose, point.position);
      return Math.min(least, 2 * Math.max(Math.abs(x) / pose.size.x, Math.abs(y) / pose.size.y));
    }, 1);
    if (share === 1) break;
    width *= share * (1 - INWARDS);
  }
  return width;
}

const mixed = <Place extends Vec3 | Uv>(from: Place, to: Place, share: number): Place =>
  from.map((each, axis) => each + ((to[axis] as number) - each) * share) as unknown as Place;
