import { describe, expect, it } from "vitest";
import { MotionResolution } from "../../web/viewer/motion-resolution.ts";

function scaleAfter(...costs: number[]): number {
  const resolution = new MotionResolution();
  for (const cost of costs) {
    resolution.note(cost);
  }
  return resolution.scale;
}

describe("the resolution of moving pictures", () => {
  it("is full while frames are fast enough to be felt as movement", () => {
    expect(scaleAfter(...Array.from({ length: 100 }, () => 30))).toBe(1);
  });

  it("does not fall for a single slow frame, such as the first with a new shader", () => {
    expect(scaleAfter(900, 14, 14, 900, 14)).toBe(1);
  });

  it("falls step by step while frames stay slow, and no further than to its last step", () => {
    expect(scaleAfter(80, 80)).toBe(0.75);
    expect(scaleAfter(...Array.from({ length: 20 }, () => 300))).toBe(0.55);
  });

  it("rises again when frames have long been fast", () => {
    expect(scaleAfter(80, 80, ...Array.from({ length: 14 }, () => 8))).toBe(1);
    expect(scaleAfter(80, 80, ...Array.from({ length: 13 }, () => 8))).toBe(0.75);
  });

  it("asks for the cost of every frame at first and while a slow one may lead a step down, else of one in three", () => {
    const resolution = new MotionResolution();
    const asked = (): number =>
      Array.from({ length: 30 }, (_, frame) => resolution.asksFor(frame)).filter(Boolean).length;
    expect(asked()).toBe(30);
    resolution.note(8);
    expect(asked()).toBe(10);
    resolution.note(40);
    expect(asked()).toBe(30);
    for (let frame = 0; frame < 8; frame++) resolution.note(300);
    expect(asked()).toBe(10);
  });
});
