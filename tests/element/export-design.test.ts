import { createHash } from "node:crypto";
import { describe, expect, it } from "vitest";
import { type Design, emptyDesign, makeDecalLayer, makeGroupLayer } from "../../web/editor/document/index.ts";
import { countsOf, DesignExport } from "../../web/element/desk/export-design.ts";

const BYTES = Uint8Array.of(1, 2, 3, 250);
const HASH = createHash("sha256").update(BYTES).digest("hex");
const projector = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 } as const;

const design: Design = {
  ...emptyDesign(),
  assets: {
    logo: { type: "image/png", uri: `data:image/png;base64,${Buffer.from(BYTES).toString("base64")}` },
    face: { type: "font/ttf", uri: "texelcast:fonts/inter-700" },
  },
  layers: [
    makeGroupLayer({ id: "g", layers: [makeDecalLayer({ id: "a", asset: "logo", projector })] }),
    makeDecalLayer({ id: "b", asset: "logo", projector, visible: false }),
  ],
};

describe("a design on its way to a shop", () => {
  it("names its files by what is in them, and brings them along", async () => {
    const { design: named, assets } = await new DesignExport().whole(design);
    expect(assets).toEqual([
      { key: "logo", name: `assets/${HASH}.png`, type: "image/png", bytes: BYTES, sha256: HASH },
    ]);
    expect(named.assets.logo?.uri).toBe(`assets/${HASH}.png`);
    expect(named.assets.face?.uri).toBe("texelcast:fonts/inter-700");
    expect(named.layers).toBe(design.layers);
  });

  it("counts what is seen, in groups too", () => {
    expect(countsOf(design)).toEqual({ decals: 1, texts: 0, layers: 1 });
  });
});
