import { describe, expect, it } from "vitest";
import {
  type DecalLayer,
  type Design,
  emptyDesign,
  makeDecalLayer,
  makeGroupLayer,
} from "../../web/editor/document/index.ts";
import { ShownRows } from "../../web/editor/panels/shown-rows.ts";
import { patchLayer } from "../../web/editor/state/design-edits.ts";
import { layerRows } from "../../web/editor/state/layer-rows.ts";

const decal = (id: string): DecalLayer =>
  makeDecalLayer({ id, asset: "dot", projector: { kind: "uv", center: [0.5, 0.5], size: [0.1, 0.1], angle: 0 } });
const design: Design = { ...emptyDesign(), layers: [decal("a"), makeGroupLayer({ id: "g", layers: [decal("b")] })] };
const OPEN: ReadonlySet<string> = new Set();

describe("the layer list's rows", () => {
  it("are the very same while a layer is only moved on the model", () => {
    const shown = new ShownRows();
    const before = shown.of(layerRows(design, OPEN));
    let moved = design;
    for (const angle of [1, 2, 3]) {
      moved = patchLayer<DecalLayer>(moved, "b", {
        projector: { kind: "uv", center: [0.5, 0.5], size: [0.1, 0.1], angle },
      });
      expect(shown.of(layerRows(moved, OPEN))).toBe(before);
    }
  });

  it("are others when a layer looks otherwise in the list, when one is folded, and when they are rearranged", () => {
    const shown = new ShownRows();
    const before = shown.of(layerRows(design, OPEN));
    const renamed = shown.of(layerRows(patchLayer(design, "b", { name: "Crest" }), OPEN));
    expect(renamed).not.toBe(before);
    const hidden = shown.of(layerRows(patchLayer(design, "g", { visible: false }), OPEN));
    expect(hidden).not.toBe(renamed);
    const folded = shown.of(layerRows(design, new Set(["g"])));
    expect(folded).not.toBe(hidden);
    const turned = shown.of(layerRows({ layers: design.layers.toReversed() }, new Set(["g"])));
    expect(turned).not.toBe(folded);
  });

  it("reads nothing of layers that did not change", () => {
    let reads = 0;
    const watched = (id: string): DecalLayer => {
      const layer = decal(id);
      return new Proxy(layer, {
        get: (from, key) => {
          if (key === "opacity") reads += 1;
          return Reflect.get(from, key);
        },
      });
    };
    const many: Design = { ...design, layers: Array.from({ length: 500 }, (_, at) => watched(`d${at}`)) };
    const shown = new ShownRows();
    shown.of(layerRows(many, OPEN));
    reads = 0;
    shown.of(layerRows(many, OPEN));
    expect(reads).toBe(0);
    const [first, ...others] = many.layers;
    shown.of(layerRows({ layers: [{ ...(first as DecalLayer), flipX: true }, ...others] }, OPEN));
    expect(reads).toBeLessThan(5);
  });
});
