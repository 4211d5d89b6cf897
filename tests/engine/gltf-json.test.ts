import { describe, expect, it, vi } from "vitest";
import { listOf } from "../../web/engine/gltf-json.ts";

describe("a glTF file's list", () => {
  it("is checked once, however often it is asked for: each material asks for the list of all", () => {
    const materials = [{ name: "a" }, { name: "b" }];
    const looks = vi.spyOn(materials, "entries");
    for (let asked = 0; asked < 3; asked++) expect(listOf({ materials }, "materials", "x.glb")).toBe(materials);
    expect(looks).toHaveBeenCalledTimes(1);
  });

  it("is refused each time by its first item that is no object", () => {
    const json = { materials: [{}, 7] };
    for (let asked = 0; asked < 2; asked++) {
      expect(() => listOf(json, "materials", "x.glb")).toThrow(/materials\[1\]” is not an object/);
    }
  });
});
