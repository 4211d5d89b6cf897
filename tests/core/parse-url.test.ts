import { describe, expect, it } from "vitest";
import { parseUrl } from "../../web/core/parse-url.ts";

describe("an address", () => {
  it("is read whole, or beside another one", () => {
    expect(parseUrl("https://shop.example/mug.glb")?.origin).toBe("https://shop.example");
    expect(parseUrl("mug.glb", "https://shop.example/a/b.html")?.href).toBe("https://shop.example/a/mug.glb");
  });

  it("that is none is null", () => {
    expect(parseUrl("mug.glb")).toBeNull();
    expect(parseUrl("https://", "https://shop.example/")).toBeNull();
  });
});
