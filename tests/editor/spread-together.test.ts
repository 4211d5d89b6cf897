import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { PlacedLayer } from "../../web/editor/document/index.ts";
import { canSpread, type SpreadOfLayers, spreadTogether } from "../../web/editor/state/spread-together.ts";
import type { Projector } from "../../web/engine/engine-api.ts";
import { box, HALF, label, layer, placesOf, sheet, stamp } from "../support/pictures-on-a-sheet.ts";

const places = (layers: readonly PlacedLayer[], first: PlacedLayer, spread: SpreadOfLayers): number[][] =>
  placesOf(spreadTogether(layers, first, spread, sheet));

describe("several pictures that are spread evenly", () => {
  const [left, near, right] = [layer("l", box(0, 0.3)), layer("n", box(0.25, 0.1)), layer("r", box(1, 0.2))];

  it("stay where they are at the ends, and have the same way from each to the next, in whatever order they lie", () => {
    expect(places([left, near, right], left, "across")).toEqual([
      [0, 0.3],
      [0.5, 0.1],
      [1, 0.2],
    ]);
    expect(places([right, near, left], near, "across")).toEqual([
      [1, 0.2],
      [0.5, 0.1],
      [0, 0.3],
    ]);
    expect(places([left, near, right], left, "down")[2]).toEqual([1, 0.2]);
  });

  it("have gaps alike, and not middles, where their sizes differ", () => {
    const wide = layer("w", box(0.9, 0, [0.6, 0.2]));
    const end = layer("e", box(2, 0, [0.2, 0.2]));
    const all = [left, near, wide, end];
    const [, second = [], third = []] = places(all, left, "across");
    const gaps = [second[0] - 0.1 - 0.1, third[0] - 0.3 - (second[0] + 0.1), 2 - 0.1 - (third[0] + 0.3)];
    for (const gap of gaps) expect(gap).toBeCloseTo((2 - 0.1 - 0.2 - 0.6 - 0.1) / 3, 8);
  });

  it("have their middles alike far apart where there is less room than they fill", () => {
    const crowd = [0, 0.05, 0.06, 0.3].map((x, at) => layer(String(at), box(x, 0)));
    expect(places(crowd, crowd[0] as PlacedLayer, "across").map(([x]) => x)).toEqual([0, 0.1, 0.2, 0.3]);
  });

  it("go by the right and the top of the one that leads", () => {
    const lying = layer("lying", box(0, 0, [0.2, 0.2], [HALF, HALF]));
    const [one, two] = [layer("one", box(0.4, 0.1)), layer("two", box(0.1, 1))];
    expect(places([lying, one, two], lying, "across")[1]).toEqual([0.4, 0.5]);
  });

  it("are stamps among each other in the texture that they share, by the borders of turned ones", () => {
    const [a, b, c] = [
      layer("a", stamp(0.1, 0.1)),
      layer("b", stamp(0.2, 0.2, [0.1, 0.3], 90)),
      layer("c", stamp(0.9, 0.5)),
    ];
    const apart = layer("x", stamp(0.3, 0.3), 1);
    expect(places([a, b, c, apart, near], a, "across")).toEqual([
      [0.1, 0.1],
      [0.5, 0.2],
      [0.9, 0.5],
      [0.3, 0.3],
      [0.25, 0.1],
    ]);
    expect(places([a, b, c], a, "down")[1]).toEqual([0.2, 0.3]);
  });

  it("leave a sheet of pixels, which covers the whole texture, where it is", () => {
    const sheetOfPixels = layer("pixels", stamp(0.5, 0.5, [1, 1]));
    const stamps = [0.1, 0.3, 0.9].map((u, at) => layer(String(at), stamp(u, 0.2)));
    const [first, second] = stamps as [PlacedLayer, PlacedLayer];
    expect(places([sheetOfPixels, ...stamps], first, "across").map(([u]) => u)).toEqual([0.5, 0.1, 0.5, 0.9]);
    expect(canSpread([sheetOfPixels, first, second])).toBe(false);
  });

  it("are three of a kind at least", () => {
    expect(canSpread([left, near, right])).toBe(true);
    expect(canSpread([left, near, layer("s", stamp(0, 0))])).toBe(false);
    const stamps = [layer("a", stamp(0, 0)), layer("b", stamp(0.2, 0)), layer("c", stamp(0.5, 0), 1)];
    expect(canSpread(stamps)).toBe(false);
    expect(canSpread([...stamps, layer("d", stamp(0.6, 0))])).toBe(true);
    expect(canSpread([layer("l1", label), layer("l2", label), layer("l3", label)])).toBe(false);
    expect(spreadTogether([left, right], left, "across", sheet)).toEqual([left.projector, right.projector]);
    const around = layer("label", label);
    expect(spreadTogether([around, left, near, right], around, "across", sheet)[2]).toBe(near.projector);
  });

  it("are the same objects once they are spread: a second time changes nothing", () => {
    // Whole centimetres: no way is so short that it counts as none.
    const place = fc.integer({ min: -1000, max: 1000 }).map((centimetres) => centimetres / 100);
    const side = fc.integer({ min: 1, max: 200 }).map((centimetres) => centimetres / 100);
    fc.assert(
      fc.property(fc.array(fc.tuple(place, side), { minLength: 3, maxLength: 8 }), (boxes) => {
        const layers = boxes.map(([x, size], at) => layer(String(at), box(x, 0, [size, size])));
        const [first] = layers as [PlacedLayer];
        const once = spreadTogether(layers, first, "across", sheet);
        const spread = layers.map((each, at) => ({ ...each, projector: once[at] as Projector }));
        const middles = once.map((projector) => (projector.kind === "planar" ? projector.position[0] : 0));
        const before = boxes.map(([x]) => x);
        expect([Math.min(...middles), Math.max(...middles)]).toEqual([Math.min(...before), Math.max(...before)]);
        const again = spreadTogether(spread, spread[0] as PlacedLayer, "across", sheet);
        expect(again.every((projector, at) => projector === once[at])).toBe(true);
      }),
      { numRuns: 1000 },
    );
  });
});
