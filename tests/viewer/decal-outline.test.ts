import { describe, expect, it } from "vitest";
import { bridgeGaps, drapeOutline, POINTS_PER_EDGE } from "../../web/viewer/decal-outline.ts";
import { poseAt } from "./pose-helpers.ts";
import { cylinder, queryOf, sheet } from "./surface-helpers.ts";

describe("the draped outline", () => {
  it("lies on the surface, a little above it", () => {
    const outline = drapeOutline(queryOf(cylinder()), poseAt({ position: [0, 0, 1], size: [0.8, 0.4, 0.6] }));
    expect(outline).toHaveLength(4 * POINTS_PER_EDGE);
    for (const { position, onSurface } of outline) {
      const lift = Math.hypot(position.x, position.z) - 1;
      expect(onSurface).toBe(true);
      expect(lift).toBeGreaterThan(0);
      expect(lift).toBeLessThan(0.01);
    }
  });

  it("begins at the bottom left corner and goes anticlockwise as the picture's viewer sees it", () => {
    const outline = drapeOutline(queryOf(sheet()), poseAt({ size: [1, 0.5, 0.2] }));
    const cornerAt = (corner: number) =>
      outline[corner * POINTS_PER_EDGE]?.position.toArray().map((value) => +value.toFixed(3));
    expect(cornerAt(0)?.slice(0, 2)).toEqual([-0.5, -0.25]);
    expect(cornerAt(1)?.slice(0, 2)).toEqual([0.5, -0.25]);
    expect(cornerAt(2)?.slice(0, 2)).toEqual([0.5, 0.25]);
  });

  it("tells where the box catches no surface", () => {
    const outline = drapeOutline(queryOf(sheet()), poseAt({ position: [1, 0, 0], size: [1, 0.5, 0.2] }));
    expect(outline[0]?.onSurface).toBe(true);
    expect(outline[POINTS_PER_EDGE]?.onSurface).toBe(false);
  });
});

describe("gaps in a closed line", () => {
  it("are bridged straight from end to end", () => {
    expect(bridgeGaps([0, null, null, 3, null, 1])).toEqual([0, 1, 2, 3, 2, 1]);
  });

  it("are bridged across the line's beginning", () => {
    expect(bridgeGaps([null, 2, 5, null])).toEqual([3, 2, 5, 4]);
  });

  it("leave a line without any height flat", () => {
    expect(bridgeGaps([null, null, null])).toEqual([0, 0, 0]);
  });
});
