import { describe, expect, it } from "vitest";
import {
  type DecalLayer,
  type Design,
  type DesignLayer,
  emptyDesign,
  makeDecalLayer,
  makeFillLayer,
  makeGroupLayer,
  makePaintLayer,
  makeStrokeLayer,
} from "../../web/editor/document/index.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { addMaskPixels, maskPixelLayer, masksMaterial, pixelLayerFor } from "../../web/editor/tools/pixel-layer.ts";

const whole = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 } as const;
const pixels = (id: string, changes: Partial<DecalLayer> = {}): DecalLayer =>
  makeDecalLayer({ id, asset: id, projector: whole, filter: "nearest", ...changes });
const stroke = makeStrokeLayer({
  id: "stroke",
  brush: { tip: "round", color: "#000000", hardness: 1, flow: 1 },
  dabs: [],
});
const designOf = (...layers: DesignLayer[]): Design => ({ ...emptyDesign(), layers });
const png = { type: "image/png", uri: "data:image/png;base64,AA==" } as const;

describe("texels that are drawn on a mask", () => {
  it.each([
    [false, "normal", "erase"],
    [true, "erase", "normal"],
  ] as const)("show by the pencil and hide by the eraser (inverted: %s)", (invert, shows, hides) => {
    const design = designOf(makeFillLayer({ id: "fill", color: "#ff0000", mask: { layers: [stroke], invert } }));
    const drawn = (eraser: boolean) =>
      addMaskPixels(design, { layerId: "fill", hides: eraser }, 3, png, stringsIn("en"))?.layers[0]?.mask?.layers;
    const layer = { type: "decal", projector: whole, filter: "nearest", material: 3 };
    expect(drawn(false)).toMatchObject([{ id: "stroke" }, { ...layer, blend: shows }]);
    expect(drawn(true)).toMatchObject([{ id: "stroke" }, { ...layer, blend: hides }]);
  });

  it("join those drawn before, but not below what hides and shows otherwise", () => {
    const [below, above, other] = [pixels("below"), pixels("above"), pixels("other", { material: 1 })];
    const top = (...layers: (DecalLayer | typeof stroke)[]) => maskPixelLayer({ layers, invert: false }, false, 0)?.id;
    expect(top(below, above)).toBe("above");
    expect(top(below, other)).toBe("below");
    expect(top(below, stroke)).toBeUndefined();
    expect(top(below, pixels("eraser", { blend: "erase" }))).toBeUndefined();
    expect(top(pixels("faint", { opacity: 0.5 }))).toBeUndefined();
    expect(maskPixelLayer({ layers: [pixels("eraser", { blend: "erase" })], invert: false }, true, 0)?.id).toBe(
      "eraser",
    );
  });

  it("go nowhere where the layer or its mask has gone meanwhile", () => {
    const design = designOf(makeFillLayer({ id: "fill", color: "#ff0000" }));
    for (const layerId of ["fill", "gone"]) {
      expect(addMaskPixels(design, { layerId, hides: true }, 0, png, stringsIn("en"))).toBeNull();
    }
  });

  it("count on the materials that the layer paints, those of a group's layers too; on all where it paints none yet", () => {
    const fill = makeFillLayer({ id: "fill", color: "#ff0000", material: [1, 2] });
    expect([0, 1, 2].filter((material) => masksMaterial(fill, material))).toEqual([1, 2]);
    const group = makeGroupLayer({ id: "group", layers: [fill] });
    expect([0, 1, 2].filter((material) => masksMaterial(group, material))).toEqual([1, 2]);
    expect(masksMaterial(makePaintLayer({ id: "paint", strokes: [] }), 0)).toBe(true);
  });
});

it("pixels are not drawn on a layer in a locked group unless that is chosen, which is told then", () => {
  const design = designOf(pixels("free"), makeGroupLayer({ id: "group", layers: [pixels("inside")], locked: true }));
  expect(pixelLayerFor(design, null, 0)?.id).toBe("free");
  expect(pixelLayerFor(design, "inside", 0)?.id).toBe("inside");
});
