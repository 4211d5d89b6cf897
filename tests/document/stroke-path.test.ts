import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { type Dab, type PathPoint, placeDabs, type Vec3 } from "../../web/editor/document/index.ts";

const UP: Vec3 = [0, 1, 0];
const FRONT: Vec3 = [0, 0, 1];
const at = (x: number, y = 0, z = 0, normal: Vec3 = FRONT, pressure?: number): PathPoint => ({
  position: [x, y, z],
  normal,
  ...(pressure !== undefined && { pressure }),
});
const positions = (dabs: readonly Dab[]): Vec3[] =>
  dabs.map((dab) => (dab.kind === "planar" ? dab.position : [0, 0, 0]));
const axis = (dab: Dab | undefined, [x, y, z]: Vec3): number[] => {
  if (dab?.kind !== "planar") throw new Error("not a planar dab");
  const [a, b, c, w] = dab.rotation;
  // v + 2 w (q x v) + 2 q x (q x v)
  const [tx, ty, tz] = [2 * (b * z - c * y), 2 * (c * x - a * z), 2 * (a * y - b * x)];
  return [x + w * tx + b * tz - c * ty, y + w * ty + c * tx - a * tz, z + w * tz + a * ty - b * tx];
};
const close = (a: readonly number[], b: readonly number[]): boolean =>
  a.length === b.length && a.every((part, i) => Math.abs(part - (b[i] ?? Number.NaN)) < 1e-9);

describe("placing dabs along a path", () => {
  it("lays one every share of the size, the first on the first point", () => {
    const { dabs } = placeDabs([at(0), at(1)], { size: 0.5, spacing: 0.5 });
    expect(positions(dabs)).toEqual([0, 0.25, 0.5, 0.75, 1].map((x) => [x, 0, 0]));
    expect(dabs[0]).toMatchObject({ kind: "planar", size: [0.5, 0.5, 0.5], flow: 1, rotation: [0, 0, 0, 1] });
  });

  it("gives a picture its proportions: its longer side is the size", () => {
    const sizeAt = (aspect: number) => placeDabs([at(0)], { size: 0.5, depth: 0.3, aspect }).dabs;
    expect(sizeAt(2)).toMatchObject([{ size: [0.5, 0.25, 0.3] }]);
    expect(sizeAt(0.5)).toMatchObject([{ size: [0.25, 0.5, 0.3] }]);
  });

  it("lays one dab for a click, and none for no path", () => {
    expect(placeDabs([at(3)], { size: 1 }).dabs).toHaveLength(1);
    expect(placeDabs([at(3), at(3), at(3)], { size: 1 }).dabs).toHaveLength(1);
    expect(placeDabs([], { size: 1 })).toEqual({ dabs: [], tail: null });
  });

  it("lays small dabs as close as large ones for their size, where pressure is the size", () => {
    const { dabs } = placeDabs([at(0, 0, 0, FRONT, 0.1), at(1, 0, 0, FRONT, 0.1)], {
      ...{ size: 1, spacing: 0.25, pressure: "size" },
    });
    expect(dabs).toHaveLength(41);
    expect(dabs[1]).toMatchObject({ size: [0.1, 0.1, 1], flow: 1, position: [expect.closeTo(0.025), 0, 0] });
  });

  it("keeps a width under no pressure at all", () => {
    const { dabs } = placeDabs([at(0, 0, 0, FRONT, 0)], { size: 1, pressure: "size" });
    expect(dabs).toMatchObject([{ size: [0.05, 0.05, 1] }]);
  });

  it("carries what is left over of a line round the corner", () => {
    const { dabs, tail } = placeDabs([at(0), at(0.75), at(0.75, 0.75)], { size: 1, spacing: 0.5, depth: 0.25 });
    expect(positions(dabs)).toEqual([
      [0, 0, 0],
      [0.5, 0, 0],
      [0.75, 0.25, 0],
      [0.75, 0.75, 0],
    ]);
    expect(dabs[0]).toMatchObject({ size: [1, 1, 0.25] });
    expect(tail?.untilNext).toBe(0.5);
  });

  const path = fc.array(
    fc.record({
      position: fc.tuple(...[0, 1, 2].map(() => fc.integer({ min: -40, max: 40 }).map((n) => n / 16))),
      pressure: fc.double({ min: 0, max: 1, noNaN: true }),
    }),
    { minLength: 2, maxLength: 8 },
  );
  const pressures = fc.constantFrom("flow" as const, "size" as const);
  const pointsOf = (list: readonly { position: number[]; pressure: number }[]): PathPoint[] =>
    list.map(({ position, pressure }) => ({ position: position as unknown as Vec3, normal: FRONT, pressure }));

  it("gives the very same dabs when the path comes in pieces", () => {
    fc.assert(
      fc.property(path, fc.array(fc.nat(8)), fc.double({ min: 0.05, max: 2, noNaN: true }), pressures, (...given) => {
        const [list, cuts, spacing, pressure] = given;
        const points = pointsOf(list);
        const options = { size: 0.3, spacing, pressure };
        const whole = placeDabs(points, options);
        const dabs: Dab[] = [];
        let tail = null;
        let from = 0;
        for (const cut of [...cuts.sort((a, b) => a - b), points.length]) {
          const to = Math.max(from, Math.min(cut, points.length));
          const piece = placeDabs(points.slice(from, to), options, tail);
          dabs.push(...piece.dabs);
          tail = piece.tail;
          from = to;
        }
        expect(dabs).toEqual(whole.dabs);
        expect(tail).toEqual(whole.tail);
      }),
    );
  });

  it("gives the same dabs however finely its lines are sampled", () => {
    fc.assert(
      fc.property(
        path,
        fc.integer({ min: 2, max: 9 }),
        fc.constantFrom(0.1, 0.25, 1 / 3, 0.7),
        pressures,
        (list, parts, spacing, pressure) => {
          const points = pointsOf(list);
          const fine = points.flatMap((point, i) => {
            const next = points[i + 1];
            if (next === undefined) return [point];
            return Array.from({ length: parts }, (_, k): PathPoint => {
              const mix = (a: number, b: number): number => a + ((b - a) * k) / parts;
              const [p, q] = [point.position, next.position];
              const position: Vec3 = [mix(p[0], q[0]), mix(p[1], q[1]), mix(p[2], q[2])];
              return { position, normal: FRONT, pressure: mix(point.pressure ?? 1, next.pressure ?? 1) };
            });
          });
          const coarse = placeDabs(points, { size: 0.25, spacing, pressure }).dabs;
          const chopped = placeDabs(fine, { size: 0.25, spacing, pressure }).dabs;
          expect(chopped).toHaveLength(coarse.length);
          const places = positions(coarse);
          expect(positions(chopped).every((place, i) => close(place, places[i] ?? []))).toBe(true);
          expect(chopped.every((dab, i) => Math.abs(dab.flow - (coarse[i]?.flow ?? 2)) < 1e-9)).toBe(true);
        },
      ),
    );
  });

  it("keeps every two neighbours on one line a step apart", () => {
    const { dabs } = placeDabs([at(0), at(10, 3, -4)], { size: 0.2, spacing: 0.15 });
    const places = positions(dabs);
    for (let i = 1; i < places.length; i++) {
      const [a, b] = [places[i - 1] ?? [0, 0, 0], places[i] ?? [0, 0, 0]];
      expect(Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2])).toBeCloseTo(0.03, 9);
    }
    expect(dabs).toHaveLength(1 + Math.floor(Math.hypot(10, 3, 4) / 0.03));
  });

  it("takes pressure between the points for flow", () => {
    const { dabs } = placeDabs([at(0, 0, 0, FRONT, 0), at(1, 0, 0, FRONT, 1)], { size: 1, spacing: 0.25 });
    expect(dabs.map(({ flow }) => flow)).toEqual([0, 0.25, 0.5, 0.75, 1]);
  });
});

describe("a dab's rotation", () => {
  it("has its +Z along the normal and its +Y as upright as that allows, whatever the normal", () => {
    fc.assert(
      fc.property(fc.tuple(...[0, 1, 2].map(() => fc.integer({ min: -9, max: 9 }))), (parts) => {
        const [x = 0, y = 0, z = 0] = parts;
        const length = Math.hypot(x, y, z);
        fc.pre(length > 0);
        const [dab] = placeDabs([at(0, 0, 0, [x, y, z])], { size: 1 }).dabs;
        expect(close(axis(dab, [0, 0, 1]), [x / length, y / length, z / length])).toBe(true);
        const up = axis(dab, [0, 1, 0]);
        expect(up[1]).toBeGreaterThan(-1e-9);
        if (x * x + z * z > 0) expect(Math.abs(axis(dab, [1, 0, 0])[1] ?? 1)).toBeLessThan(1e-9);
        const rotation = dab?.kind === "planar" ? dab.rotation : [];
        expect(Math.hypot(...rotation)).toBeCloseTo(1, 12);
      }),
    );
  });

  it("turns with the surface from point to point", () => {
    const { dabs } = placeDabs([at(0, 0, 0, FRONT), at(1, 0, 0, [2, 0, 0])], { size: 1, spacing: 0.5 });
    expect(close(axis(dabs[1], [0, 0, 1]), [Math.SQRT1_2, 0, Math.SQRT1_2])).toBe(true);
    expect(close(axis(dabs[2], [0, 0, 1]), [1, 0, 0])).toBe(true);
  });

  it("on a floor looks away from the viewer in front, and on a ceiling towards them", () => {
    expect(close(axis(placeDabs([at(0, 0, 0, UP)], { size: 1 }).dabs[0], [0, 1, 0]), [0, 0, -1])).toBe(true);
    expect(close(axis(placeDabs([at(0, 0, 0, [0, -1, 0])], { size: 1 }).dabs[0], [0, 1, 0]), [0, 0, 1])).toBe(true);
  });

  it("survives normals that point against each other", () => {
    const { dabs } = placeDabs([at(0, 0, 0, FRONT), at(1, 0, 0, [0, 0, -1])], { size: 1, spacing: 0.5 });
    for (const dab of dabs) expect(close([Math.hypot(...axis(dab, [0, 0, 1]))], [1])).toBe(true);
  });
});

describe("what placing dabs refuses", () => {
  it.each<[string, PathPoint[], object, string]>([
    ["no size", [at(0)], { size: 0 }, "size"],
    ["a size that is no number", [at(0)], { size: Number.NaN }, "size"],
    ["no spacing", [at(0)], { size: 1, spacing: 0 }, "spacing"],
    ["a depth below 0", [at(0)], { size: 1, depth: -1 }, "depth"],
    ["a place that is nowhere", [at(0), at(Number.NaN)], { size: 1 }, "points[1].position"],
    ["a place beyond all bounds", [at(Number.POSITIVE_INFINITY)], { size: 1 }, "points[0].position"],
    ["a normal of zeros", [at(0, 0, 0, [0, 0, 0])], { size: 1 }, "points[0].normal"],
    ["pressure above 1", [at(0, 0, 0, FRONT, 2)], { size: 1 }, "points[0].pressure"],
    ["more dabs than a stroke may hold", [at(0), at(1000)], { size: 1, spacing: 0.001 }, "spacing"],
  ])("%s, naming the field", (_what, points, options, field) => {
    const place = () => placeDabs(points, options as { size: number });
    expect(place).toThrow(TexelcastError);
    expect(place).toThrow(expect.objectContaining({ code: "bad-argument", field }));
  });
});
