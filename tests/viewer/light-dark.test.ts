import { describe, expect, it } from "vitest";
import { inLight } from "../../web/viewer/light-dark.ts";

describe("a style for a browser without light-dark()", () => {
  it("has the light one of each pair, whatever functions stand in it", () => {
    expect(
      inLight("a { color: var(--c, light-dark(#fff, #000)); --d: light-dark(rgb(1 2 3 / 4%), rgb(5 6 7)); }"),
    ).toBe("a { color: var(--c, #fff); --d: rgb(1 2 3 / 4%); }");
    expect(inLight("a { background: color-mix(in oklab, var(--s), light-dark(white 45%, white 5%)); }")).toBe(
      "a { background: color-mix(in oklab, var(--s), white 45%); }",
    );
  });

  it("stays as it is without one", () => {
    const style = "@media (prefers-color-scheme: dark) { a { color: rgb(1 2 3); } }";
    expect(inLight(style)).toBe(style);
  });
});
