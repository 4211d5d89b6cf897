import { describe, expect, it } from "vitest";
import { typedNumber } from "../../web/editor/ui/typed-number.ts";

describe("a number that is typed", () => {
  it("may have the unit after it that its field shows", () => {
    expect(typedNumber("10%", "%")).toBe(10);
    expect(typedNumber(" 12,5 MM ", "mm")).toBe(12.5);
    expect(typedNumber("−45 °", "°")).toBe(-45);
    expect(typedNumber("3", "px")).toBe(3);
  });

  it("is converted where it is a length in another unit than its field's", () => {
    expect(typedNumber("3 cm", "mm")).toBeCloseTo(30, 9);
    expect(typedNumber("-1,2m", "cm")).toBeCloseTo(-120, 9);
    expect(typedNumber("2 in", "mm")).toBeCloseTo(50.8, 9);
    expect(typedNumber("5e1 mm", "m")).toBeCloseTo(0.05, 9);
  });

  it("may have its thousands apart as the page's language has them, or the other one where that can mean nothing else", () => {
    for (const [text, english, german] of [
      ["1,000", 1000, 1],
      ["1.000", 1, 1000],
      ["-12,500 mm", -12500, -12.5],
      ["1,234,567", 1234567, 1234567],
      ["1.234.567", 1234567, 1234567],
      ["1,234.5", 1234.5, 1234.5],
      ["1.234,5", 1234.5, 1234.5],
    ] as const) {
      expect(typedNumber(text, "mm"), text).toBe(english);
      expect(typedNumber(text, "mm", ","), text).toBe(german);
    }
  });

  it("may have a comma or a point before its decimals, in both languages, where no thousands could be meant", () => {
    for (const text of ["0,125", "0.125"]) {
      expect(typedNumber(text, "mm"), text).toBe(0.125);
      expect(typedNumber(text, "mm", ","), text).toBe(0.125);
    }
    for (const [text, value] of [
      ["12,5", 12.5],
      ["12.5", 12.5],
      ["1,25", 1.25],
      ["1.0000", 1],
      ["1234,567", 1234.567],
      ["1234.567", 1234.567],
      [",5", 0.5],
      [".5", 0.5],
    ] as const) {
      expect(typedNumber(text, "mm"), text).toBe(value);
      expect(typedNumber(text, "mm", ","), text).toBe(value);
    }
  });

  it("may be a sum, a product or a part, with brackets, and with units beside its numbers or behind the whole", () => {
    for (const [text, value] of [
      ["10/2", 5],
      ["10+2*3", 16],
      ["(10 + 2) × 3", 36],
      ["-(1,5 − 4)", 2.5],
      ["100 - 25 - 25", 50],
      ["12 ÷ 4 ÷ 3", 1],
      ["5 * -2", -10],
      ["10/2 cm", 50],
      ["3 cm + 5 mm", 35],
      ["3 cm + 5", 35],
      ["(1 + 2) cm", 30],
      ["2e1/4", 5],
    ] as const) {
      expect(typedNumber(text, "mm"), text).toBeCloseTo(value, 9);
    }
    expect(typedNumber("100% / 3", "%")).toBeCloseTo(33.333, 3);
    expect(typedNumber("1.000/4", "mm", ",")).toBe(250);
  });

  it("is none where a sum is not whole, or what it says is no length", () => {
    for (const text of ["10/", "*2", "1/0", "0/0", "(1+2", "1+2)", "()", "2 cm * 3 cm", "1 2", "(1 cm + 2) cm"]) {
      expect(typedNumber(text, "mm"), text).toBeUndefined();
    }
    expect(typedNumber(`1${"+1".repeat(100)}`, "mm"), "longer than is typed").toBeUndefined();
    expect(typedNumber("(".repeat(100_000), "mm")).toBeUndefined();
  });

  it("is none with a unit that is none of its field's, or without digits, or beyond all numbers", () => {
    for (const text of ["12 mm", "mm", "", "a lot", "12 mm 3"]) expect(typedNumber(text, "%")).toBeUndefined();
    expect(typedNumber("%", "%")).toBeUndefined();
    expect(typedNumber("10%", "")).toBeUndefined();
    for (const text of [
      "10°",
      "3 ft",
      "3 constructor",
      "1e400",
      "-1e400",
      "-",
      "1.2.3",
      "1,00,000",
      "1.000,000,0",
      "0x10",
      "--5",
      "5-",
    ])
      expect(typedNumber(text, "mm")).toBeUndefined();
  });
});
