import { Vector3 } from "three";
import { describe, expect, it, vi } from "vitest";
import { DESIGN_LIMITS } from "../../web/editor/document/design-limits.ts";
import {
  type DesignLayer,
  emptyDesign,
  makeDecalLayer,
  makeGroupLayer,
  makePaintLayer,
  makeStrokeLayer,
} from "../../web/editor/document/index.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { type BrushKind, BrushTool } from "../../web/editor/tools/brush-tool.ts";
import { DabChain } from "../../web/editor/tools/dab-chain.ts";
import { stepFor, unitFor } from "../../web/editor/tools/length-unit.ts";
import { mirrorOf } from "../../web/editor/tools/mirror-setting.ts";
import { paintTargetOf, withStroke } from "../../web/editor/tools/paint-target.ts";
import { type PathStep, PointerPath, ropeOf } from "../../web/editor/tools/pointer-path.ts";
import { brushKeyChange } from "../../web/editor/tools/size-keys.ts";
import { surfaceJoins } from "../../web/editor/tools/surface-joins.ts";
import type { ToolContext } from "../../web/editor/tools/tool-context.ts";
import { brushSizes, withRecent } from "../../web/editor/tools/tool-settings.ts";
import { hitOf } from "../../web/viewer/surface-hit.ts";
import type { SurfaceHit, ToolSample, ToolView } from "../../web/viewer/viewer-api.ts";
import { cube, cylinder, queryOf, sheet, sphere } from "../viewer/surface-helpers.ts";

const hit = (x: number, y: number, z = 0): SurfaceHit => ({
  position: [x, y, z],
  normal: [0, 0, 1],
  material: 0,
  uv: [0, 0],
  face: 0,
});

const hitAt = ([x, y, z]: readonly [number, number, number]): SurfaceHit => hit(x, y, z);

/** A view that looks straight at z = 0, a hundred pixels to the metre, with a gap from x = 3 to x = 4. */
const VIEW: ToolView = {
  kind: "model",
  hitAt: ({ x, y }) => (x > 300 && x < 400 ? null : hit(x / 100, y / 100)),
  uvAt: () => null,
  placeOf: ({ position }) => ({ x: position[0] * 100, y: position[1] * 100 }),
};

const sample = (x: number, y: number, pressure = 1): ToolSample => {
  const at = { x, y };
  return { view: VIEW, at, hit: VIEW.hitAt(at), pressure, shift: false, alt: false, ctrl: false, time: 0 };
};

const always = (): boolean => true;
const placesOf = (steps: readonly PathStep[]) =>
  steps.map((step) => step && [step.hit.position[0], step.hit.position[1]]);

describe("a pointer's path", () => {
  it("looks at the model between samples that lie far apart", () => {
    const path = new PointerPath(sample(0, 0), { rope: 0, joined: always });
    expect(path.first(sample(0, 0))).toHaveLength(1);
    const steps = path.add(sample(50, 0, 0));
    expect(steps).toHaveLength(10);
    expect(steps.at(-1)).toMatchObject({ hit: { position: [0.5, 0, 0] }, pressure: 0 });
    expect(steps[4]?.pressure).toBeCloseTo(0.5);
  });

  it("breaks where the pointer leaves the model, once, and goes on behind the gap", () => {
    const path = new PointerPath(sample(280, 0), { rope: 0, joined: always });
    const steps = [...path.first(sample(280, 0)), ...path.add(sample(420, 0))];
    expect(steps.filter((step) => step === null)).toHaveLength(1);
    expect(steps.at(-1)?.hit.position[0]).toBeCloseTo(4.2);
  });

  it("breaks where two neighbours on the screen are apart on the model", () => {
    const path = new PointerPath(sample(0, 0), { rope: 0, joined: (_, { position }) => position[0] < 0.2 });
    path.first(sample(0, 0));
    expect(path.add(sample(25, 0)).filter((step) => step === null)).toHaveLength(2);
  });

  it("the stabiliser's rope swallows a tremor, is taut behind a straight pull, and is caught up at the end", () => {
    const path = new PointerPath(sample(100, 100), { rope: ropeOf(20), joined: always });
    path.first(sample(100, 100));
    expect(path.add(sample(106, 94))).toEqual([]);
    path.add(sample(200, 100));
    expect(path.tip.x).toBeCloseTo(190);
    expect(placesOf(path.finish(sample(200, 100))).at(-1)).toEqual([2, 1]);
  });

  it("with Shift begins in a straight line from where the stroke before ended", () => {
    const path = new PointerPath(sample(200, 0), { rope: 0, joined: always });
    const places = placesOf(path.lineFrom(hit(0, 0), sample(200, 0)));
    expect(places).toHaveLength(40);
    expect(places.at(-1)).toEqual([2, 0]);
  });
});

describe("ways over a surface", () => {
  const joinsOn = (...shapes: Parameters<typeof queryOf>) => {
    const query = queryOf(...shapes);
    const near = (position: readonly [number, number, number]): SurfaceHit | null => {
      const found = query.closest(new Vector3(...position));
      return found && hitOf(found);
    };
    return { near, joins: surfaceJoins({ near }, 0.01) };
  };

  it("along a wall, round a cylinder and over an edge belong together", () => {
    for (const [shape, a, b] of [
      [sheet(), [0, 0, 0], [0.5, 0.3, 0]],
      [cylinder(), [0, 0, 1], [0.3, 0, 0.954]],
      [sphere(), [0, 0, 1], [0.3, 0, 0.954]],
    ] as const) {
      const { joins } = joinsOn(shape);
      expect(joins(hitAt(a), hitAt(b))).toBe(true);
    }
  });

  it("from a part to another one far behind it do not", () => {
    const behind = sheet().translate(0.05, 0, -1);
    const { joins } = joinsOn(sheet().scale(0.2, 0.2, 1), behind);
    expect(joins(hit(0.2, 0, 0), hit(0.24, 0, -1))).toBe(false);
  });

  it("inside a dab are joined whatever lies between", () => {
    const joins = surfaceJoins({ near: () => null }, 0.1);
    expect(joins(hit(0, 0), hit(0.1, 0))).toBe(true);
    expect(joins(hit(0, 0), hit(0.11, 0))).toBe(false);
  });
});

describe("a growing chain of dabs", () => {
  const steps = (...xs: (number | null)[]): PathStep[] =>
    xs.map((x) => (x === null ? null : { hit: hit(x, 0), pressure: 0.5 }));

  it("keeps the objects of the shorter chain before, so that only new dabs are sent and painted", () => {
    const chain = new DabChain({ size: 1, spacing: 0.25, pressure: "flow" });
    chain.extend(steps(0, 1));
    const before = chain.dabs;
    chain.extend(steps(2));
    expect(chain.dabs).toHaveLength(9);
    expect(chain.dabs.slice(0, before.length).every((dab, index) => dab === before[index])).toBe(true);
  });

  it("under a hidden layer ends below it, and reaches as far into the surface as ever", () => {
    const chain = new DabChain({
      size: 1,
      spacing: 0.5,
      pressure: "none",
      freeAbove: ([x], _, reach) => (x > 0.9 ? 0.1 : reach),
    });
    chain.extend(steps(0, 1));
    const spans = chain.dabs.map((dab) =>
      dab.kind === "planar" ? [dab.position[2] - dab.size[2] / 2, dab.position[2] + dab.size[2] / 2] : [],
    );
    expect(spans).toEqual([
      [-0.5, 0.5],
      [-0.5, 0.5],
      [expect.closeTo(-0.5), expect.closeTo(0.09)],
    ]);
  });

  it("lays no dabs over a gap", () => {
    const chain = new DabChain({ size: 1, spacing: 0.25, pressure: "none" });
    chain.extend(steps(0, 1, null, 9, 10));
    const xs = chain.dabs.map((dab) => (dab.kind === "planar" ? dab.position[0] : Number.NaN));
    expect(xs.some((x) => x > 1 && x < 9)).toBe(false);
    expect(chain.dabs).toHaveLength(10);
  });

  it("ends at as many dabs as a design is read with", () => {
    const chain = new DabChain({ size: 1, spacing: 0.02, pressure: "none" });
    for (let x = 0; x <= 2200; x += 100) chain.extend(steps(x));
    expect(chain.full).toBe(true);
    expect(chain.dabs).toHaveLength(DESIGN_LIMITS.dabs);
    expect(chain.extend(steps(2300))).toEqual([]);
  });

  it("gives a pen's pressure to flow or to size, or to neither", () => {
    const dabOf = (pressure: "none" | "flow" | "size") => {
      const chain = new DabChain({ size: 1, spacing: 1, pressure });
      chain.extend(steps(0));
      const [dab] = chain.dabs;
      return dab?.kind === "planar" ? [dab.size[0], dab.flow] : [];
    };
    expect([dabOf("none"), dabOf("flow"), dabOf("size")]).toEqual([
      [1, 1],
      [1, 0.5],
      [0.5, 1],
    ]);
  });

  it("lies on a cube's faces with its light along the normals", () => {
    const query = queryOf(cube());
    const found = query.raycast(new Vector3(5, 0, 0), new Vector3(-1, 0, 0));
    if (found === null) throw new Error("The ray missed.");
    const chain = new DabChain({ size: 0.2, spacing: 1, pressure: "none" });
    chain.extend([{ hit: hitOf(found), pressure: 1 }]);
    const [dab] = chain.dabs;
    if (dab?.kind !== "planar") throw new Error("There is no planar dab.");
    const [x, y, z, w] = dab.rotation;
    expect(
      [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)].map(
        (part) => Math.round(part * 1e4) / 1e4 || 0,
      ),
    ).toEqual([1, 0, 0]);
    expect(dab.position).toEqual([1, 0, 0]);
  });
});

describe("where a stroke goes", () => {
  const projector = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] } as const;
  const stroke = makeStrokeLayer({
    id: "new",
    brush: { tip: "round", color: "#000000", hardness: 1, flow: 1 },
    dabs: [{ ...projector, flow: 1 }],
  });
  const decal = makeDecalLayer({ id: "decal", asset: "logo", projector });
  const inside = makeStrokeLayer({ ...stroke, id: "inside" });
  const paint = makePaintLayer({ id: "paint", strokes: [inside] });
  const designOf = (...layers: DesignLayer[]) => ({ ...emptyDesign(), layers });

  it("to the paint layer that is selected, itself or by one of its strokes", () => {
    const design = designOf(decal, paint);
    for (const id of ["paint", "inside"]) {
      const target = paintTargetOf(design, id, false);
      expect(target).toEqual({ kind: "strokes", layerId: "paint" });
      if (target.kind === "refused") continue;
      const painted = withStroke(design, target, stroke, stringsIn("en"));
      expect(painted?.layerId).toBe("paint");
      expect(painted?.design.layers[1]).toMatchObject({ type: "paint", strokes: [{ id: "inside" }, { id: "new" }] });
    }
  });

  it("else to a new paint layer above the selection, in its group", () => {
    const design = designOf(makeGroupLayer({ id: "group", layers: [decal] }), paint);
    const target = paintTargetOf(design, "decal", false);
    if (target.kind === "refused") throw new Error("It was refused.");
    const placed = withStroke(design, target, stroke, stringsIn("en"));
    if (placed === null) throw new Error("It has no place.");
    const { design: painted, layerId } = placed;
    expect(painted.layers[0]).toMatchObject({
      layers: [{ id: "decal" }, { id: layerId, type: "paint", strokes: [{ id: "new" }] }],
    });
    expect(new Set(["group", "decal", "paint", "inside", "new", layerId]).size).toBe(6);
  });

  it("an eraser hides what is no paint layer by its mask, and needs something selected", () => {
    const design = designOf(decal);
    const target = paintTargetOf(design, "decal", true);
    expect(target).toEqual({ kind: "mask", layerId: "decal" });
    if (target.kind === "refused") return;
    expect(withStroke(design, target, { ...stroke, blend: "erase" }, stringsIn("en"))?.design.layers[0]).toMatchObject({
      type: "decal",
      mask: { layers: [{ id: "new", blend: "erase" }], invert: false, linked: true },
    });
    expect(paintTargetOf(design, null, true)).toMatchObject({ kind: "refused", reason: "nothing-to-erase" });
  });

  it("to the mask of the layer whose mask is edited, by brush and eraser alike", () => {
    const design = designOf({ ...paint, mask: { layers: [], invert: false, linked: true } });
    for (const erases of [false, true]) {
      expect(paintTargetOf(design, "paint", erases, "paint")).toEqual({ kind: "mask", layerId: "paint" });
    }
  });

  it("on an inverted mask the eraser still hides and the brush still shows: each is blended the other way round", () => {
    const design = designOf({ ...decal, mask: { layers: [], invert: true, linked: true } });
    const put = (blend: "normal" | "erase") => {
      const painted = withStroke(design, { kind: "mask", layerId: "decal" }, { ...stroke, blend }, stringsIn("en"));
      return painted?.design.layers[0]?.mask?.layers.map((layer) => layer.blend);
    };
    expect([put("erase"), put("normal")]).toEqual([["normal"], ["erase"]]);
  });

  it("on a mask with unlocked alpha, which is all that a mask is, and on a paint layer as it is", () => {
    const locked = { ...stroke, lockAlpha: true };
    const masked = withStroke(designOf(decal), { kind: "mask", layerId: "decal" }, locked, stringsIn("en"));
    expect(masked?.design.layers[0]?.mask?.layers).toMatchObject([{ id: "new", lockAlpha: false }]);
    const painted = withStroke(designOf(paint), { kind: "strokes", layerId: "paint" }, locked, stringsIn("en"));
    expect(painted?.design.layers[0]).toMatchObject({ strokes: [{ id: "inside" }, { id: "new", lockAlpha: true }] });
  });

  it("on top where the layer or the group that it was for has gone since; what hides or erases goes nowhere then", () => {
    const design = designOf(decal);
    const words = stringsIn("en");
    const place = { parentId: "gone", list: "layers", index: 3 } as const;
    for (const target of [{ kind: "strokes", layerId: "gone" } as const, { kind: "new", place } as const]) {
      const placed = withStroke(design, target, stroke, words);
      expect(placed?.design.layers).toMatchObject([{ id: "decal" }, { type: "paint", strokes: [{ id: "new" }] }]);
    }
    expect(withStroke(design, { kind: "strokes", layerId: "gone" }, { ...stroke, blend: "erase" }, words)).toBeNull();
    expect(withStroke(design, { kind: "mask", layerId: "gone" }, stroke, words)).toBeNull();
  });

  it("not to what is locked or hidden, by itself or by its group", () => {
    expect(paintTargetOf(designOf({ ...paint, locked: true }), "paint", false)).toMatchObject({ reason: "locked" });
    const group = makeGroupLayer({ id: "group", layers: [paint], locked: true });
    expect(paintTargetOf(designOf(group), "paint", false)).toMatchObject({ reason: "locked" });
    expect(paintTargetOf(designOf({ ...paint, visible: false }), "paint", true)).toMatchObject({ reason: "hidden" });
  });
});

describe("a brush on a design that is full", () => {
  it("paints nothing, which could not be kept, and says so", () => {
    const begin = vi.fn(() => null);
    const told: string[] = [];
    const layers = (count: number): DesignLayer[] =>
      Array.from({ length: count }, (_, at) => makeGroupLayer({ id: `g${at}`, layers: [] }));
    const session = { recordedDesign: { ...emptyDesign(), layers: layers(DESIGN_LIMITS.layers) } };
    const context = {
      session,
      board: { strings: stringsIn("en"), info: ({ title }: { title: string }) => void told.push(title) },
      tools: { settings: { size: null } },
      viewer: { setRing: () => {} },
      textureView: { setRing: () => {} },
      store: { state: {} },
    } as unknown as ToolContext;
    const kind = { id: "brush", options: [], inner: () => 1, begin } as unknown as BrushKind;
    const brush = new BrushTool(kind, context);
    brush.input.down(sample(0, 0));
    expect(begin).not.toHaveBeenCalled();
    expect(told).toEqual(["The design is full"]);
    session.recordedDesign = { ...emptyDesign(), layers: layers(DESIGN_LIMITS.layers - 5) };
    brush.input.down(sample(0, 0));
    expect(begin).toHaveBeenCalled();
  });
});

describe("a brush's settings", () => {
  const key = (code: string, shiftKey = false) => ({ code, key: code.replace("Digit", ""), shiftKey });

  it("brackets change the size, with Shift the hardness, and digits the opacity", () => {
    const settings = { size: 1, hardness: 0.95 };
    const change = (pressed: ReturnType<typeof key>, from = settings) => brushKeyChange(pressed, from, brushSizes(10));
    expect(change(key("BracketRight"))?.size).toBeGreaterThan(1);
    expect(change(key("BracketLeft"))?.size).toBeLessThan(1);
    expect(change(key("BracketRight", true))).toEqual({ hardness: 1 });
    expect(change(key("BracketLeft", true), { size: 1, hardness: 0 })).toEqual({ hardness: 0 });
    expect(change(key("Digit4"))).toEqual({ opacity: 0.4 });
    expect(change(key("Digit0"))).toEqual({ opacity: 1 });
    expect(change(key("KeyZ"))).toBeNull();
  });

  it("a bracket that is held ends at the sizes that the field ends at", () => {
    const sizes = brushSizes(10);
    const held = (code: string): number => {
      let size = sizes.usual;
      for (let press = 0; press < 200; press += 1) {
        size = brushKeyChange(key(code), { size, hardness: 1 }, sizes)?.size ?? Number.NaN;
      }
      return size;
    };
    expect([held("BracketLeft"), held("BracketRight")]).toEqual([sizes.least, sizes.most]);
  });

  it("the newest colour comes first among the recent ones, once", () => {
    expect(withRecent(["#111111", "#222222"], "#222222")).toEqual(["#222222", "#111111"]);
    expect(
      withRecent(
        Array.from({ length: 40 }, (_, index) => `#${String(index).padStart(6, "0")}`),
        "#ffffff",
      ),
    ).toHaveLength(12);
  });

  it("sizes are told in units that fit the model", () => {
    expect(unitFor(0.15).symbol).toBe("mm");
    expect(unitFor(2).symbol).toBe("cm");
    expect(unitFor(300).symbol).toBe("m");
    expect([stepFor(12.4), stepFor(1240), stepFor(0)].map((step) => step > 0)).toEqual([true, true, true]);
  });

  it("mirrors about the origin's plane where the model stands about it, else through its middle", () => {
    const box = (low: number, high: number) => ({ boundsMin: [low, 0, 0], boundsMax: [high, 1, 1] }) as const;
    expect(mirrorOf("x", box(-1, 1.02))).toEqual({ axis: "x", offset: 0, readable: false });
    expect(mirrorOf("x", box(1, 3))).toMatchObject({ offset: 2 });
    expect(mirrorOf("none", box(0, 1))).toBeNull();
  });
});
