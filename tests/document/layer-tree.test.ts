import { describe, expect, it } from "vitest";
import { DESIGN_LIMITS } from "../../web/editor/document/design-limits.ts";
import {
  type Design,
  type DesignLayer,
  emptyDesign,
  findLayer,
  flattenLayers,
  freeIdIn,
  freeIdsIn,
  insertAt,
  layerDepth,
  layerIds,
  makeFillLayer,
  makeGroupLayer,
  makePaintLayer,
  makeStrokeLayer,
  mapLayer,
  materialsIn,
  parseDesign,
  removeById,
  walkLayers,
  withIds,
} from "../../web/editor/document/index.ts";
import { isLocked, mapLayers, removeByIds } from "../../web/editor/document/layer-tree.ts";
import { addMask, duplicateLayers, moveLayers } from "../../web/editor/state/layer-edits.ts";

const fill = (id: string, material = 0) => makeFillLayer({ id, color: "#102030", material });
const stroke = (id: string) =>
  makeStrokeLayer({ id, brush: { tip: "round", color: "#000000", hardness: 1, flow: 1 }, dabs: [] });
const top = { parentId: null, list: "layers" } as const;

/** a, a group of b (masked by m) and a paint layer p of s, then z. */
function tree(): Design {
  const b = { ...fill("b", 1), mask: { layers: [fill("m", 7)], invert: false, linked: true } };
  const p = makePaintLayer({ id: "p", strokes: [stroke("s")] });
  return { ...emptyDesign(), layers: [fill("a"), makeGroupLayer({ id: "g", layers: [b, p] }), fill("z", 2)] };
}
const idsOf = (design: Design, options = {}): string[] => flattenLayers(design, options).map(({ id }) => id);

function nest(depth: number): DesignLayer {
  let layer: DesignLayer = fill("leaf");
  for (let level = 1; level < depth; level++) layer = makeGroupLayer({ id: `g${level}`, layers: [layer] });
  return layer;
}

describe("the tree of layers", () => {
  it("is walked bottom to top, each layer before those that it holds, with the place of each", () => {
    expect(idsOf(tree())).toEqual(["a", "g", "b", "m", "p", "s", "z"]);
    expect(idsOf(tree(), { masks: false, strokes: false })).toEqual(["a", "g", "b", "p", "z"]);
    const visits = new Map(Array.from(walkLayers(tree()), (visit) => [visit.layer.id, visit]));
    expect(visits.get("m")).toMatchObject({ parentId: "b", list: "mask", index: 0, depth: 3, inMask: true });
    expect(visits.get("m")?.path).toEqual(["layers", 1, "layers", 0, "mask", "layers", 0]);
    expect(visits.get("s")).toMatchObject({ parentId: "p", list: "strokes", depth: 3, inMask: false });
    expect(visits.get("b")?.parent?.id).toBe("g");
    expect(visits.get("a")?.parent).toBeNull();
  });

  it("is walked once however many of its layers are asked for, and no further than to the last of them", () => {
    let reads = 0;
    const counted = (layer: DesignLayer): DesignLayer =>
      Object.defineProperty({ ...layer }, "visible", { enumerable: true, get: () => Boolean(++reads) });
    const layers = Array.from({ length: 300 }, (_, at) => counted(fill(`f${at}`)));
    const design = { ...emptyDesign(), layers };
    expect(isLocked(design, "f9")).toBe(false);
    expect(reads).toBe(10);
    for (const { id } of layers) expect(findLayer(design, id)?.id).toBe(id);
    expect(findLayer(design, "none")).toBeUndefined();
    expect(reads).toBe(300);
  });

  it("tells what is locked: a layer in a locked group, a stroke of a locked paint layer", () => {
    const locked = mapLayer(tree(), "g", (layer) => ({ ...layer, locked: true }));
    const ids = idsOf(locked);
    expect(ids.filter((id) => isLocked(locked, id))).toEqual(["g", "b", "m", "p", "s"]);
    expect(isLocked(locked, "none")).toBe(false);
  });

  it("is changed in one walk for any number of layers, wherever they are", () => {
    let reads = 0;
    const counted = (layer: DesignLayer): DesignLayer =>
      new Proxy(layer, {
        get: (from, key) => {
          if (key === "mask") reads += 1;
          return Reflect.get(from, key);
        },
      });
    const layers = Array.from({ length: 300 }, (_, at) => counted(fill(`f${at}`)));
    const design = { ...emptyDesign(), layers };
    const ids = new Set(layers.map(({ id }) => id));
    const hidden = mapLayers(design, ids, (layer) => ({ ...layer, visible: false }));
    expect(hidden.layers.every(({ visible }) => !visible)).toBe(true);
    expect(reads).toBeLessThanOrEqual(3 * layers.length);
    const few = mapLayers(tree(), new Set(["m", "s", "z", "none"]), (layer) => ({ ...layer, opacity: 0.5 }));
    expect(
      flattenLayers(few)
        .filter(({ opacity }) => opacity === 0.5)
        .map(({ id }) => id),
    ).toEqual(["m", "s", "z"]);
    expect(mapLayers(design, ids, (layer) => layer)).toBe(design);
    expect(idsOf(removeByIds(tree(), new Set(["g", "m", "z"])))).toEqual(["a"]);
    expect(idsOf(removeByIds(tree(), new Set(["m", "s"])))).toEqual(["a", "g", "b", "p", "z"]);
  });

  it("tells what is shown: a layer in a hidden group is not", () => {
    const hidden = mapLayer(tree(), "g", (layer) => ({ ...layer, visible: false }));
    const shown = Array.from(walkLayers(hidden)).filter((visit) => visit.shown);
    expect(shown.map(({ layer }) => layer.id)).toEqual(["a", "z"]);
  });

  it("names the materials that a layer and what it holds paint, without those of masks", () => {
    expect(materialsIn(findLayer(tree(), "g") as DesignLayer)).toEqual([1, 0]);
  });

  it("is edited anywhere by id, and what did not change is shared", () => {
    const before = tree();
    const after = mapLayer(before, "m", (layer) => ({ ...layer, opacity: 0.5 }));
    expect(findLayer(after, "m")?.opacity).toBe(0.5);
    expect(after.layers[0]).toBe(before.layers[0]);
    expect(findLayer(after, "p")).toBe(findLayer(before, "p"));
    expect(mapLayer(before, "m", (layer) => layer)).toBe(before);
    expect(mapLayer(before, "nobody", () => fill("x"))).toBe(before);
    expect(idsOf(removeById(before, "g"))).toEqual(["a", "z"]);
    expect(idsOf(removeById(before, "m"))).toEqual(["a", "g", "b", "p", "s", "z"]);
    expect(removeById(before, "nobody")).toBe(before);
  });

  it("takes a layer at any place, and makes a mask where there is none", () => {
    expect(idsOf(insertAt(tree(), { parentId: "g", list: "layers", index: 1 }, fill("new")))).toEqual([
      "a",
      "g",
      "b",
      "m",
      "new",
      "p",
      "s",
      "z",
    ]);
    const masked = insertAt(tree(), { parentId: "z", list: "mask", index: 0 }, fill("new"));
    expect(findLayer(masked, "z")?.mask).toEqual({ layers: [fill("new")], invert: false, linked: true });
    expect(idsOf(insertAt(tree(), { parentId: "p", list: "strokes", index: 9 }, stroke("new")))).toContain("new");
    expect(idsOf(insertAt(tree(), { ...top, index: 99 }, fill("new"))).at(-1)).toBe("new");
  });

  it.each<[string, () => Design]>([
    ["a parent that is not there", () => insertAt(tree(), { parentId: "no", list: "layers", index: 0 }, fill("n"))],
    ["layers in a fill", () => insertAt(tree(), { parentId: "a", list: "layers", index: 0 }, fill("n"))],
    ["a fill among strokes", () => insertAt(tree(), { parentId: "p", list: "strokes", index: 0 }, fill("n"))],
    ["a group in a mask", () => insertAt(tree(), { parentId: "a", list: "mask", index: 0 }, nest(2))],
    ["a seventeenth level", () => insertAt(emptyDesign(), { ...top, index: 0 }, nest(17))],
  ])("refuses %s", (_what, edit) => {
    expect(edit).toThrow(expect.objectContaining({ code: "bad-argument" }));
  });

  it("takes sixteen levels", () => {
    expect(layerDepth(nest(16))).toBe(16);
    expect(insertAt(emptyDesign(), { ...top, index: 0 }, nest(16)).layers).toHaveLength(1);
  });

  it("moves a layer with all that it holds, within its list and out of it", () => {
    expect(idsOf(moveLayers(tree(), ["g"], { parentId: null, index: 0 }))).toEqual(["g", "b", "m", "p", "s", "a", "z"]);
    expect(idsOf(moveLayers(tree(), ["b"], { parentId: null, index: 0 }))).toEqual(["b", "m", "a", "g", "p", "s", "z"]);
    expect(idsOf(moveLayers(tree(), ["a"], { parentId: "g", index: 2 }))).toEqual(["g", "b", "m", "p", "s", "a", "z"]);
    const before = tree();
    expect(moveLayers(before, ["z"], { parentId: null, index: 2 })).toBe(before);
  });

  it("gives copies ids that no layer has, down to the strokes and masks", () => {
    const copy = withIds(findLayer(tree(), "g") as DesignLayer, freeIdsIn(tree()));
    const ids = flattenLayers({ layers: [copy] }).map(({ id }) => id);
    expect(new Set(ids).size).toBe(5);
    expect(ids.some((id) => layerIds(tree()).has(id))).toBe(false);
    expect(layerIds(tree()).has(freeIdIn(tree()))).toBe(false);
  });
});

describe("a design that is full", () => {
  const full: Design = {
    ...emptyDesign(),
    layers: [
      fill("a"),
      makePaintLayer({
        id: "p",
        strokes: Array.from({ length: DESIGN_LIMITS.layers - 2 }, (_, at) => stroke(`s${at}`)),
      }),
    ],
  };

  it("takes no more layers, anywhere in it, for it could not be read again", () => {
    expect(parseDesign(full).layers).toHaveLength(2);
    const places = [top, { parentId: "p", list: "strokes" }, { parentId: "a", list: "mask" }] as const;
    for (const place of places) {
      expect(() => insertAt(full, { ...place, index: 0 }, stroke("more"))).toThrow("holds 10000 layers");
    }
    expect(() => addMask(full, "a", true)).toThrow("holds 10000 layers");
    expect(() => duplicateLayers(full, ["a"])).toThrow("holds 10000 layers");
  });

  it("is arranged as before, and takes more once something has gone", () => {
    expect(moveLayers(full, ["a"], { parentId: null, index: 2 }).layers.map(({ id }) => id)).toEqual(["p", "a"]);
    expect(insertAt(removeById(full, "s7"), { ...top, index: 2 }, fill("b")).layers).toHaveLength(3);
  });
});
