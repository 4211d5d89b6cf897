import { describe, expect, it } from "vitest";
import {
  type Design,
  type DesignLayer,
  emptyDesign,
  makeFillLayer,
  makeGroupLayer,
} from "../../web/editor/document/index.ts";
import { returnedLayers } from "../../web/editor/state/returned-layers.ts";

const designOf = (...layers: DesignLayer[]): Design => ({ ...emptyDesign(), layers });
const [a, b, c] = ["a", "b", "c"].map((id) => makeFillLayer({ id, color: "#2060c0" })) as [
  DesignLayer,
  DesignLayer,
  DesignLayer,
];
const group = makeGroupLayer({ id: "group", layers: [b, c] });

describe("what a step through the history brings", () => {
  it("is what had been deleted, the topmost first", () => {
    expect(returnedLayers(designOf(b), designOf(a, b, c))).toEqual(["c", "a"]);
  });

  it("is the group of what came in one, and a layer that came into one that was there", () => {
    expect(returnedLayers(designOf(a), designOf(a, group))).toEqual(["group"]);
    expect(returnedLayers(designOf(makeGroupLayer({ id: "group", layers: [b] })), designOf(group))).toEqual(["c"]);
  });

  it("is nothing where layers went, moved or changed", () => {
    expect(returnedLayers(designOf(a, b, c), designOf(b))).toEqual([]);
    expect(returnedLayers(designOf(a, group), designOf(c, b, { ...a, opacity: 0.5 }))).toEqual([]);
  });
});
