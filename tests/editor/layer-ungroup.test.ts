import { afterEach, describe, expect, it } from "vitest";
import {
  type Design,
  type DesignLayer,
  emptyDesign,
  type GroupLayer,
  type Mask,
  makeDecalLayer,
  makeFillLayer,
  makeGroupLayer,
  resolveLayers,
} from "../../web/editor/document/index.ts";
import { ungroupLayers } from "../../web/editor/state/layer-ungroup.ts";
import { FRONT } from "../support/layers.ts";
import { allTexels, endHosts, paintablePlane } from "../support/painted-plane.ts";

afterEach(endHosts);

const designOf = (...layers: DesignLayer[]): Design => ({
  ...emptyDesign(),
  assets: { logo: { type: "image/png", uri: "logo.png" } },
  layers,
});
const fill = (fields: Partial<DesignLayer> = {}): DesignLayer =>
  ({ ...makeFillLayer({ id: "fill", color: "#2060c0b0" }), ...fields }) as DesignLayer;
const logo = (fields: Partial<DesignLayer> = {}): DesignLayer =>
  ({ ...makeDecalLayer({ id: "logo", asset: "logo", projector: FRONT, opacity: 0.75 }), ...fields }) as DesignLayer;
const group = (layers: DesignLayer[], fields: Partial<GroupLayer> = {}): DesignLayer =>
  makeGroupLayer({ id: "group", layers, ...fields });
const half: Mask = {
  layers: [makeDecalLayer({ id: "hider", asset: "logo", projector: FRONT, blend: "erase" })],
  invert: false,
  linked: true,
};

const same: [string, DesignLayer][] = [
  ["several layers without more", group([fill(), logo()])],
  ["an isolated group of plain layers", group([fill(), logo()], { isolated: true })],
  ["an opacity over one layer", group([logo({ blend: "multiply" })], { opacity: 0.4 })],
  ["an opacity over an eraser", group([logo({ blend: "erase" })], { opacity: 0.4 })],
  ["a mask of one layer", group([logo()], { mask: half, opacity: 0.5 })],
  ["a mask over a group in a group", group([group([fill(), logo()], { id: "inner" })], { mask: half })],
  ["a blend mode over one layer, whatever its own", group([logo({ blend: "screen" })], { blend: "multiply" })],
  ["light mixed for one layer", group([fill()], { blend: "overlay", blendSpace: "linear", opacity: 0.6 })],
  ["a blend mode over a group that lets through", group([group([fill(), logo()], { id: "in" })], { blend: "screen" })],
];
const other: [string, string, DesignLayer][] = [
  ["an opacity over several layers", "opacity", group([fill(), logo()], { opacity: 0.5 })],
  ["a blend mode over several layers", "blend", group([fill(), logo()], { blend: "multiply" })],
  ["a mask over several layers", "mask", group([fill(), logo()], { mask: half })],
  ["two masks", "mask", group([logo({ mask: half })], { mask: { ...half, invert: true } })],
  [
    "isolation that keeps a mode from below",
    "isolated",
    group([fill({ blend: "multiply" }), logo()], { isolated: true }),
  ],
];

describe("ungrouping", () => {
  it.each(same)("keeps the picture of %s", async (_what, grouped) => {
    const ground = makeFillLayer({ id: "ground", color: "#e0a04080" });
    const { engine } = await paintablePlane();
    const design = designOf(ground, grouped);
    const { design: apart, ids, lost } = ungroupLayers(design, ["group"]);
    expect([...lost]).toEqual([]);
    expect(apart.layers.map(({ id }) => id)).toEqual(["ground", ...ids]);
    engine.setLayers(resolveLayers(design), 1);
    const before = await allTexels(engine);
    engine.setLayers(resolveLayers(apart), 2);
    const after = await allTexels(engine);
    expect(Math.max(...before.map((value, place) => Math.abs(value - (after[place] ?? 0))))).toBeLessThanOrEqual(1);
  });

  it.each(other)("tells what goes of %s", (_what, field, grouped) => {
    expect([...ungroupLayers(designOf(grouped), ["group"]).lost]).toEqual([field]);
  });

  it("loses nothing of a group that holds nothing", () => {
    const { lost, design } = ungroupLayers(designOf(group([], { opacity: 0.5, mask: half })), ["group"]);
    expect([lost.size, design.layers]).toEqual([0, []]);
  });
});
