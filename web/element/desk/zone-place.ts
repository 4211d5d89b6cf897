/** Where something new goes on a product that is printed in some places only. */
import { Vector3 } from "three";
import type { PrintZone } from "../../engine/print-zones.ts";
import type { DecalViewer, SurfaceHit } from "../../viewer/viewer-api.ts";
import { type BoxZone, isPolygon, zoneHolds } from "./zone-holds.ts";

/** Of a zone, or of the largest that fits in it: what something new takes at the most, so that it has room to be moved. */
const MOST_OF_ZONE = 0.8;
/** What a place is worth that the camera does not see: another one is taken where it may be had. */
const UNSEEN = 0.01;
/** The cosine of an angle at which a picture is seen as well as from straight before it, nearly. */
const WELL_SEEN = 0.7;

export interface StartingPlace {
  readonly hit: SurfaceHit;
  /** Metres. */
  readonly width: number;
}

/** Something new. */
export interface Newcomer {
  /** Width by height. */
  readonly aspect: number;
  /** Metres; how wide it is where nothing is against it. */
  readonly usual: number;
}

/**
 * Without zones where the view has room for it. Else the surface under the middle of the view where that may be printed, or the
 * middle of the nearest zone, one that the camera sees before one that it does not. In a zone it goes from there as far as it
 * must to lie wholly inside. Null without a surface.
 */
export async function startingPlace(
  viewer: Pick<DecalViewer, "surface" | "surfaceAtCentre" | "projectorAt" | "landing">,
  zones: readonly PrintZone[],
  { aspect, usual }: Newcomer,
): Promise<StartingPlace | null> {
  const { surface } = viewer;
  // Where it does not come, something new goes where the customer looks.
  const rooms = zones.length > 0 ? await import("./zone-room.ts").catch(() => null) : null;
  const middleOf = (zone: PrintZone): SurfaceHit | null => {
    if (isPolygon(zone)) {
      return rooms?.deepestPlace(zone, surface, (hit) => inSight(facing(hit, surface))) ?? null;
    }
    const box = zone as BoxZone;
    const hit = rooms?.boxMiddle(box, surface) ?? surface.near(box.shape.position);
    return hit?.material === zone.material ? hit : null;
  };
  const placeIn = (zone: PrintZone, seen: SurfaceHit | null, middle: SurfaceHit): StartingPlace => {
    const room = rooms?.roomIn(viewer, zone, aspect, usual / MOST_OF_ZONE, seen, middle);
    const { hit, width } = room ?? { hit: seen ?? middle, width: Number.POSITIVE_INFINITY };
    return { hit, width: Math.min(usual, MOST_OF_ZONE * width, widthInBox(zone, aspect)) };
  };
  // Where what weighs the places does not come, it is the middle.
  const landing = zones.length === 0 && (await Promise.resolve(viewer.landing(usual, aspect)).catch(() => null));
  if (landing) return landing;
  const seen = viewer.surfaceAtCentre();
  const under = seen && zones.find((zone) => zoneHolds(zone, seen));
  if (under) return placeIn(under, seen, middleOf(under) ?? seen);
  const middles = zones.flatMap((zone) => {
    const hit = middleOf(zone);
    if (hit === null) return [];
    const position = new Vector3(...hit.position);
    const distance = seen ? position.distanceTo(new Vector3(...seen.position)) : 0;
    return [{ zone, hit, isHidden: facing(hit, surface) <= 0, distance }];
  });
  middles.sort((a, b) => Number(a.isHidden) - Number(b.isHidden) || a.distance - b.distance);
  const [best] = middles;
  if (best) return placeIn(best.zone, null, best.hit);
  return seen && { hit: seen, width: usual };
}

function widthInBox({ shape }: PrintZone, aspect: number): number {
  if (shape.kind !== "box") return Number.POSITIVE_INFINITY;
  const [width, height] = shape.size;
  return MOST_OF_ZONE * Math.min(width, height * aspect);
}

const inSight = (facing: number): number => Math.min(1, Math.max(UNSEEN, facing / WELL_SEEN));

/** The cosine of the angle at which the camera sees a place; below zero from behind. */
function facing(hit: SurfaceHit, surface: DecalViewer["surface"]): number {
  const towardsEye = new Vector3(...surface.lookAt(hit).eye).sub(new Vector3(...hit.position)).normalize();
  return towardsEye.dot(new Vector3(...hit.normal));
}
