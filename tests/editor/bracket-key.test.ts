import { describe, expect, it } from "vitest";
import { bracketOf } from "../../web/editor/state/bracket-key.ts";

describe("the keys [ and ]", () => {
  it.each([
    ["of an American layout", "[", "BracketLeft", -1],
    ["with Shift, whatever it makes of them", "}", "BracketRight", 1],
    ["of a German layout, on the level of AltGr", "[", "Digit8", -1],
    ["of a German layout, on the level of AltGr", "]", "Digit9", 1],
    ["of a Mac's German layout, on the level of Alt", "]", "Digit6", 1],
    ["by place, where a layout has a letter there", "ü", "BracketLeft", -1],
  ])("%s are those keys: %s", (_, key, code, direction) => {
    expect(bracketOf({ key, code })).toBe(direction);
  });

  it("are not what makes larger, nor what zooms the page, where a layout has plus there", () => {
    expect(bracketOf({ key: "+", code: "BracketRight" })).toBeNull();
  });

  it("are no other keys", () => {
    expect(bracketOf({ key: "8", code: "Digit8" })).toBeNull();
  });
});
