import { describe, expect, it } from "vitest";
import { decodeDataUri, encodeDataUri } from "../../web/editor/document/data-uri.ts";
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
import { OpenWork } from "../../web/editor/state/open-work.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { CLEAR } from "../../web/editor/tools/pixel-canvas.ts";
import { addMaskPixels, maskPixelLayer, masksMaterial, pixelLayerFor } from "../../web/editor/tools/pixel-layer.ts";
import { PixelSession } from "../../web/editor/tools/pixel-session.ts";
import type { ToolContext } from "../../web/editor/tools/tool-context.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";

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

/** Of tools that work on a design of 2 by 2 texels. */
function contextOf(design: Design): { readonly context: ToolContext; readonly design: () => Design } {
  const work = new OpenWork();
  const session = {
    recordedDesign: design,
    record: (next: Design) => Object.assign(session, { recordedDesign: next }),
    preview: () => undefined,
    cancelPreview: () => undefined,
    recordsLater: (each: Promise<unknown>) => work.add(each),
    settled: () => work.settled(),
  };
  const asset = (_: unknown, bytes: Uint8Array) => ({
    asset: { type: "image/png", uri: encodeDataUri("image/png", bytes) },
  });
  const targets = new Map([[0, { width: 2, height: 2 }]]);
  const context = {
    session,
    library: { add: asset, release: () => undefined, setLive: () => undefined, get: () => undefined },
    store: { state: { selectedId: null, editingMask: "fill", targets, model: null } },
    tools: { settings: { alphaLock: false } },
    board: {
      strings: stringsIn("en"),
      info: () => undefined,
      error: (_: string, thrown: unknown) => expect(thrown).toBe("no fault"),
    },
  } as unknown as ToolContext;
  return { context, design: () => session.recordedDesign };
}

describe("texels that are drawn on a mask", () => {
  it.each([
    [false, "normal", "erase"],
    [true, "erase", "normal"],
  ] as const)("show by the pencil and hide by the eraser (inverted: %s)", (invert, shows, hides) => {
    const design = designOf(
      makeFillLayer({ id: "fill", color: "#ff0000", mask: { layers: [stroke], invert, linked: true } }),
    );
    const drawn = (eraser: boolean) =>
      addMaskPixels(design, { layerId: "fill", hides: eraser }, 3, png, stringsIn("en"))?.layers[0]?.mask?.layers;
    const layer = { type: "decal", projector: whole, filter: "nearest", material: 3 };
    expect(drawn(false)).toMatchObject([{ id: "stroke" }, { ...layer, blend: shows }]);
    expect(drawn(true)).toMatchObject([{ id: "stroke" }, { ...layer, blend: hides }]);
  });

  it("join those drawn before, but not below what hides and shows otherwise", () => {
    const [below, above, other] = [pixels("below"), pixels("above"), pixels("other", { material: 1 })];
    const top = (...layers: (DecalLayer | typeof stroke)[]) =>
      maskPixelLayer({ layers, invert: false, linked: true }, false, 0)?.layer.id;
    expect(top(below, above)).toBe("above");
    expect(top(below, other)).toBe("below");
    expect(top(below, stroke)).toBeUndefined();
    expect(top(pixels("faint", { opacity: 0.5 }))).toBeUndefined();
    expect(
      maskPixelLayer({ layers: [pixels("eraser", { blend: "erase" })], invert: false, linked: true }, true, 0)?.layer
        .id,
    ).toBe("eraser");
  });

  it("join those drawn before by the other tool's one layer of the same texels, in which they give way", () => {
    const eraser = pixels("eraser", { blend: "erase" });
    const found = (layers: DecalLayer[], hides = true) => {
      const { layer, over } = maskPixelLayer({ layers, invert: false, linked: true }, hides, 0) ?? {};
      return layer && [layer.id, over?.id ?? null];
    };
    expect(found([eraser, pixels("pencil")])).toEqual(["eraser", "pencil"]);
    expect(found([eraser, pixels("pencil")], false)).toEqual(["pencil", null]);
    expect(found([pixels("pencil"), eraser], false)).toEqual(["pencil", "eraser"]);
    expect(found([eraser, pixels("other", { material: 1 }), pixels("pencil")])).toEqual(["eraser", "pencil"]);
    expect(found([eraser, pixels("both", { material: [0, 1] })]), "others would lose texels").toBeUndefined();
    expect(found([eraser, pixels("locked", { locked: true })])).toBeUndefined();
    expect(found([eraser, pixels("first"), pixels("second")])).toBeUndefined();
  });

  it("are shown or hidden by what was drawn last, in one layer of each, however often they are drawn in turn", async () => {
    const fill = makeFillLayer({ id: "fill", color: "#ff0000", mask: { layers: [], invert: false, linked: true } });
    const { context, design } = contextOf(designOf(fill));
    const session = new PixelSession(context);
    const drawn = async (hides: boolean, ...places: [number, number][]): Promise<void> => {
      const gesture = session.begin(0, { layerId: "fill", hides });
      gesture?.draw(0, (canvas) => {
        for (const [x, y] of places) canvas.set(x, y, gesture.ink ?? CLEAR);
      });
      if (gesture) session.finish(gesture, "pencil", () => undefined);
      await context.session.settled();
    };
    const top = [
      [0, 0],
      [1, 0],
    ] as [number, number][];
    await drawn(true, ...top, [0, 1]);
    await drawn(false, ...top);
    await drawn(true, [0, 0]);
    await drawn(false, [0, 1]);
    await drawn(true, [1, 1]);
    const layers = design().layers[0]?.mask?.layers as DecalLayer[];
    expect(layers.map(({ blend }) => blend)).toEqual(["erase", "normal"]);
    const shown = [255, 255, 255, 255];
    for (const { asset, blend } of layers) {
      const { rgba } = await decodePicture(decodeDataUri(design().assets[asset]?.uri ?? "", asset), asset);
      for (const texel of shown.keys()) {
        const alpha = rgba[texel * 4 + 3] as number;
        if (alpha > 0) shown[texel] = blend === "erase" ? 255 - alpha : alpha;
      }
    }
    expect(shown).toEqual([0, 255, 255, 0]);
    expect(Object.keys(design().assets), "no picture is left over").toHaveLength(2);
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
