/** Print zones that are boxes, on three's own shapes: what is new begins inside them. */
import { describe, expect, it } from "vitest";
import type { PrintZone } from "../../web/engine/print-zones.ts";
import type { Vec3 } from "../../web/viewer/viewer-api.ts";
import { cylinder, sheet } from "../viewer/surface-helpers.ts";
import { placed, viewerOf } from "./zone-products.ts";

type Quat = readonly [number, number, number, number];
const UPRIGHT: Quat = [0, 0, 0, 1];
const turned = (degrees: number): Quat => {
  const half = (degrees * Math.PI) / 360;
  return [0, 0, Math.sin(half), Math.cos(half)];
};

const zoneOf = (position: Vec3, size: Vec3, rotation = UPRIGHT): PrintZone => ({
  ...{ id: "front", name: "Front", material: 0, safe: 0, bleed: 0, policy: "clip" },
  shape: { kind: "box", position, rotation, size },
});

describe("something new where a zone is a box", () => {
  it("stays under the middle of the view where it fits there", async () => {
    const zone = zoneOf([0, 0, 0], [1.6, 1.6, 1]);
    const { hit, width } = await placed(viewerOf(sheet(), [0.2, 0.2]), zone, { aspect: 1, usual: 0.6 });
    expect(hit.position[0]).toBeCloseTo(0.2);
    expect(hit.position[1]).toBeCloseTo(0.2);
    expect(width).toBeCloseTo(0.6);
  });

  it("goes inwards from there as far as it must to lie wholly inside, as large as usual", async () => {
    const zone = zoneOf([0, 0, 0], [1.6, 1.6, 1]);
    const { hit, width } = await placed(viewerOf(sheet(), [0.7, 0]), zone, { aspect: 1, usual: 0.6 });
    expect(width).toBeCloseTo(0.6);
    expect(hit.position[0]).toBeLessThan(0.6);
    expect(hit.position[0]).toBeGreaterThan(0.2);
  });

  it("is smaller than usual where it fits nowhere, and lies in the middle", async () => {
    const zone = zoneOf([0, 0.1, 0], [1.6, 0.2, 1]);
    const { hit, width } = await placed(viewerOf(sheet(), [0.7, 0.15]), zone, { aspect: 2, usual: 1 });
    expect(width).toBeCloseTo(0.8 * 2 * 0.2, 1);
    expect(hit.position[0]).toBeCloseTo(0, 1);
    expect(hit.position[1]).toBeCloseTo(0.1, 2);
  });

  it("lies inside of a box that stands askew", async () => {
    const zone = zoneOf([0, 0, 0], [1, 0.5, 1], turned(30));
    const { width } = await placed(viewerOf(sheet(), [-0.35, -0.2]), zone, { aspect: 2, usual: 0.9 });
    expect(width).toBeGreaterThan(0.4);
  });

  it("lies inside on a wall that is bent, of which the box takes a part by its width or by its depth", async () => {
    const byWidth = zoneOf([0, 0, 1], [0.9, 1, 1]);
    const { width } = await placed(viewerOf(cylinder(), [0.4, 0.3]), byWidth, { aspect: 1, usual: 0.5 });
    expect(width).toBeCloseTo(0.5);
    const byDepth = zoneOf([0, 0, 1], [3, 1, 0.3]);
    await placed(viewerOf(cylinder(), [0.45, 0.3]), byDepth, { aspect: 3, usual: 1 });
  });

  it("lies inside where the surface turns away before the box ends", async () => {
    const zone = zoneOf([0, 0, 0], [3, 1, 3]);
    const { hit } = await placed(viewerOf(cylinder(), [0.985, 0]), zone, { aspect: 1, usual: 0.6 });
    expect(hit.position[0]).toBeGreaterThan(0.2);
  });

  it("is as wide as usual where the box holds all that there is", async () => {
    const zone = zoneOf([0, 0, 0], [3, 3, 1]);
    const { hit, width } = await placed(viewerOf(sheet(), [0.3, 0.1]), zone, { aspect: 1, usual: 0.5 });
    expect(hit.position[0]).toBeCloseTo(0.3);
    expect(width).toBeCloseTo(0.5);
  });
});
