import { describe, expect, it } from "vitest";
import { FinestLevel } from "../../web/viewer/finest-level.ts";

const rect = (x: number, y: number, width: number, height: number, level = 0) => ({
  ...{ x, y, width, height, level },
  byteOffset: 0,
});

describe("texels that a view at half size does not take", () => {
  it("asks once for a rectangle around all that was left out of the finest level", () => {
    const finest = new FinestLevel();
    expect(finest.toAskFor()).toBeNull();
    finest.leftOut([rect(16, 32, 16, 16), rect(64, 0, 8, 8), rect(500, 500, 9, 9, 1)]);
    expect(finest.isStale).toBe(true);
    expect(finest.toAskFor()).toEqual({ x: 16, y: 0, width: 56, height: 48 });
    expect(finest.toAskFor(), "the answer is on its way").toBeNull();
  });

  it("is whole again once the answer holds everything that is missing", () => {
    const finest = new FinestLevel();
    finest.leftOut([rect(0, 0, 32, 32)]);
    const region = finest.toAskFor();
    finest.answered(region);
    expect(finest.isStale).toBe(false);
    expect(finest.toAskFor()).toBeNull();
  });

  it("asks again where more was left out meanwhile, or the answer did not come", () => {
    const finest = new FinestLevel();
    finest.leftOut([rect(0, 0, 32, 32)]);
    const first = finest.toAskFor();
    finest.leftOut([rect(32, 0, 16, 16)]);
    finest.answered(first);
    expect(finest.isStale).toBe(true);
    expect(finest.toAskFor()).toEqual({ x: 0, y: 0, width: 48, height: 32 });
    finest.answered(null);
    expect(finest.toAskFor()).toEqual({ x: 0, y: 0, width: 48, height: 32 });
  });
});
