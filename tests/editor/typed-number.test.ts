import { describe, expect, it } from "vitest";
import { typedNumber } from "../../web/editor/ui/typed-number.ts";

describe("a number that is typed", () => {
  it("may have the unit after it that its field shows", () => {
    expect(typedNumber("10%", "%")).toBe(10);
    expect(typedNumber(" 12,5 MM ", "mm")).toBe(12.5);
    expect(typedNumber("−45 °", "°")).toBe(-45);
    expect(typedNumber("3", "px")).toBe(3);
  });

  it("is none with another unit, or without digits", () => {
    for (const text of ["12 mm", "mm", "", "a lot"]) expect(typedNumber(text, "%")).toBeUndefined();
    expect(typedNumber("%", "%")).toBeUndefined();
    expect(typedNumber("10%", "")).toBeUndefined();
  });
});
