import fc from "fast-check";
import { afterEach, describe, expect, it } from "vitest";
import {
  emptyDesign,
  makeDecalLayer,
  makePaintLayer,
  makeStrokeLayer,
  resolveLayers,
} from "../../web/editor/document/index.ts";
import type { EngineLayer } from "../../web/engine/engine-api.ts";
import { dab, decal, FRONT, fill, group, stroke } from "../support/layers.ts";
import { allTexels, at, endHosts, paintablePlane, SIZE } from "../support/painted-plane.ts";

afterEach(endHosts);

const ASSETS = { logo: { type: "image/png", uri: "logo.png" } } as const;
const across = { axis: "x", offset: 0, readable: false } as const;

/** Layers of ids by place, groups in groups and masks; the same ids turn up anywhere. */
const arbitraryTree: fc.Arbitrary<EngineLayer[]> = fc
  .array(
    fc.record({
      id: fc.integer({ min: 0, max: 9 }),
      kind: fc.constantFrom("decal", "fill", "stroke", "group", "group"),
      place: fc.integer({ min: 0, max: 99 }),
      masking: fc.boolean(),
      isolated: fc.boolean(),
      opacity: fc.constantFrom(1, 0.5),
      erase: fc.boolean(),
    }),
    { maxLength: 8 },
  )
  .map((specs) => {
    const top: Built[] = [];
    const all: Built[] = [];
    for (const spec of specs) {
      if (all.some((one) => one.spec.id === spec.id)) continue;
      const built: Built = { spec, content: [], mask: [] };
      const holder = all[spec.place % (all.length + 1)];
      if (holder === undefined) top.push(built);
      else if (spec.masking && spec.kind !== "group") holder.mask.push(built);
      else if (holder.spec.kind === "group" && !holder.spec.masking) holder.content.push(built);
      else top.push(built);
      all.push(built);
    }
    return top.map(layerOf);
  });

interface Built {
  readonly spec: {
    readonly id: number;
    readonly kind: string;
    readonly masking: boolean;
    readonly isolated: boolean;
    readonly opacity: number;
    readonly erase: boolean;
  };
  readonly content: Built[];
  readonly mask: Built[];
}

function layerOf({ spec, content, mask }: Built): EngineLayer {
  const id = `layer-${spec.id}`;
  const shared = {
    opacity: spec.opacity,
    blend: spec.erase ? "erase" : "normal",
    mask: mask.length === 0 ? null : { layers: mask.map(layerOf), invert: spec.isolated },
  } as const;
  const x = spec.id / 20 - 0.25;
  if (spec.kind === "decal") return decal(id, "logo", { ...shared, ...at(x, 0.1, 0.4) });
  if (spec.kind === "stroke") return stroke(id, [dab(x, 0), dab(x, 0.2, 0.3, 0.5)], shared);
  if (spec.kind === "fill") return fill(id, [spec.id / 10, 0.5, 0.25, 0.75], shared);
  return group(id, content.map(layerOf), { ...shared, isolated: spec.isolated });
}

describe("trees of layers", () => {
  it("give the picture that they give to a fresh engine, whatever tree came before", async () => {
    const { engine } = await paintablePlane();
    const { engine: fresh } = await paintablePlane();
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    await fc.assert(
      fc.asyncProperty(arbitraryTree, async (layers) => {
        engine.setLayers(layers, 1);
        fresh.setLayers([], 1);
        await fresh.idle();
        fresh.setLayers(structuredClone(layers), 2);
        expect(await engine.hash(0)).toBe(await fresh.hash(0));
      }),
      { numRuns: 150 },
    );
    expect(errors).toEqual([]);
  });

  it("erase inside a paint layer from that layer alone", async () => {
    const { engine } = await paintablePlane();
    const before = await allTexels(engine);
    const brush = { tip: "round", color: "#ff0000", hardness: 1, flow: 1 } as const;
    const eraser = { id: "e", brush, blend: "erase" } as const;
    const strokes = [
      makeStrokeLayer({ id: "s", brush, dabs: [dab(0, 0, 0.5)] }),
      // Wider, for a rim that is half erased is still half there.
      makeStrokeLayer({ ...eraser, dabs: [dab(0, 0, 0.8)] }),
    ];
    engine.setLayers(resolveLayers({ ...emptyDesign(), layers: [makePaintLayer({ id: "p", strokes })] }), 1);
    expect(await allTexels(engine)).toEqual(before);
    engine.setLayers(
      resolveLayers({ ...emptyDesign(), layers: [makePaintLayer({ id: "p", strokes: strokes.slice(0, 1) })] }),
      2,
    );
    expect(await allTexels(engine)).not.toEqual(before);
  });

  it("paint a fill's charts and faces, and report triangles that are not there by their field", async () => {
    const { engine } = await paintablePlane();
    const painted = async (parts: NonNullable<Parameters<typeof fill>[2]>["parts"]): Promise<number> => {
      engine.setLayers([fill("f", [1, 0, 1, 1], { parts })], 1);
      const texels = await allTexels(engine);
      let count = 0;
      for (let i = 0; i < texels.length; i += 4)
        if (texels[i] === 255 && texels[i + 1] === 0 && texels[i + 2] === 255) count++;
      return count;
    };
    expect(await painted({ kind: "charts", charts: [0] })).toBe(SIZE * SIZE);
    const halves = [await painted({ kind: "faces", faces: [0] }), await painted({ kind: "faces", faces: [1] })];
    expect(halves[0] + halves[1]).toBe(SIZE * SIZE);
    expect(Math.abs(halves[0] - halves[1])).toBeLessThanOrEqual(SIZE);
    const errors: Error[] = [];
    engine.onError((error) => errors.push(error));
    await painted({ kind: "faces", faces: [0, 2] });
    expect(errors).toHaveLength(1);
    expect(errors[0]?.message).toContain("parts.faces[1]");
  });
});

describe("a mirror", () => {
  const logo = (fields: object = {}) =>
    makeDecalLayer({
      id: "d",
      asset: "logo",
      projector: { ...FRONT, position: [0.22, 0.1, 0], size: [0.25, 0.25, 0.5] },
      mirror: across,
      ...fields,
    });
  const paint = async (layers: EngineLayer[]): Promise<(x: number, y: number) => readonly number[]> => {
    const { engine } = await paintablePlane();
    engine.setLayers([fill("ground", [1, 1, 1, 1]), ...layers], 1);
    const texels = await allTexels(engine);
    return (x, y) => Array.from(texels.subarray((y * SIZE + x) * 4, (y * SIZE + x) * 4 + 4));
  };
  const resolved = (layer: ReturnType<typeof logo>): EngineLayer[] =>
    resolveLayers({ ...emptyDesign(), assets: ASSETS, layers: [layer] });

  it("shows a decal's picture a second time, left and right exchanged", async () => {
    const texel = await paint(resolved(logo()));
    let painted = 0;
    for (let y = 0; y < SIZE; y++) {
      for (let x = 0; x < SIZE / 2; x++) {
        if (texel(x, y)[2] !== 255) painted++;
        texel(x, y).forEach((value, channel) => {
          expect(Math.abs(value - (texel(SIZE - 1 - x, y)[channel] ?? 0))).toBeLessThanOrEqual(1);
        });
      }
    }
    expect(painted).toBeGreaterThan(100);
  });

  it("leaves a picture that is to be readable as it is", async () => {
    const texel = await paint(resolved(logo({ mirror: { ...across, readable: true } })));
    const there = decal("d", "logo", at(-0.22, 0.1));
    const here = decal("e", "logo", at(0.22, 0.1));
    const expected = await paint([there, here]);
    for (let y = 0; y < SIZE; y++) {
      for (let x = 0; x < SIZE; x++) {
        texel(x, y).forEach((value, channel) => {
          expect(Math.abs(value - (expected(x, y)[channel] ?? 0))).toBeLessThanOrEqual(1);
        });
      }
    }
  });

  it("does not build opacity up where picture and twin overlap", async () => {
    const brush = { tip: "round", color: "#000000", hardness: 1, flow: 1 } as const;
    const layer = makeStrokeLayer({ id: "s", brush, opacity: 0.5, dabs: [dab(0.05, 0, 0.5)], mirror: across });
    const texel = await paint(resolveLayers({ ...emptyDesign(), layers: [layer] }));
    expect(texel(SIZE / 2, SIZE / 2)[0]).toBe(128);
    expect(texel(SIZE / 2 + 14, SIZE / 2)[0]).toBe(128);
  });
});
