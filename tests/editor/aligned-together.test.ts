import { describe, expect, it } from "vitest";
import type { PlacedLayer } from "../../web/editor/document/index.ts";
import { alignedTogether, canAlign, type LineOfLayers } from "../../web/editor/state/aligned-together.ts";
import { box, HALF, label, layer, placesOf, sheet, stamp } from "../support/pictures-on-a-sheet.ts";

const places = (layers: readonly PlacedLayer[], first: PlacedLayer, line: LineOfLayers): number[][] =>
  placesOf(alignedTogether(layers, first, line, sheet));

describe("several pictures that are brought into line", () => {
  const [a, b] = [layer("a", box(0.1, 0.5)), layer("b", box(0.3, -0.2))];

  it("come under one another, or beside one another, by the middle of the one that stays", () => {
    expect(places([a, b], a, "column")).toEqual([
      [0.1, 0.5],
      [0.1, -0.2],
    ]);
    expect(places([a, b], b, "row")).toEqual([
      [0.1, -0.2],
      [0.3, -0.2],
    ]);
  });

  it("go by that one's own right and top where it is turned", () => {
    const lying = layer("lying", box(0.1, 0.5, [0.2, 0.2], [HALF, HALF]));
    expect(places([lying, b], lying, "column")[1]).toEqual([0.3, 0.5]);
  });

  it("are stamps among each other in the texture that they share, and boxes among boxes", () => {
    const [one, two, apart] = [
      layer("one", stamp(0.2, 0.3)),
      layer("two", stamp(0.6, 0.7)),
      layer("x", stamp(0.6, 0.7), 1),
    ];
    expect(places([one, two, apart, b], one, "column")).toEqual([
      [0.2, 0.3],
      [0.2, 0.7],
      [0.6, 0.7],
      [0.3, -0.2],
    ]);
    expect(places([one, two], one, "row")).toEqual([
      [0.2, 0.3],
      [0.6, 0.3],
    ]);
    const around = layer("label", label);
    expect(alignedTogether([around, a], around, "column", sheet)).toEqual([label, a.projector]);
  });

  it("stay what they are where they are in line already", () => {
    const under = layer("under", box(0.1, -0.4));
    expect(alignedTogether([a, under], a, "column", sheet)[1]).toBe(under.projector);
    const [one, level] = [layer("one", stamp(0.2, 0.3)), layer("level", stamp(0.7, 0.3))];
    expect(alignedTogether([one, level], one, "row", sheet)[1]).toBe(level.projector);
    expect(alignedTogether([one, level], one, "column", sheet)[1]).not.toBe(level.projector);
  });

  it("leave a sheet of pixels, which covers the whole texture, where it is", () => {
    const [sheetOfPixels, one, two] = [
      layer("pixels", stamp(0.5, 0.5, [1, 1])),
      layer("one", stamp(0.2, 0.3)),
      layer("two", stamp(0.7, 0.6)),
    ];
    expect(places([sheetOfPixels, one, two], one, "column")).toEqual([
      [0.5, 0.5],
      [0.2, 0.3],
      [0.2, 0.6],
    ]);
    expect(places([sheetOfPixels, one], sheetOfPixels, "row")[1]).toEqual([0.2, 0.3]);
    expect(canAlign([sheetOfPixels, one])).toBe(false);
  });

  it("are two of a kind at least", () => {
    expect(canAlign([a, b])).toBe(true);
    expect(canAlign([a, layer("one", stamp(0.2, 0.3))])).toBe(false);
    expect(canAlign([layer("one", stamp(0.2, 0.3)), layer("two", stamp(0.6, 0.7))])).toBe(true);
    expect(canAlign([layer("one", stamp(0.2, 0.3)), layer("two", stamp(0.6, 0.7), 1)])).toBe(false);
    expect(canAlign([layer("label", label), layer("other", label)])).toBe(false);
  });
});
