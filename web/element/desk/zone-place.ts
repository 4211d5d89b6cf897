/** Where something new goes on a product that is printed in some places only. */
import { Vector3 } from "three";
import type { PrintZone } from "../../engine/print-zones.ts";
import { reachesPoint } from "../../viewer/projector-sight.ts";
import type { DecalViewer, SurfaceHit } from "../../viewer/viewer-api.ts";

/** Of a box's sides: what something new takes at the most, so that it has room to be moved. */
const MOST_OF_ZONE = 0.8;

export interface StartingPlace {
  readonly hit: SurfaceHit;
  /** Metres; what a new decal of an aspect must not be wider than. */
  mostWidth(aspect: number): number;
}

/**
 * The surface under the middle of the view where that may be printed, else the middle of the nearest zone, one that the camera
 * sees before one that it does not. Null without a surface.
 */
export function startingPlace(
  viewer: Pick<DecalViewer, "surface" | "surfaceAtCentre">,
  zones: readonly PrintZone[],
): StartingPlace | null {
  const seen = viewer.surfaceAtCentre();
  const under = seen && zones.find((zone) => holds(zone, seen));
  if (seen && (zones.length === 0 || under)) return { hit: seen, mostWidth: (aspect) => mostWidth(under, aspect) };
  const { surface } = viewer;
  const middles = zones.flatMap((zone) => {
    const hit = middleOf(zone, surface);
    if (hit === null) return [];
    const position = new Vector3(...hit.position);
    const towardsEye = new Vector3(...surface.lookAt(hit).eye).sub(position);
    const isHidden = towardsEye.dot(new Vector3(...hit.normal)) <= 0;
    return [{ zone, hit, isHidden, distance: seen ? position.distanceTo(new Vector3(...seen.position)) : 0 }];
  });
  middles.sort((a, b) => Number(a.isHidden) - Number(b.isHidden) || a.distance - b.distance);
  const [best] = middles;
  if (best) return { hit: best.hit, mostWidth: (aspect) => mostWidth(best.zone, aspect) };
  return seen && { hit: seen, mostWidth: () => Number.POSITIVE_INFINITY };
}

function mostWidth(zone: PrintZone | null | undefined, aspect: number): number {
  // How large a polygon of the texture is on the surface, only a measurement would tell.
  if (zone?.shape.kind !== "box") return Number.POSITIVE_INFINITY;
  const [width, height] = zone.shape.size;
  return MOST_OF_ZONE * Math.min(width, height * aspect);
}

function middleOf({ material, shape }: PrintZone, surface: DecalViewer["surface"]): SurfaceHit | null {
  if (shape.kind === "box") {
    const hit = surface.near(shape.position);
    return hit?.material === material ? hit : null;
  }
  const middle = (axis: 0 | 1): number => {
    const values = shape.polygon.map((corner) => corner[axis]);
    return (Math.min(...values) + Math.max(...values)) / 2;
  };
  return surface.atUv(material, [middle(0), middle(1)]);
}

function holds({ material, shape }: PrintZone, hit: SurfaceHit): boolean {
  if (hit.material !== material) return false;
  if (shape.kind === "uv") return polygonHolds(shape.polygon, hit.uv);
  // A box takes what a decal of that box would reach: the surface in it that faces its +Z.
  const [position, normal] = [new Vector3(...hit.position), new Vector3(...hit.normal)];
  return reachesPoint({ ...shape, kind: "planar" }, { position, normal, uv: hit.uv });
}

function polygonHolds(polygon: readonly (readonly [number, number])[], [u, v]: readonly [number, number]): boolean {
  let inside = false;
  polygon.forEach(([toU, toV], index) => {
    const [fromU, fromV] = polygon.at(index - 1) ?? [toU, toV];
    if (fromV > v !== toV > v && u < fromU + ((toU - fromU) * (v - fromV)) / (toV - fromV)) inside = !inside;
  });
  return inside;
}
