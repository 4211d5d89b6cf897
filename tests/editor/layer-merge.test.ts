import { afterEach, describe, expect, it } from "vitest";
import {
  type Design,
  emptyDesign,
  findLayer,
  makeFillLayer,
  makePaintLayer,
  makeStrokeLayer,
  type PaintLayer,
  resolveLayers,
  type StrokeLayer,
} from "../../web/editor/document/index.ts";
import { layerBelow, type Merge, mergeDown } from "../../web/editor/state/layer-merge.ts";
import { dab } from "../support/layers.ts";
import { endHosts, paintablePlane } from "../support/painted-plane.ts";

afterEach(endHosts);

const stroke = (id: string, x: number, color: string, fields: Partial<StrokeLayer> = {}): StrokeLayer =>
  makeStrokeLayer({
    id,
    brush: { tip: "round", color, hardness: 0.3, flow: 0.7 },
    dabs: [dab(x, 0, 0.5), dab(x + 0.1, 0.1, 0.5)],
    ...fields,
  });
const paint = (id: string, strokes: readonly StrokeLayer[], fields: Partial<PaintLayer> = {}): PaintLayer =>
  makePaintLayer({ id, strokes, name: id, ...fields });
const ground = makeFillLayer({ id: "ground", color: "#3a6ea5c0" });
const lower = paint("lower", [stroke("a", -0.2, "#ff0000"), stroke("e", -0.1, "#000000", { blend: "erase" })]);
const designOf = (upper: PaintLayer, below: PaintLayer = lower): Design => ({
  ...emptyDesign(),
  layers: [ground, below, upper],
});

/** Hashes of the texture before a merge and after it. */
async function hashes(before: Design): Promise<{ merge: Merge; before: string; after: string }> {
  const merge = mergeDown(before, "upper", "Group") as Merge;
  const { engine } = await paintablePlane();
  engine.setLayers(resolveLayers(before), 1);
  const first = await engine.hash(0);
  engine.setLayers(resolveLayers(merge.design), 2);
  return { merge, before: first, after: await engine.hash(0) };
}

describe("merging down", () => {
  it.each([
    ["sharp", { brush: { tip: "round", color: "#00a000", hardness: 1, flow: 1 } }],
    ["soft", { brush: { tip: "round", color: "#00a000", hardness: 0, flow: 0.37 }, opacity: 0.61 }],
  ] as const)("joins the %s strokes of paint layers and leaves the picture as it was, to the byte", async (_, look) => {
    const upper = paint("upper", [stroke("b", 0, "#00a000", look), stroke("c", 0.1, "#ffff00", look)]);
    const { merge, before, after } = await hashes(designOf(upper));
    expect(merge.obstacle).toBeNull();
    expect(merge.design.layers.map(({ id }) => id)).toEqual(["ground", "lower"]);
    expect((findLayer(merge.design, "lower") as PaintLayer).strokes.map(({ id }) => id)).toEqual(["a", "e", "b", "c"]);
    expect(after).toBe(before);
  });

  it.each([
    ["opacity", { opacity: 0.5 }],
    ["blend", { blend: "multiply" }],
    [
      "mask",
      { mask: { layers: [makeFillLayer({ id: "m", color: "#000000", blend: "erase" })], invert: false, linked: true } },
    ],
    ["lockAlpha", { lockAlpha: true }],
    ["hidden", { visible: false }],
    ["mirror", { mirror: { axis: "x", offset: 0, readable: false } }],
  ] as const)("makes a group of two whose %s stands in the way, with the same picture", async (why, fields) => {
    const { merge, before, after } = await hashes(designOf(paint("upper", [stroke("b", 0, "#00a000")], fields)));
    expect(merge.obstacle).toBe(why);
    expect(findLayer(merge.design, merge.id)).toMatchObject({ type: "group", layers: [lower, { id: "upper" }] });
    expect(after).toBe(before);
  });

  it("keeps an eraser and a blending stroke to their own layer", async () => {
    for (const [blend, why] of [
      ["erase", "erase"],
      ["screen", "blend"],
    ] as const) {
      const { merge, before, after } = await hashes(
        designOf(paint("upper", [stroke("b", 0, "#00a000"), stroke("c", -0.2, "#808080", { blend })])),
      );
      expect(merge.obstacle).toBe(why);
      expect(after).toBe(before);
    }
  });

  it("groups layers of other kinds, and has nothing to do at the bottom", async () => {
    const design = designOf(paint("upper", []));
    expect(mergeDown(design, "lower", "Group")).toMatchObject({ obstacle: "kind" });
    expect(layerBelow(design, "ground")).toBeUndefined();
    expect(mergeDown(design, "ground", "Group")).toBeUndefined();
  });
});
