import { describe, expect, it } from "vitest";
import { letterOf } from "../../web/editor/state/letter-key.ts";

describe("the letter that a key means", () => {
  it.each([
    ["as it is typed, on a Latin layout", "z", "KeyZ", "z"],
    ["without Caps Lock or Shift", "Z", "KeyZ", "z"],
    ["by what it types, where Latin letters have other places", "z", "KeyY", "z"],
    ["by its place, on a Russian layout", "я", "KeyZ", "z"],
    ["by its place, on an Arabic layout whose key has two letters", "لا", "KeyB", "b"],
    ["none, of keys that have no Latin letter's place", "ж", "Semicolon", "semicolon"],
    ["the name of a key that types nothing", "Delete", "Delete", "delete"],
  ])("is %s", (_, key, code, letter) => {
    expect(letterOf({ key, code })).toBe(letter);
  });
});
