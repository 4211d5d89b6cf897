import { describe, expect, it } from "vitest";
import { checkAsset, checkAssetAddress } from "../../web/editor/document/asset-check.ts";
import { encodePng } from "../../web/engine/png-encoder.ts";

const codeOf = (run: () => unknown): string => {
  try {
    run();
  } catch (error) {
    return (error as { code: string }).code;
  }
  return "taken";
};

describe("a design's files", () => {
  it("lie in its own folder", () => {
    for (const uri of ["logo.png", "assets/0f3a.png", "./a/b%20c.png", "data:image/png;base64,AAAA", "a..b.png"]) {
      expect(
        codeOf(() => checkAssetAddress("logo", uri)),
        uri,
      ).toBe("taken");
    }
    const outside = [
      ...["../secret.png", "a/../../b.png", "%2e%2e/b.png", "%252e%252e/b.png", "/etc/passwd", "//evil.example/x.png"],
      ...["https://evil.example/x.png", "javascript:alert(1)", "file:///etc/passwd", "..\\b.png", "a\0.png", "%zz", ""],
    ];
    for (const uri of outside)
      expect(
        codeOf(() => checkAssetAddress("logo", uri)),
        uri,
      ).toBe("outside-folder");
  });

  it("are what the design and their own address say", async () => {
    const png = await encodePng({ width: 1, height: 1, rgba: Uint8Array.of(1, 2, 3, 255) });
    const asset = (type: "image/png" | "image/jpeg" | "font/ttf", uri = "x.png") => ({ type, uri });
    expect(await checkAsset("x", asset("image/png", "data:image/png;base64,"), png)).toEqual(png);
    const page = new TextEncoder().encode("<html><script>alert(1)</script>");
    for (const [code, lies, bytes] of [
      ["bad-design", asset("image/jpeg"), png],
      ["bad-design", asset("image/png", "data:text/html,x"), png],
      ["bad-font", asset("font/ttf"), png],
      ["bad-picture", asset("image/png"), page],
    ] as const) {
      await expect(checkAsset("x", lies, bytes)).rejects.toMatchObject({ code });
    }
  });
});
