import { describe, expect, it } from "vitest";
import { parseCssColor } from "../../web/viewer/css-color.ts";

describe("a computed CSS colour", () => {
  it.each([
    ["rgb(255, 0, 51)", [1, 0, 0.2, 1]],
    ["rgba(0, 255, 0, 0.5)", [0, 1, 0, 0.5]],
    ["rgb(51 102 255 / 25%)", [0.2, 0.4, 1, 0.25]],
    ["color(srgb 0.25 0.5 1 / 0.75)", [0.25, 0.5, 1, 0.75]],
    ["color(srgb 1e-3 0 0)", [0.001, 0, 0, 1]],
  ])("%s is read", (text, expected) => {
    const color = parseCssColor(text);
    expect(color).toHaveLength(4);
    for (const [channel, value] of expected.entries()) {
      expect(color?.[channel]).toBeCloseTo(value, 9);
    }
  });

  it.each(["red", "oklch(0.5 0.1 20)", "color(display-p3 1 0 0)", ""])("%j is none that is read", (text) => {
    expect(parseCssColor(text)).toBeNull();
  });
});
