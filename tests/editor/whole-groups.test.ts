import { expect, it } from "vitest";
import {
  type Design,
  type DesignLayer,
  emptyDesign,
  type Mask,
  makeDecalLayer,
  makeGroupLayer,
  makeStrokeLayer,
} from "../../web/editor/document/index.ts";
import { wholeGroups } from "../../web/editor/state/whole-groups.ts";

const projector = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] } as const;
const brush = { tip: "round", color: "#000000", hardness: 1, flow: 1 } as const;
const mask: Mask = { layers: [], invert: false, linked: true };
const decal = (id: string, locked = false): DesignLayer => ({
  ...makeDecalLayer({ id, asset: "logo", projector }),
  locked,
});
const group = (id: string, layers: readonly DesignLayer[]): DesignLayer => ({
  ...makeGroupLayer({ id, name: id, layers }),
  mask,
});
const going = (layers: readonly DesignLayer[], ...selection: string[]): Record<string, string[]> => {
  const design: Design = { ...emptyDesign(), layers };
  return Object.fromEntries(
    wholeGroups(design, selection).map(({ group: { id }, pictures }) => [id, pictures.map((each) => each.id)]),
  );
};

it("a group that is chosen goes as a whole with the groups in it, whatever else is in it", () => {
  const stroke = makeStrokeLayer({ id: "s", brush, dabs: [{ ...projector, flow: 1 }] });
  const layers = [group("outer", [decal("a"), stroke, group("inner", [decal("b")])]), group("other", [decal("c")])];
  expect(going(layers, "outer")).toEqual({ inner: ["b"], outer: ["a", "b"] });
  expect(going(layers, "inner")).toEqual({ inner: ["b"] });
  expect(going(layers, "outer", "other")).toEqual({ inner: ["b"], outer: ["a", "b"], other: ["c"] });
});

it("so does one whose pictures are all chosen one by one, and none that is moved in part", () => {
  const layers = [group("pair", [decal("a"), decal("b")]), decal("c")];
  expect(going(layers, "a", "b")).toEqual({ pair: ["a", "b"] });
  expect(going(layers, "a", "c")).toEqual({});
  expect(going([group("nested", [decal("a"), group("inner", [decal("b")])])], "a", "b")).toEqual({
    inner: ["b"],
    nested: ["a", "b"],
  });
});

it("the one picture of a group that is chosen by itself moves behind the group's mask", () => {
  const layers = [group("frame", [decal("a")])];
  expect(going(layers, "a")).toEqual({});
  expect(going(layers, "frame")).toEqual({ frame: ["a"] });
});

it("a group with something locked stays, as does one in which nothing is moved", () => {
  expect(going([group("pair", [decal("a"), decal("b", true)])], "pair")).toEqual({});
  expect(going([{ ...group("pair", [decal("a"), decal("b")]), locked: true }], "pair")).toEqual({});
  expect(going([group("empty", [])], "empty")).toEqual({});
});
