/** Whether a print zone holds a place of the surface. */
import { Vector3 } from "three";
import type { BoxZoneShape, PrintZone, UvZoneShape } from "../../engine/print-zones.ts";
import { reachesPoint } from "../../viewer/projector-sight.ts";
import type { SurfaceHit } from "../../viewer/viewer-api.ts";

/** Texture coordinates. */
export type Uv = readonly [number, number];
export type PolygonZone = PrintZone & { readonly shape: UvZoneShape };
export type BoxZone = PrintZone & { readonly shape: BoxZoneShape };

export function isPolygon(zone: PrintZone): zone is PolygonZone {
  return zone.shape.kind === "uv";
}

export function zoneHolds({ material, shape }: PrintZone, hit: SurfaceHit): boolean {
  if (hit.material !== material) return false;
  if (shape.kind === "uv") return polygonHolds(shape.polygon, hit.uv);
  // A box takes what a decal of that box would reach: the surface in it that faces its +Z.
  const [position, normal] = [new Vector3(...hit.position), new Vector3(...hit.normal)];
  return reachesPoint({ ...shape, kind: "planar" }, { position, normal, uv: hit.uv });
}

export function polygonHolds(polygon: readonly Uv[], [u, v]: Uv): boolean {
  let inside = false;
  polygon.forEach(([toU, toV], index) => {
    const [fromU, fromV] = polygon.at(index - 1) ?? [toU, toV];
    if (fromV > v !== toV > v && u < fromU + ((toU - fromU) * (v - fromV)) / (toV - fromV)) inside = !inside;
  });
  return inside;
}
