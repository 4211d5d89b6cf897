import { describe, expect, it } from "vitest";
import {
  type DecalLayer,
  type Design,
  emptyDesign,
  freeIdIn,
  makeDecalLayer,
  parseDesign,
  serialiseDesign,
} from "../../web/editor/document/index.ts";
import { addOnTop, patchLayer, withAsset } from "../../web/editor/state/design-edits.ts";
import { groupLayers } from "../../web/editor/state/layer-edits.ts";

const PROJECTOR = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] } as const;
const STAR = { type: "image/png", uri: "data:image/png;base64,U1RBUg==" } as const;
const MOON = { type: "image/png", uri: "data:image/png;base64,TU9PTg==" } as const;

/** Decals, bottom to top. */
function designOf(...names: string[]): Design {
  let { design, key } = withAsset(emptyDesign(), "star.png", STAR);
  for (const name of names) design = addOnTop(design, decal(design, name, key));
  return design;
}

const decal = (design: Design, name: string, asset = "star"): DecalLayer =>
  makeDecalLayer({ id: freeIdIn(design), name, asset, projector: PROJECTOR });

const idOf = (design: Design, name: string): string => design.layers.find((layer) => layer.name === name)?.id ?? "";

describe("edits of a design", () => {
  it("share every layer that they do not change", () => {
    const before = designOf("A", "B");
    const after = patchLayer<DecalLayer>(before, idOf(before, "B"), { opacity: 0.5 });
    expect(after.layers[0]).toBe(before.layers[0]);
    expect(after.layers[1]).not.toBe(before.layers[1]);
    expect((before.layers[1] as DecalLayer).opacity).toBe(1);
  });

  it("give the same design when nothing changes, in a group too", () => {
    const design = designOf("A");
    const id = idOf(design, "A");
    expect(patchLayer<DecalLayer>(design, id, { opacity: 1, angleFade: [70, 90] })).toBe(design);
    const grouped = groupLayers(design, [id], { name: "Group" })?.design as Design;
    expect(patchLayer<DecalLayer>(grouped, id, { opacity: 1, angleFade: [70, 90] })).toBe(grouped);
  });

  it("put a new decal on top of all, or of those in a group", () => {
    const design = designOf("A", "B");
    const grouped = groupLayers(design, [idOf(design, "A")], { name: "Group" });
    const layer = decal(design, "C");
    const inside = addOnTop(grouped?.design as Design, layer, grouped?.id);
    expect(inside.layers[0]).toMatchObject({ layers: [{ name: "A" }, { name: "C" }] });
    expect(addOnTop(grouped?.design as Design, layer).layers.at(-1)?.name).toBe("C");
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
