/** Products of three's own shapes with a print zone, and what something new paints of them. */
import { type BufferGeometry, Vector3 } from "three";
import { expect } from "vitest";
import { type Uv, zoneHolds } from "../../web/element/desk/zone-holds.ts";
import { type Newcomer, type StartingPlace, startingPlace } from "../../web/element/desk/zone-place.ts";
import type { PrintZone } from "../../web/engine/print-zones.ts";
import { placeOnSurface } from "../../web/viewer/decal-placement.ts";
import { projectorOf } from "../../web/viewer/decal-pose.ts";
import { reachesPoint } from "../../web/viewer/projector-sight.ts";
import { hitOf } from "../../web/viewer/surface-hit.ts";
import type { DecalViewer, SurfaceHit } from "../../web/viewer/viewer-api.ts";
import { queryOf } from "../viewer/surface-helpers.ts";

const VIEW = { right: new Vector3(1, 0, 0), up: new Vector3(0, 1, 0) };
const EYE = new Vector3(0, 0, 10);

type Viewer = Pick<DecalViewer, "surface" | "surfaceAtCentre" | "projectorAt" | "landing">;

/** Looked at from +Z; under the middle of the view is what lies behind (x, y). */
export function viewerOf(geometry: BufferGeometry, [x, y]: Uv): Viewer {
  const query = queryOf(geometry);
  const seen = query.raycast(new Vector3(x, y, 10), new Vector3(0, 0, -1));
  return {
    surface: {
      near: (position) => {
        const sample = query.closest(new Vector3(...position));
        return sample && hitOf(sample);
      },
      atUv: (material, uv) => {
        const place = query.triangleAtUv(material, uv);
        return place && hitOf(query.at(place.triangle, place.shares));
      },
      lookAt: () => ({ eye: [EYE.x, EYE.y, EYE.z], up: [0, 1, 0] }),
    },
    surfaceAtCentre: () => seen && hitOf(seen),
    landing: (width) => seen && { hit: hitOf(seen), width },
    projectorAt: ({ position, normal }, width, aspect) => {
      const place = { position: new Vector3(...position), normal: new Vector3(...normal) };
      return projectorOf(placeOnSurface(query, place, width, aspect, VIEW, null));
    },
  };
}

/** How many places of the texture are painted that lie outside of the zone, and inside. */
function painted(viewer: Viewer, zone: PrintZone, { hit, width }: StartingPlace, aspect: number): [number, number] {
  const projector = viewer.projectorAt(hit, width, aspect);
  const counts: [number, number] = [0, 0];
  for (let row = 0; row < 200; row++) {
    for (let column = 0; column < 200; column++) {
      const at = viewer.surface.atUv(0, [(column + 0.5) / 200, (row + 0.5) / 200]) as SurfaceHit;
      const point = { position: new Vector3(...at.position), normal: new Vector3(...at.normal), uv: at.uv };
      if (reachesPoint(projector, point)) counts[zoneHolds(zone, at) ? 1 : 0]++;
    }
  }
  return counts;
}

/** Where it begins; fails where any of it lies outside of the zone. */
export async function placed(viewer: Viewer, zone: PrintZone, newcomer: Newcomer): Promise<StartingPlace> {
  const place = await startingPlace(viewer, [zone], newcomer);
  if (place === null) throw new Error("There is no place for it.");
  const [outside, inside] = painted(viewer, zone, place, newcomer.aspect);
  expect(outside, "places that are painted outside of the zone").toBe(0);
  expect(inside).toBeGreaterThan(0);
  return place;
}
