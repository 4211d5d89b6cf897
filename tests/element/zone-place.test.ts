import { describe, expect, it } from "vitest";
import { startingPlace } from "../../web/element/desk/zone-place.ts";
import type { PlanarProjector } from "../../web/engine/engine-api.ts";
import type { PrintZone } from "../../web/engine/print-zones.ts";
import type { DecalViewer, SurfaceHit, Vec3 } from "../../web/viewer/viewer-api.ts";

const hitAt = (position: Vec3, normal: Vec3, uv: readonly [number, number] = [0.5, 0.5], material = 0): SurfaceHit => ({
  ...{ position, normal, uv, material },
  face: 0,
});
const BELT = hitAt([0, 0.5, 0.1], [0, 0, 1], [0.5, 0.9]);
const CHEST = hitAt([0, 1, 0.1], [0, 0, 1]);
const BACK = hitAt([0, 1, -0.1], [0, 0, -1]);

type Viewer = Pick<DecalViewer, "surface" | "surfaceAtCentre" | "projectorAt" | "landing">;
const SQUARE = { aspect: 1, usual: 10 };

/** Seen from the front; `centre` is under the middle of the view. */
function viewerOf(
  centre: SurfaceHit | null,
  atUv: SurfaceHit | null = null,
  landing: DecalViewer["landing"] = (width) => Promise.resolve(centre && { hit: centre, width }),
) {
  const surface = {
    near: ([, , z]: Vec3) => (z > 0 ? CHEST : BACK),
    atUv: () => atUv,
    lookAt: () => ({ eye: [0, 1, 5], up: [0, 1, 0] }),
  };
  const projectorAt = ({ position }: SurfaceHit, width: number, aspect: number): PlanarProjector => ({
    ...{ kind: "planar", position, rotation: [0, 0, 0, 1], size: [width, width / aspect, 0.1] },
  });
  return { surface, surfaceAtCentre: () => centre, projectorAt, landing } as unknown as Viewer;
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
  it("goes under the middle of the view where the product has no zones, and is as wide as usual", async () => {
    expect(await startingPlace(viewerOf(BELT), [], SQUARE)).toEqual({ hit: BELT, width: 10 });
    expect(await startingPlace(viewerOf(null), [], SQUARE)).toBeNull();
  });

  it("goes where the view has room for it where the product has no zones, and in the middle where that cannot be told", async () => {
    const landing = { hit: CHEST, width: 5 };
    expect(
      await startingPlace(
        viewerOf(BELT, null, async () => landing),
        [],
        SQUARE,
      ),
    ).toBe(landing);
    const offline = viewerOf(BELT, null, () => Promise.reject(new TypeError("Failed to fetch")));
    expect(await startingPlace(offline, [], SQUARE)).toEqual({ hit: BELT, width: 10 });
    expect(
      await startingPlace(
        viewerOf(BELT, null, async () => null),
        [],
        SQUARE,
      ),
    ).toEqual({ hit: BELT, width: 10 });
  });

  it("stays under the middle of the view where that is printed, no larger than the zone", async () => {
    const zones = [BACK_BOX, FRONT_BOX];
    const place = await startingPlace(viewerOf(CHEST), zones, SQUARE);
    expect(place?.hit).toBe(CHEST);
    expect(place?.width).toBeCloseTo(0.16);
    expect((await startingPlace(viewerOf(CHEST), zones, { ...SQUARE, aspect: 4 }))?.width).toBeCloseTo(0.32);
    expect((await startingPlace(viewerOf(CHEST), zones, { aspect: 1, usual: 0.1 }))?.width).toBe(0.1);
  });

  it("goes to the zone that the camera sees where the middle of the view is not printed", async () => {
    expect((await startingPlace(viewerOf(BELT), [BACK_BOX, FRONT_BOX], SQUARE))?.hit).toBe(CHEST);
    expect((await startingPlace(viewerOf(null), [BACK_BOX, FRONT_BOX], SQUARE))?.hit).toBe(CHEST);
    expect((await startingPlace(viewerOf(BELT), [BACK_BOX], SQUARE))?.hit).toBe(BACK);
  });

  it("goes under the middle of the view where a zone of the texture lies beside all charts", async () => {
    const beside = wall([
      [0.2, 0.2],
      [0.8, 0.2],
      [0.8, 0.8],
    ]);
    expect((await startingPlace(viewerOf(BELT), [beside], SQUARE))?.hit).toBe(BELT);
  });
});
