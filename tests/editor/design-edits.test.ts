import { describe, expect, it } from "vitest";
import {
  type DecalLayer,
  type Design,
  emptyDesign,
  parseDesign,
  serialiseDesign,
} from "../../web/editor/document/index.ts";
import {
  addDecal,
  duplicateLayer,
  moveLayer,
  patchLayer,
  removeLayer,
  withAsset,
} from "../../web/editor/state/design-edits.ts";

const PROJECTOR = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] } as const;
const STAR = { type: "image/png", uri: "data:image/png;base64,U1RBUg==" } as const;
const MOON = { type: "image/png", uri: "data:image/png;base64,TU9PTg==" } as const;

/** Three decals, bottom to top. */
function designOf(...names: string[]): Design {
  let { design, key } = withAsset(emptyDesign(), "star.png", STAR);
  for (const name of names) ({ design } = addDecal(design, { name, material: 0, asset: key, projector: PROJECTOR }));
  return design;
}

const names = (design: Design): string[] => design.layers.map(({ name }) => name);
const idOf = (design: Design, name: string): string => design.layers.find((layer) => layer.name === name)?.id ?? "";

describe("edits of a design", () => {
  it("give designs that the document's own reader accepts", () => {
    const design = duplicateLayer(designOf("Star", "Star"), "layer-1")?.design as Design;
    expect(parseDesign(serialiseDesign(design))).toEqual(design);
    expect(names(design)).toEqual(["Star", "Star 3", "Star 2"]);
  });

  it("share every layer that they do not change", () => {
    const before = designOf("A", "B");
    const after = patchLayer<DecalLayer>(before, idOf(before, "B"), { opacity: 0.5 });
    expect(after.layers[0]).toBe(before.layers[0]);
    expect(after.layers[1]).not.toBe(before.layers[1]);
    expect((before.layers[1] as DecalLayer).opacity).toBe(1);
  });

  it("give the same design when nothing changes", () => {
    const design = designOf("A");
    const id = idOf(design, "A");
    expect(patchLayer<DecalLayer>(design, id, { opacity: 1, angleFade: [70, 90] })).toBe(design);
    expect(moveLayer(design, id, 5)).toBe(design);
    expect(removeLayer(design, "nobody")).toBe(design);
  });

  it("move layers up and down, and no further than the ends", () => {
    const design = designOf("A", "B", "C");
    expect(names(moveLayer(design, idOf(design, "A"), 2))).toEqual(["B", "C", "A"]);
    expect(names(moveLayer(design, idOf(design, "C"), -3))).toEqual(["C", "A", "B"]);
  });

  it("remove a picture with the last layer that uses it", () => {
    const design = designOf("A", "B");
    const one = removeLayer(design, idOf(design, "A"));
    expect(Object.keys(one.assets)).toEqual(["star"]);
    expect(removeLayer(one, idOf(one, "B")).assets).toEqual({});
  });

  it("use one asset for the same picture, and another key for another picture of the same name", () => {
    const first = withAsset(emptyDesign(), "star.png", STAR);
    expect(withAsset(first.design, "again.png", STAR)).toEqual({ design: first.design, key: "star" });
    expect(withAsset(first.design, "star.png", MOON).key).toBe("star-2");
  });

  it("never name an asset after something that every object has", () => {
    const { design, key } = withAsset(emptyDesign(), "__proto__.png", STAR);
    expect(Object.hasOwn(design.assets, key)).toBe(true);
    expect(parseDesign(serialiseDesign(design)).assets[key]).toEqual(STAR);
  });
});
