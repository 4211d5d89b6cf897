import { describe, expect, it } from "vitest";
import {
  type DecalLayer,
  type Design,
  emptyDesign,
  findLayer,
  freeIdIn,
  insertAt,
  makeDecalLayer,
  makePaintLayer,
  makeStrokeLayer,
  parseDesign,
  removeById,
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

  it("what lies on the texture never has a mirror, in whatever way it gets there: the saved file is read again", () => {
    const stamp = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 } as const;
    const mirror = { axis: "x", offset: 0, readable: false } as const;
    const flat = makeStrokeLayer({
      id: "flat",
      brush: { tip: "round", color: "#ff0000", hardness: 1, flow: 1 },
      dabs: [{ ...stamp, flow: 1 }],
    });
    const round = makeStrokeLayer({ ...flat, id: "round", dabs: [{ ...PROJECTOR, flow: 1 }] });
    let design: Design = {
      ...designOf("A"),
      layers: [
        ...designOf("A").layers,
        makePaintLayer({ id: "flats", strokes: [flat] }),
        makePaintLayer({ id: "rounds", strokes: [round] }),
      ],
    };
    const decalId = idOf(design, "A");
    for (const id of ["flat", "flats", "rounds", decalId]) design = patchLayer<DecalLayer>(design, id, { mirror });
    const moved = removeById(design, "flat");
    expect(() => insertAt(moved, { parentId: "rounds", list: "strokes", index: 0 }, flat)).toThrow(
      "cannot be mirrored",
    );
    design = patchLayer<DecalLayer>(design, decalId, { projector: stamp });
    expect(parseDesign(serialiseDesign(design), "mirrors.json")).toEqual(design);
    expect(findLayer(design, "rounds")).toMatchObject({ mirror });
    for (const id of ["flat", "flats", decalId]) expect(findLayer(design, id)).toMatchObject({ mirror: null });
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

  it.each(["prototype.png", "constructor", `${"x".repeat(250)}.png`, "\u{1d538}".repeat(700), "?.png"])(
    "make a document that is read again, whatever a file is called: %.24s",
    (name) => {
      let design = emptyDesign();
      for (const asset of [STAR, MOON]) {
        const added = withAsset(design, name, asset);
        design = addOnTop(added.design, decal(added.design, name, added.key));
      }
      const read = parseDesign(serialiseDesign(design));
      expect(Object.values(read.assets)).toEqual([STAR, MOON]);
      expect(new Set(read.layers.map((layer) => layer.name)).size).toBe(2);
    },
  );
});
