import { describe, expect, it } from "vitest";
import {
  type Design,
  type DesignLayer,
  emptyDesign,
  findLayer,
  layerIds,
  makeDecalLayer,
  makeFillLayer,
  makeGroupLayer,
  makePaintLayer,
  makeStrokeLayer,
  parseDesign,
  serialiseDesign,
} from "../../web/editor/document/index.ts";
import { isLocked } from "../../web/editor/document/layer-tree.ts";
import { clipOf, putClip } from "../../web/editor/state/layer-clip.ts";
import {
  addMask,
  duplicateLayers,
  groupLayers,
  insertAbove,
  invertMask,
  moveLayers,
  removeLayers,
  removeMask,
  stepLayers,
} from "../../web/editor/state/layer-edits.ts";
import { ungroupLayers } from "../../web/editor/state/layer-ungroup.ts";

const fill = (id: string): DesignLayer => makeFillLayer({ id, name: id, color: "#ff0000" });
const group = (id: string, ...layers: DesignLayer[]): DesignLayer => makeGroupLayer({ id, name: id, layers });
const designOf = (...layers: DesignLayer[]): Design => ({ ...emptyDesign(), layers });

/** Ids, bottom to top: "a g(b c) d". */
function shape(design: Pick<Design, "layers">): string {
  return design.layers.map((layer) => (layer.type === "group" ? `${layer.id}(${shape(layer)})` : layer.id)).join(" ");
}

const NONE: ReadonlySet<string> = new Set();

describe("moving layers", () => {
  const design = designOf(fill("a"), group("g", fill("b"), fill("c")), fill("d"));

  it("puts them into a group, out of it, and past each other", () => {
    expect(shape(moveLayers(design, ["a"], { parentId: "g", index: 1 }))).toBe("g(b a c) d");
    expect(shape(moveLayers(design, ["b"], { parentId: null, index: 3 }))).toBe("a g(c) d b");
    expect(shape(moveLayers(design, ["a"], { parentId: null, index: 3 }))).toBe("g(b c) d a");
    expect(shape(moveLayers(design, ["d"], { parentId: null, index: 0 }))).toBe("d a g(b c)");
  });

  it("brings several together in their order, wherever they lay", () => {
    expect(shape(moveLayers(design, ["d", "b", "a"], { parentId: null, index: 2 }))).toBe("g(c) a b d");
  });

  it("moves what a chosen group holds along with the group", () => {
    expect(shape(moveLayers(design, ["g", "b"], { parentId: null, index: 0 }))).toBe("g(b c) a d");
  });

  it("changes nothing where they already lie, and never puts a group into itself", () => {
    expect(moveLayers(design, ["a"], { parentId: null, index: 1 })).toBe(design);
    expect(moveLayers(design, ["b", "c"], { parentId: "g", index: 1 })).toBe(design);
    expect(moveLayers(design, ["g"], { parentId: "g", index: 0 })).toBe(design);
  });
});

describe("a step in the list", () => {
  const design = designOf(fill("a"), group("g", fill("b"), fill("c")), fill("d"));

  it("goes into an open group at the end that it comes to, and out at the other", () => {
    const shapes: string[] = [];
    let now = design;
    for (let step = 0; step < 5; step += 1) {
      now = stepLayers(now, ["a"], 1, NONE);
      shapes.push(shape(now));
    }
    expect(shapes).toEqual(["g(a b c) d", "g(b a c) d", "g(b c a) d", "g(b c) a d", "g(b c) d a"]);
    for (const before of ["g(b c) a d", "g(b c a) d", "g(b a c) d", "g(a b c) d", "a g(b c) d"]) {
      now = stepLayers(now, ["a"], -1, NONE);
      expect(shape(now)).toBe(before);
    }
    expect(stepLayers(now, ["a"], -1, NONE), "at the end it stays").toBe(now);
  });

  it("passes by a closed group", () => {
    expect(shape(stepLayers(design, ["a"], 1, new Set(["g"])))).toBe("g(b c) a d");
  });

  it("takes several chosen layers as one", () => {
    const flat = designOf(fill("a"), fill("b"), fill("c"), fill("d"));
    expect(shape(stepLayers(flat, ["a", "b"], 1, NONE))).toBe("c a b d");
    expect(shape(stepLayers(flat, ["a", "c"], 1, NONE))).toBe("b d a c");
  });
});

describe("groups", () => {
  it("take the place of the topmost of their layers, and give it back", () => {
    const design = designOf(fill("a"), fill("b"), fill("c"), fill("d"));
    const made = groupLayers(design, ["c", "a"], { name: "Group" });
    expect(shape(made?.design as Design)).toBe(`b ${made?.id}(a c) d`);
    const back = ungroupLayers(made?.design as Design, [made?.id as string]);
    expect(shape(back.design)).toBe("b a c d");
    expect(back.ids).toEqual(["a", "c"]);
  });

  it("are made within a group", () => {
    const made = groupLayers(designOf(group("g", fill("a"), fill("b"))), ["b"], { name: "Group" });
    expect(shape(made?.design as Design)).toBe(`g(a ${made?.id}(b))`);
  });

  it("keep their layers hidden when a hidden one is dissolved", () => {
    const hidden = { ...group("g", fill("a")), visible: false } as DesignLayer;
    expect(ungroupLayers(designOf(hidden), ["g"]).design.layers[0]).toMatchObject({ id: "a", visible: false });
  });

  it("lock what they hold", () => {
    const design = designOf({ ...group("g", group("h", fill("a"))), locked: true } as DesignLayer, fill("b"));
    expect([isLocked(design, "a"), isLocked(design, "b")]).toEqual([true, false]);
  });

  it("take new layers while they are selected; other layers have them above themselves", () => {
    const design = designOf(fill("a"), group("g", fill("b")), fill("c"));
    const make = (id: string): DesignLayer => makeFillLayer({ id, color: "#000000" });
    expect(shape(insertAbove(design, "g", make).design)).toBe("a g(b layer-5) c");
    expect(shape(insertAbove(design, "a", make).design)).toBe("a layer-5 g(b) c");
    expect(shape(insertAbove(design, null, make).design)).toBe("a g(b) c layer-5");
  });
});

describe("copies", () => {
  it("have ids of their own, down to strokes and masks, and are put above their originals", () => {
    const brush = { tip: "round", color: "#000000", hardness: 1, flow: 1 } as const;
    const paint = makePaintLayer({ id: "p", name: "p", strokes: [makeStrokeLayer({ id: "s", brush, dabs: [] })] });
    const masked = addMask(designOf(group("g", paint), fill("a")), "p", true);
    const { design, ids } = duplicateLayers(masked, ["g", "a"]);
    expect(design.layers).toHaveLength(4);
    expect(ids).toEqual([design.layers[1]?.id, design.layers[3]?.id]);
    const all = parseDesign(serialiseDesign(design));
    expect(layerIds(all).size, "parsing refuses ids that are there twice").toBe(10);
    expect(design.layers.map(({ name }) => name)).toEqual(["g", "g 2", "a", "a 2"]);
  });
});

describe("taking layers out", () => {
  it("takes the pictures that nothing uses any more, from a group's depths too", () => {
    const projector = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 } as const;
    const decal = (id: string, asset: string): DesignLayer => makeDecalLayer({ id, asset, projector });
    const assets = { star: { type: "image/png", uri: "data:," }, moon: { type: "image/png", uri: "data:,x" } } as const;
    const design = { ...designOf(group("g", decal("a", "star"), decal("b", "moon")), decal("c", "star")), assets };
    const left = removeLayers(design, ["g", "a"]);
    expect(shape(left)).toBe("c");
    expect(Object.keys(left.assets)).toEqual(["star"]);
    expect(removeLayers(design, ["nobody"])).toBe(design);
  });
});

describe("masks", () => {
  it("begin with all shown or all hidden, are inverted, and go", () => {
    const design = designOf(fill("a"));
    const shows = addMask(design, "a", false);
    expect(findLayer(shows, "a")?.mask).toEqual({ layers: [], invert: false, linked: true });
    const hides = addMask(design, "a", true);
    expect(findLayer(hides, "a")?.mask).toMatchObject({ layers: [{ type: "fill", blend: "erase" }], invert: false });
    expect(findLayer(invertMask(hides, "a"), "a")?.mask?.invert).toBe(true);
    expect(removeMask(hides, "a")).toEqual(design);
    expect(addMask(hides, "a", false), "a mask that is there stays").toBe(hides);
  });
});

describe("very many chosen layers", () => {
  /** How often an edit of all of so many layers asks what one of them holds, as every walk of the tree does. */
  function looks(count: number, edit: (design: Design, ids: string[]) => unknown): number {
    let asked = 0;
    const layers = Array.from({ length: count }, (_, k) =>
      Object.defineProperty(fill(`l${k}`), "mask", {
        enumerable: true,
        get: () => {
          asked += 1;
          return null;
        },
      }),
    );
    edit(
      designOf(fill("below"), ...layers, group("g")),
      layers.map(({ id }) => id),
    );
    return asked / count;
  }

  it.each<[string, (design: Design, ids: string[]) => unknown]>([
    ["copied beside themselves", (design, ids) => duplicateLayers(design, ids)],
    ["put into a group", (design, ids) => moveLayers(design, ids, { parentId: "g", index: 0 })],
    ["made a group", (design, ids) => groupLayers(design, ids, { name: "Group" })],
    ["pasted", (design, ids) => putClip(design, clipOf(design, ids), null)],
    [
      "taken out of their group",
      (design, ids) => ungroupLayers(groupLayers(design, ids, { name: "Group" })?.design as Design, ["layer-203"]),
    ],
  ])("are not walked once for each when they are %s", (_, edit) => {
    expect(looks(200, edit)).toBeLessThan(25);
  });

  it("each have a copy with a name and an id of its own, right above them", () => {
    const twins = designOf(...["a", "b", "c"].map((id) => ({ ...fill(id), name: "Star" }) as DesignLayer), group("g"));
    const made = duplicateLayers(twins, ["c", "a", "g"]);
    expect(made.design.layers.map(({ id, name }) => `${id} ${name}`)).toEqual([
      "a Star",
      "layer-5 Star 2",
      "b Star",
      "c Star",
      "layer-6 Star 3",
      "g g",
      "layer-7 g 2",
    ]);
    expect(made.ids).toEqual(["layer-5", "layer-6", "layer-7"]);
  });
});
