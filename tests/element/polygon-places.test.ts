/** Print zones that are polygons of the texture, on three's own shapes: what is new begins inside them. */
import { type BufferGeometry, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { deepestPlace } from "../../web/element/desk/polygon-places.ts";
import type { PolygonZone, Uv } from "../../web/element/desk/zone-holds.ts";
import { zoneHolds } from "../../web/element/desk/zone-holds.ts";
import { type Newcomer, type StartingPlace, startingPlace } from "../../web/element/desk/zone-place.ts";
import { placeOnSurface } from "../../web/viewer/decal-placement.ts";
import { projectorOf } from "../../web/viewer/decal-pose.ts";
import { reachesPoint } from "../../web/viewer/projector-sight.ts";
import { hitOf } from "../../web/viewer/surface-hit.ts";
import type { DecalViewer, SurfaceHit } from "../../web/viewer/viewer-api.ts";
import { cylinder, queryOf, sheet } from "../viewer/surface-helpers.ts";

const VIEW = { right: new Vector3(1, 0, 0), up: new Vector3(0, 1, 0) };
const EYE = new Vector3(0, 0, 10);

type Viewer = Pick<DecalViewer, "surface" | "surfaceAtCentre" | "projectorAt">;

/** Looked at from +Z; under the middle of the view is what lies behind (x, y). */
function viewerOf(geometry: BufferGeometry, [x, y]: Uv): Viewer {
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
    projectorAt: ({ position, normal }, width, aspect) => {
      const place = { position: new Vector3(...position), normal: new Vector3(...normal) };
      return projectorOf(placeOnSurface(query, place, width, aspect, VIEW, null));
    },
  };
}

const zoneOf = (polygon: readonly Uv[]): PolygonZone => ({
  ...{ id: "wall", name: "Wall", material: 0, safe: 0, bleed: 0, policy: "clip" },
  shape: { kind: "uv", polygon },
});

const rectangle = (left: number, top: number, right: number, bottom: number): Uv[] => [
  [left, top],
  [right, top],
  [right, bottom],
  [left, bottom],
];

/** How many places of the texture are painted that lie outside of the zone, and inside. */
function painted(viewer: Viewer, zone: PolygonZone, { hit, width }: StartingPlace, aspect: number): [number, number] {
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

async function placed(viewer: Viewer, zone: PolygonZone, newcomer: Newcomer): Promise<StartingPlace> {
  const place = await startingPlace(viewer, [zone], newcomer);
  if (place === null) throw new Error("There is no place for it.");
  const [outside, inside] = painted(viewer, zone, place, newcomer.aspect);
  expect(outside, "places that are painted outside of the zone").toBe(0);
  expect(inside).toBeGreaterThan(0);
  return place;
}

// The texture of three's sheet stands on its head: v runs upwards.
describe("something new where a zone is a polygon of the texture", () => {
  it("stays under the middle of the view where it fits there", async () => {
    const { hit, width } = await placed(viewerOf(sheet(), [0.2, 0.2]), zoneOf(rectangle(0.1, 0.1, 0.9, 0.9)), {
      ...{ aspect: 1, usual: 0.6 },
    });
    expect(hit.position[0]).toBeCloseTo(0.2);
    expect(hit.position[1]).toBeCloseTo(0.2);
    expect(width).toBeCloseTo(0.6);
  });

  it("goes inwards from there as far as it must to lie wholly inside, as large as usual", async () => {
    const { hit, width } = await placed(viewerOf(sheet(), [0.7, 0]), zoneOf(rectangle(0.1, 0.1, 0.9, 0.9)), {
      ...{ aspect: 1, usual: 0.6 },
    });
    expect(width).toBeCloseTo(0.6);
    expect(hit.position[0]).toBeLessThan(0.6);
    expect(hit.position[0]).toBeGreaterThan(0.2);
  });

  it("is smaller than usual where it fits nowhere, and lies in the middle", async () => {
    const zone = zoneOf(rectangle(0.1, 0.4, 0.9, 0.5));
    const { hit, width } = await placed(viewerOf(sheet(), [0.7, -0.15]), zone, { aspect: 2, usual: 1 });
    expect(width).toBeCloseTo(0.8 * 2 * 0.2, 1);
    expect(hit.position[0]).toBeCloseTo(0, 1);
    expect(hit.position[1]).toBeCloseTo(-0.1, 2);
  });

  it("goes into the broad part of a corner, though the middle of the polygon's box is not in it", async () => {
    const corner = zoneOf([
      [0.1, 0.1],
      [0.9, 0.1],
      [0.9, 0.2],
      [0.4, 0.2],
      [0.4, 0.9],
      [0.1, 0.9],
    ]);
    const { width } = await placed(viewerOf(sheet(), [0.7, 0.7]), corner, { aspect: 1, usual: 0.4 });
    expect(width).toBeCloseTo(0.4);
  });

  it("lies inside on a wall that is bent, on the side that is looked at", async () => {
    const band = zoneOf(rectangle(0.02, 0.3, 0.98, 0.7));
    const { hit } = await placed(viewerOf(cylinder(), [0.3, 0.45]), band, { aspect: 1, usual: 0.6 });
    expect(hit.position[2]).toBeGreaterThan(0.5);
  });

  it("heeds the end of its chart where the polygon goes beyond it", async () => {
    // Of the cylinder's texture the wall has all, and the lid as well: the wall owns what both show.
    const band = zoneOf(rectangle(-0.2, 0.7, 1.2, 0.9));
    await placed(viewerOf(cylinder(), [0, 0.9]), band, { aspect: 1, usual: 0.6 });
  });

  it("is as wide as usual where the whole texture is the zone", async () => {
    const whole = zoneOf(rectangle(0, 0, 1, 1));
    const { hit, width } = await placed(viewerOf(sheet(), [0.3, 0.1]), whole, { aspect: 1, usual: 0.5 });
    expect(hit.position[0]).toBeCloseTo(0.3);
    expect(width).toBeCloseTo(0.5);
  });
});

describe("a polygon's deepest place", () => {
  it("is the middle of a strip, of whose middle line all is as deep", () => {
    const { surface } = viewerOf(sheet(), [0, 0]);
    const place = deepestPlace(zoneOf(rectangle(0.1, 0.4, 0.9, 0.6)), surface);
    expect(place?.uv[0]).toBeCloseTo(0.5, 6);
    expect(place?.uv[1]).toBeCloseTo(0.5, 6);
    const thin = deepestPlace(zoneOf(rectangle(0.13, 0.4, 0.88, 0.43)), surface);
    expect(thin?.uv[0]).toBeCloseTo(0.505, 6);
  });

  it("is there though the polygon's box has none of it in its middle, and nowhere beside all charts", () => {
    const { surface } = viewerOf(sheet(), [0, 0]);
    const hook = zoneOf([
      [0.1, 0.1],
      [0.5, 0.1],
      [0.5, 0.2],
      [0.2, 0.2],
      [0.2, 0.9],
      [0.1, 0.9],
    ]);
    const place = deepestPlace(hook, surface);
    expect(place && zoneHolds(hook, place)).toBe(true);
    expect(deepestPlace({ ...hook, material: 3 }, surface)).toBeNull();
  });
});
