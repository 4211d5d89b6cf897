/** Print zones that are polygons of the texture, on three's own shapes: what is new begins inside them. */
import { describe, expect, it } from "vitest";
import { deepestPlace } from "../../web/element/desk/polygon-places.ts";
import { type PolygonZone, type Uv, zoneHolds } from "../../web/element/desk/zone-holds.ts";
import { cylinder, sheet } from "../viewer/surface-helpers.ts";
import { placed, viewerOf } from "./zone-products.ts";

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
