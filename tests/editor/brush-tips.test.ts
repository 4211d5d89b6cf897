import { describe, expect, it } from "vitest";
import { emptyDesign, makeDecalLayer, makePaintLayer, makeStrokeLayer } from "../../web/editor/document/index.ts";
import { tipsOf } from "../../web/editor/tools/brush-tips.ts";

const PROJECTOR = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] } as const;
const WHOLE = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 } as const;
const picture = (name: string) => ({ type: "image/png", uri: `data:image/png;base64,${name}` }) as const;
const stroke = (id: string, asset: string) =>
  makeStrokeLayer({ id, brush: { tip: "picture", asset, color: null, flow: 1 }, dabs: [{ ...PROJECTOR, flow: 1 }] });

describe("the pictures that a brush may print", () => {
  it("are the design's own, used or not, without fonts and without what pixel and clone tools made", () => {
    const shown = { ...stroke("path", "stamp"), blend: "erase" } as const;
    const design = {
      ...emptyDesign(),
      assets: {
        star: picture("star"),
        unused: picture("unused"),
        stamp: picture("stamp"),
        pixels: picture("pixels"),
        copy: picture("copy"),
        font: { type: "font/ttf", uri: "texelcast:fonts/inter-700" },
      } as const,
      layers: [
        makeDecalLayer({ id: "a", asset: "star", projector: PROJECTOR }),
        makeDecalLayer({ id: "b", asset: "pixels", projector: WHOLE, filter: "nearest" }),
        makeDecalLayer({
          id: "c",
          asset: "copy",
          projector: PROJECTOR,
          mask: { layers: [shown], invert: true, linked: true },
        }),
        makePaintLayer({ id: "d", strokes: [stroke("e", "stamp")] }),
      ],
    };
    expect(tipsOf(design).map(({ name }) => name)).toEqual(["star", "unused", "stamp"]);
  });

  it("a picture that is a decal of its own besides is one of them", () => {
    const design = {
      ...emptyDesign(),
      assets: { pixels: picture("pixels") },
      layers: [
        makeDecalLayer({ id: "b", asset: "pixels", projector: WHOLE, filter: "nearest" }),
        makeDecalLayer({ id: "a", asset: "pixels", projector: PROJECTOR }),
      ],
    };
    expect(tipsOf(design)).toHaveLength(1);
  });

  it("is called as its lowest layer is, where one shows it, and else by the design's own key", () => {
    const layers = [
      makeDecalLayer({ id: "a", asset: "mark", projector: PROJECTOR, name: "Texelcast mark" }),
      makeDecalLayer({ id: "b", asset: "mark", projector: PROJECTOR, name: "Another" }),
    ];
    const design = { ...emptyDesign(), assets: { mark: picture("mark"), unused: picture("unused") }, layers };
    expect(tipsOf(design).map(({ name }) => name)).toEqual(["Texelcast mark", "unused"]);
  });
});
