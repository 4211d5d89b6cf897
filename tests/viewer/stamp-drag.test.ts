import { describe, expect, it } from "vitest";
import type { UvProjector } from "../../web/engine/engine-api.ts";
import { movedStamp, scaledStamp, stampHolds, turnedStamp, uvOfStamp } from "../../web/viewer/stamp-drag.ts";

const STAMP: UvProjector = { kind: "uv", center: [0.4, 0.6], size: [0.2, 0.1], angle: 90 };

describe("a flat stamp's handles", () => {
  it("its picture's right side lies below its middle once it is turned by 90° clockwise", () => {
    const [u, v] = uvOfStamp(STAMP, 0.5, 0);
    expect(u).toBeCloseTo(0.4, 9);
    expect(v).toBeCloseTo(0.7, 9);
    expect(stampHolds(STAMP, [0.4, 0.69])).toBe(true);
    expect(stampHolds(STAMP, [0.49, 0.6])).toBe(false);
  });

  it("a drag moves it by the pointer's way", () => {
    const { center } = movedStamp(STAMP, [0.1, 0.1], [0.3, 0.05]);
    expect(center[0]).toBeCloseTo(0.6, 9);
    expect(center[1]).toBeCloseTo(0.55, 9);
  });

  it("a corner keeps under the pointer and the opposite corner where it was", () => {
    const corner = uvOfStamp(STAMP, 0.5, 0.5);
    const opposite = uvOfStamp(STAMP, -0.5, -0.5);
    const target = [2 * corner[0] - opposite[0], 2 * corner[1] - opposite[1]] as const;
    const grown = scaledStamp(STAMP, { x: 1, y: 1 }, corner, target, false);
    expect(grown.size[0]).toBeCloseTo(0.4, 9);
    expect(grown.size[1]).toBeCloseTo(0.2, 9);
    for (const axis of [0, 1] as const) {
      expect(uvOfStamp(grown, 0.5, 0.5)[axis]).toBeCloseTo(target[axis], 9);
      expect(uvOfStamp(grown, -0.5, -0.5)[axis]).toBeCloseTo(opposite[axis], 9);
    }
  });

  it("an edge changes its own side alone, with Alt on both sides of the middle", () => {
    const edge = uvOfStamp(STAMP, 0.5, 0);
    const wider = scaledStamp(STAMP, { x: 1, y: 0 }, edge, [edge[0], edge[1] + 0.05], true);
    expect(wider.size[0]).toBeCloseTo(0.3, 9);
    expect(wider.size[1]).toBe(0.1);
    expect(wider.center[1]).toBeCloseTo(0.6, 9);
  });

  it("the knob turns it clockwise with the pointer, with Shift in steps of 15°", () => {
    expect(turnedStamp(STAMP, [0.5, 0.6], [0.4, 0.7], false).angle).toBeCloseTo(-180, 9);
    expect(turnedStamp(STAMP, [0.5, 0.6], [0.5, 0.63], true).angle).toBe(105);
  });
});
