import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { orientationOf, quaternionOf, spun, wrapDegrees } from "../../web/editor/state/rotation.ts";
import type { Quaternion } from "../../web/engine/engine-api.ts";

type Vector = readonly [number, number, number];

function turned([x, y, z, w]: Quaternion, [a, b, c]: Vector): number[] {
  const tx = 2 * (y * c - z * b);
  const ty = 2 * (z * a - x * c);
  const tz = 2 * (x * b - y * a);
  return [a + w * tx + y * tz - z * ty, b + w * ty + z * tx - x * tz, c + w * tz + x * ty - y * tx];
}

function expectClose(actual: readonly number[], expected: readonly number[]): void {
  for (const [index, value] of actual.entries()) expect(value).toBeCloseTo(expected[index] ?? Number.NaN, 6);
}

const angle = (limit: number) => fc.double({ min: -limit, max: limit, noNaN: true });

describe("orientations", () => {
  it("face +Z at rest, +X at heading 90 and up at tilt 90", () => {
    expectClose(turned(quaternionOf({ heading: 0, tilt: 0, spin: 0 }), [0, 0, 1]), [0, 0, 1]);
    expectClose(turned(quaternionOf({ heading: 90, tilt: 0, spin: 0 }), [0, 0, 1]), [1, 0, 0]);
    expectClose(turned(quaternionOf({ heading: 0, tilt: 90, spin: 0 }), [0, 0, 1]), [0, 1, 0]);
  });

  it("spin the picture counter-clockwise without changing where it faces", () => {
    const rotation = quaternionOf({ heading: 0, tilt: 0, spin: 90 });
    expectClose(turned(rotation, [1, 0, 0]), [0, 1, 0]);
    expectClose(spun([0, 0, 0, 1], 90), rotation);
  });

  it("come back from their quaternion, poles included", () => {
    const orientation = fc.record({ heading: angle(180), tilt: angle(90), spin: angle(180) });
    fc.assert(
      fc.property(orientation, (given) => {
        const rotation = quaternionOf(given);
        const again = quaternionOf(orientationOf(rotation, given));
        for (const axis of [[1, 0, 0] as const, [0, 0, 1] as const]) {
          turned(rotation, axis).forEach((value, index) => {
            expect(Math.abs(value - (turned(again, axis)[index] ?? 0))).toBeLessThan(1e-3);
          });
        }
      }),
    );
  });

  it("keep the heading they had when they look straight up or down", () => {
    for (const tilt of [90, -90]) {
      const given = { heading: 30, tilt, spin: 50 };
      const { heading, spin } = orientationOf(quaternionOf(given), given);
      expect(heading).toBe(30);
      expect(spin).toBeCloseTo(50, 4);
    }
  });

  it("wrap angles into (-180, 180]", () => {
    expect([190, -190, 540, -180, 180, 0].map(wrapDegrees)).toEqual([-170, 170, 180, 180, 180, 0]);
  });
});
