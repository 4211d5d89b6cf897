import { describe, expect, it } from "vitest";
import { PenPressure } from "../../web/editor/tools/pen-pressure.ts";
import type { ToolSample } from "../../web/viewer/viewer-api.ts";

const sample = (pressure: number): ToolSample => ({ pressure }) as ToolSample;

/** What a stroke of those pressures paints, by the sample that brought it; what its end brought comes last. */
function strokeOf(pen: PenPressure, ...pressures: number[]): number[][] {
  pen.begin();
  const taken = [...pressures.map((pressure) => pen.take([sample(pressure)])), pen.end()];
  return taken.map((samples) => samples.map(({ pressure }) => pressure));
}

describe("a pen that shows no pressure while it touches", () => {
  it("paints its first stroke in full when that ends, and those after it at once", () => {
    const pen = new PenPressure();
    expect(strokeOf(pen, 0, 0, 0, 0)).toEqual([[], [], [], [], [1, 1, 1, 1]]);
    expect(strokeOf(pen, 0, 0)).toEqual([[1], [1], []]);
  });

  it("need not end a long stroke to be seen", () => {
    const [first, ...rest] = strokeOf(new PenPressure(), ...Array.from({ length: 40 }, () => 0)).toReversed();
    expect(first).toEqual([]);
    expect(rest[0]).toEqual([1]);
    expect(rest.flat()).toHaveLength(40);
  });

  it("prints a point with a tap, by which nothing is settled for the strokes after it", () => {
    const pen = new PenPressure();
    expect(strokeOf(pen, 0)).toEqual([[], [1]]);
    expect(strokeOf(pen, 0, 0.2)).toEqual([[], [0, 0.2], []]);
  });
});

describe("a pen that has pressure", () => {
  it("begins as softly as it says, its first stroke and all others, and ends so too", () => {
    const pen = new PenPressure();
    expect(strokeOf(pen, 0, 0, 0.1, 0.5, 0)).toEqual([[], [], [0, 0, 0.1], [0.5], [0], []]);
    expect(strokeOf(pen, 0, 0.3)).toEqual([[0], [0.3], []]);
    expect(strokeOf(pen, 0, 0, 0, 0, 0), "without any it paints nothing").toEqual([[0], [0], [0], [0], [0], []]);
  });

  it("is heeded after one that has none", () => {
    const pen = new PenPressure();
    strokeOf(pen, 0, 0, 0, 0);
    expect(strokeOf(pen, 0, 0.4, 0)).toEqual([[1], [0.4], [0], []]);
    expect(strokeOf(pen, 0, 0.4)).toEqual([[0], [0.4], []]);
  });
});

it("a mouse paints in full at once, and says nothing of pens", () => {
  const pen = new PenPressure();
  expect(strokeOf(pen, 1, 1)).toEqual([[1], [1], []]);
  expect(strokeOf(pen, 0, 0.5)).toEqual([[], [0, 0.5], []]);
});

it("what a stroke that was given up held back is not painted with the next", () => {
  const pen = new PenPressure();
  pen.take([sample(0), sample(0)]);
  pen.begin();
  expect(pen.end()).toEqual([]);
});
