import { describe, expect, it } from "vitest";
import type { UvProjector } from "../../web/engine/engine-api.ts";
import { stampInLine } from "../../web/viewer/stamp-alignment.ts";

const REACH = [0.02, 0.01] as const;

function stamp(
  center: readonly [number, number],
  size: readonly [number, number] = [0.2, 0.1],
  angle = 0,
): UvProjector {
  return { kind: "uv", center, size, angle };
}

/** Where it comes to lie. */
function inLine(one: UvProjector, ...others: UvProjector[]): readonly [number, number] {
  return stampInLine(one, others, null, REACH).stamp.center;
}

describe("a flat stamp that is dragged", () => {
  it("comes into the middle of its texture, along each axis by itself", () => {
    expect(inLine(stamp([0.51, 0.3]))).toEqual([0.5, 0.3]);
    expect(inLine(stamp([0.3, 0.495]))).toEqual([0.3, 0.5]);
    expect(inLine(stamp([0.49, 0.508]))).toEqual([0.5, 0.5]);
  });

  it("comes to its texture's edges by its own", () => {
    const [left, top] = inLine(stamp([0.11, 0.056]));
    expect([left, top]).toEqual([expect.closeTo(0.1, 12), expect.closeTo(0.05, 12)]);
    const [right, bottom] = inLine(stamp([0.885, 0.944]));
    expect([right, bottom]).toEqual([expect.closeTo(0.9, 12), expect.closeTo(0.95, 12)]);
  });

  it("comes under another one by its middle, and beside it by edges that meet or are level", () => {
    const other = stamp([0.3, 0.2], [0.1, 0.1]);
    expect(inLine(stamp([0.31, 0.7]), other)[0]).toBeCloseTo(0.3, 12);
    expect(inLine(stamp([0.455, 0.7]), other)[0]).toBeCloseTo(0.45, 12);
    expect(inLine(stamp([0.358, 0.7]), other)[0]).toBeCloseTo(0.35, 12);
  });

  it("comes to the middle and the edges of the chart that it lies on", () => {
    const chart = { low: [0.1, 0.2], high: [0.7, 0.8] } as const;
    const { center } = stampInLine(stamp([0.41, 0.255]), [], chart, REACH).stamp;
    expect(center).toEqual([expect.closeTo(0.4, 12), expect.closeTo(0.25, 12)]);
  });

  it("takes the nearest of several lines", () => {
    expect(inLine(stamp([0.507, 0.7]), stamp([0.512, 0.2]))[0]).toBe(0.512);
    expect(inLine(stamp([0.504, 0.7]), stamp([0.512, 0.2]))[0]).toBe(0.5);
  });

  it("stays where it is beyond the reach of any", () => {
    const far = stamp([0.33, 0.27]);
    expect(stampInLine(far, [stamp([0.7, 0.7])], null, REACH)).toEqual({ stamp: far, lines: [] });
  });

  it("goes by the upright border of one that is turned, and keeps its size and turn", () => {
    const turned = stamp([0.11, 0.3], [0.1, 0.2], 90);
    const { stamp: moved } = stampInLine(turned, [], null, REACH);
    expect(moved.center[0]).toBeCloseTo(0.1, 12);
    expect([moved.size, moved.angle]).toEqual([turned.size, turned.angle]);
  });

  it("shows the lines that it shares, over all that share them", () => {
    const other = stamp([0.5, 0.2], [0.1, 0.1]);
    const { lines } = stampInLine(stamp([0.505, 0.7]), [other], null, REACH);
    expect(lines).toEqual([
      [
        [0.5, 0],
        [0.5, 1],
      ],
    ]);
    const apart = stampInLine(stamp([0.255, 0.7]), [stamp([0.25, 0.2], [0.5, 0.1])], null, REACH);
    expect(apart.lines[0]).toEqual([
      [0.25, expect.closeTo(0.15, 12)],
      [0.25, expect.closeTo(0.75, 12)],
    ]);
  });
});
