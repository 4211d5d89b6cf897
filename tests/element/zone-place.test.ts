import { describe, expect, it } from "vitest";
import { startingPlace } from "../../web/element/desk/zone-place.ts";
import type { PrintZone } from "../../web/engine/print-zones.ts";
import type { ModelViewer, SurfaceHit, Vec3 } from "../../web/viewer/viewer-api.ts";

const hitAt = (position: Vec3, normal: Vec3, uv: readonly [number, number] = [0.5, 0.5], material = 0): SurfaceHit => ({
  ...{ position, normal, uv, material },
  face: 0,
});
const BELT = hitAt([0, 0.5, 0.1], [0, 0, 1], [0.5, 0.9]);
const CHEST = hitAt([0, 1, 0.1], [0, 0, 1]);
const BACK = hitAt([0, 1, -0.1], [0, 0, -1]);

/** Seen from the front; `centre` is under the middle of the view. */
function viewerOf(centre: SurfaceHit | null, atUv: SurfaceHit | null = null) {
  const surface = {
    near: ([, , z]: Vec3) => (z > 0 ? CHEST : BACK),
    atUv: () => atUv,
    lookAt: () => ({ eye: [0, 1, 5], up: [0, 1, 0] }),
  };
  return { surface, surfaceAtCentre: () => centre } as unknown as Pick<ModelViewer, "surface" | "surfaceAtCentre">;
}

const usual = { material: 0, safe: 0, bleed: 0, policy: "clip" } as const;
const box = (id: string, z: number, rotation: readonly [number, number, number, number]): PrintZone => ({
  ...{ ...usual, id, name: id },
  shape: { kind: "box", position: [0, 1, z], rotation, size: [0.4, 0.2, 0.1] },
});
const FRONT_BOX = box("chest", 0.12, [0, 0, 0, 1]);
const BACK_BOX = box("back", -0.12, [0, 1, 0, 0]);
const wall = (polygon: readonly (readonly [number, number])[]): PrintZone => ({
  ...{ ...usual, id: "wall", name: "Wall" },
  shape: { kind: "uv", polygon },
});

describe("something new on a product", () => {
  it("goes under the middle of the view where the product has no zones, and may be as wide as it likes", () => {
    const place = startingPlace(viewerOf(BELT), []);
    expect(place?.hit).toBe(BELT);
    expect(place?.mostWidth(2)).toBe(Number.POSITIVE_INFINITY);
    expect(startingPlace(viewerOf(null), [])).toBeNull();
  });

  it("stays under the middle of the view where that is printed, no larger than the zone", () => {
    const place = startingPlace(viewerOf(CHEST), [BACK_BOX, FRONT_BOX]);
    expect(place?.hit).toBe(CHEST);
    expect(place?.mostWidth(1)).toBeCloseTo(0.16);
    expect(place?.mostWidth(4)).toBeCloseTo(0.32);
  });

  it("goes to the zone that the camera sees where the middle of the view is not printed", () => {
    expect(startingPlace(viewerOf(BELT), [BACK_BOX, FRONT_BOX])?.hit).toBe(CHEST);
    expect(startingPlace(viewerOf(null), [BACK_BOX, FRONT_BOX])?.hit).toBe(CHEST);
    expect(startingPlace(viewerOf(BELT), [BACK_BOX])?.hit).toBe(BACK);
  });

  it("takes a zone of the texture by its polygon, and its middle where it lies on the surface", () => {
    const polygon = [
      [0.2, 0.2],
      [0.8, 0.2],
      [0.8, 0.8],
      [0.2, 0.8],
    ] as const;
    expect(startingPlace(viewerOf(CHEST, BACK), [wall(polygon)])?.hit).toBe(CHEST);
    expect(startingPlace(viewerOf(BELT, CHEST), [wall(polygon)])?.hit).toBe(CHEST);
    expect(startingPlace(viewerOf(BELT, null), [wall(polygon)])?.hit, "a zone beside all charts").toBe(BELT);
  });
});
