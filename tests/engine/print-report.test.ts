import { afterEach, describe, expect, it } from "vitest";
import type { EngineLayer } from "../../web/engine/engine-api.ts";
import type { EngineHost } from "../../web/engine/engine-host.ts";
import { NO_ZONES, type PrintZone } from "../../web/engine/print-zones.ts";
import { decal, FRONT, fill, group } from "../support/layers.ts";
import { buildGlb, plane } from "../support/model-builder.ts";
import { endHosts, startHost } from "../support/painted-plane.ts";
import { paintPng } from "../support/png-file.ts";
import { zones } from "../support/zones.ts";

afterEach(endHosts);

const INK = paintPng(100, 100, () => [10, 20, 200, 255]);
const SIZE = 128;

/** A white plane of 1 m, its texture open at 128 texels. */
async function whitePlane(layers: readonly EngineLayer[], open = true): Promise<EngineHost> {
  const engine = startHost();
  await engine.loadModel({ name: "plane.glb", bytes: buildGlb({ meshes: [plane(1, 0)], materials: [{ name: "m" }] }) });
  await engine.setAsset("ink", { name: "ink.png", bytes: INK });
  if (open) await engine.openTarget({ material: 0, width: SIZE, height: SIZE });
  engine.setLayers(layers, 1);
  return engine;
}

const CENTRE = decal("logo", "ink", { projector: { ...FRONT, size: [0.5, 0.5, 0.5] }, occlusion: "none" });

describe("the print report", () => {
  it("gives a plane's decal the density, area and form that its size and the print scale say", async () => {
    const engine = await whitePlane([CENTRE]);
    const life = await engine.printReport();
    expect(life.layers).toHaveLength(1);
    const [layer] = life.layers;
    expect(layer?.dpi?.least).toBeCloseTo(200 * 0.0254, 4);
    expect(layer?.dpi?.mean).toBeCloseTo(200 * 0.0254, 4);
    expect(layer?.stretch?.greatest).toBeCloseTo(0, 3);
    expect(layer).toMatchObject({ clipped: 0, hidden: 0, outsideZones: 0, overlapTexels: 0, mirroredTexels: 0 });
    expect(layer?.areaCm2).toBeCloseTo(2500, -2);

    await engine.setZones({ ...NO_ZONES, printScale: 0.01 });
    const small = await engine.printReport();
    expect(small.layers[0]?.dpi?.mean).toBeCloseTo(200 * 2.54, 2);
    expect(small.whole.areaCm2).toBeCloseTo((layer?.areaCm2 ?? 0) / 10_000, 4);
    expect(small.violations).toEqual([]);
  });

  it("names what is too coarse a violation, and what is not quite fine enough a warning", async () => {
    const engine = await whitePlane([CENTRE]);
    const codes = async (least: number, good: number) => {
      await engine.setZones({ ...NO_ZONES, dpi: { least, good } });
      const { violations, warnings } = await engine.printReport();
      return [violations.map(({ code }) => code), warnings.map(({ code }) => code)];
    };
    expect(await codes(6, 7)).toEqual([["low-dpi"], []]);
    expect(await codes(5, 6)).toEqual([[], ["low-dpi"]]);
    expect(await codes(4, 5)).toEqual([[], []]);
  });

  it("names the characters of words that no font has, before placeholders are printed for them", async () => {
    const words = (id: string, text: string): EngineLayer => ({
      ...CENTRE,
      id,
      asset: {
        ...{ text, font: "texelcast:fonts/inter-700", fontSize: 0.5, letterSpacing: 0, align: "center", curve: 0 },
        color: [0, 0, 0, 1],
        outline: null,
      },
    });
    const engine = await whitePlane([words("greek", "Ada"), words("both", "字 Ada 漢 字")]);
    const lacking = (await engine.printReport()).violations.filter(({ code }) => code === "missing-characters");
    expect(lacking).toMatchObject([{ layer: "both", value: 2, characters: ["字", "漢"] }]);
    expect(lacking[0]?.message).toContain("字 漢");
  });

  it("tells what lies outside of a zone: a warning where it is clipped, else a violation", async () => {
    const engine = await whitePlane([CENTRE]);
    await engine.setZones(zones({}, { dpi: { least: 1, good: 1 } }));
    const clipped = await engine.printReport();
    expect(clipped.layers[0]?.outsideZones).toBeCloseTo(0.5, 2);
    expect(clipped.layers[0]?.zones).toEqual([{ id: "left", share: expect.closeTo(0.5, 2) }]);
    expect(clipped.violations).toEqual([]);
    expect(clipped.warnings).toEqual([expect.objectContaining({ code: "outside-zones", layer: "logo", zone: "left" })]);
    expect(clipped.layers[0]?.areaCm2, "what is cut off is not printed").toBeCloseTo(1250, -2);
    await engine.setZones(zones({ policy: "warn" }, { dpi: { least: 1, good: 1 } }));
    const warned = await engine.printReport();
    expect(warned.layers[0]?.areaCm2).toBeCloseTo(2500, -2);
    expect(warned.violations).toEqual([expect.objectContaining({ code: "outside-zones", value: 50, limit: 1 })]);
  });

  it("counts of a layer on two materials what neither cuts off: one has no zones, or zones that only warn", async () => {
    const engine = startHost();
    const meshes = [plane(1, 0), plane(1, 1)];
    await engine.loadModel({ name: "two.glb", bytes: buildGlb({ meshes, materials: [{ name: "a" }, { name: "b" }] }) });
    await engine.setAsset("ink", { name: "ink.png", bytes: INK });
    for (const material of [0, 1]) await engine.openTarget({ material, width: SIZE, height: SIZE });
    engine.setLayers([{ ...CENTRE, material: [0, 1] }], 1);
    const [left] = zones().zones;
    for (const [policies, squareCentimetres] of [
      [[], 5000],
      [["clip"], 3750],
      [["warn"], 5000],
      [["clip", "clip"], 2500],
      [["warn", "clip"], 3750],
      [["warn", "warn"], 5000],
    ] as const) {
      const list = policies.map((policy, material) => ({
        ...(left as PrintZone),
        id: `${material}`,
        material,
        policy,
      }));
      await engine.setZones({ ...NO_ZONES, zones: list });
      const { layers, whole } = await engine.printReport();
      expect(layers[0]?.areaCm2, policies.join()).toBeCloseTo(squareCentimetres, -2);
      expect(whole.areaCm2).toBe(layers[0]?.areaCm2);
    }
  });

  it("has for the whole the worst of all layers, and no density where no layer has one", async () => {
    const wide = decal("wide", "ink", { projector: { ...FRONT, size: [0.8, 0.4, 0.5] }, occlusion: "none" });
    const engine = await whitePlane([CENTRE, wide, fill("ground", [1, 0, 0, 1])]);
    const { layers, whole } = await engine.printReport();
    const [one, other] = layers;
    expect(whole.dpi?.mean).toBe(Math.min(one?.dpi?.mean ?? 0, other?.dpi?.mean ?? 0));
    expect(whole.dpi?.mean).toBe(other?.dpi?.mean);
    expect(whole.stretch).toEqual(other?.stretch);
    expect(whole.stretch?.mean).toBeGreaterThan(one?.stretch?.mean ?? 1e9);
    expect(whole.areaCm2).toBeCloseTo(
      layers.reduce((sum, { areaCm2 }) => sum + areaCm2, 0),
      6,
    );
    engine.setLayers([fill("ground", [1, 0, 0, 1])], 2);
    expect((await engine.printReport()).whole).toMatchObject({ dpi: null, stretch: null });
  });

  it("takes margins as millimetres of the print", async () => {
    const engine = await whitePlane([CENTRE]);
    // 125 mm of the model, at a scale of 1 to 10.
    await engine.setZones(zones({ safe: 12.5 }, { printScale: 0.1 }));
    expect((await engine.printReport()).layers[0]?.inSafeMargin).toBeCloseTo(0.25, 1);
  });

  it("leaves out what is not shown, and measures what is in groups", async () => {
    const engine = await whitePlane([
      decal("gone", "ink", { visible: false }),
      group("faded", [decal("unseen", "ink")], { opacity: 0 }),
      group("shown", [CENTRE]),
      fill("ground", [1, 0, 0, 1]),
    ]);
    const { layers, whole } = await engine.printReport();
    expect(layers.map(({ id }) => id)).toEqual(["logo", "ground"]);
    expect(layers[1]).toMatchObject({ type: "fill", dpi: null, stretch: null });
    expect(layers[1]?.areaCm2).toBeCloseTo(10_000, 0);
    expect(whole.areaCm2).toBeGreaterThan(12_000);
  });

  it("measures materials that are not open, and says so of those that cannot be", async () => {
    const engine = await whitePlane([CENTRE], false);
    expect((await engine.printReport()).layers[0]?.dpi?.mean).toBeCloseTo(200 * 0.0254, 4);
  });

  it("finds a decal beside the model, of which nothing is printed", async () => {
    const engine = await whitePlane([decal("off", "ink", { projector: { ...FRONT, position: [5, 0, 0] } })]);
    const { violations, layers } = await engine.printReport();
    expect(layers[0]).toMatchObject({ clipped: 1, hidden: 0, dpi: null, areaCm2: 0 });
    expect(violations).toEqual([expect.objectContaining({ code: "nothing-printed" })]);
  });

  it("maps density and stretch in colours, clear where no decal lies", async () => {
    const engine = await whitePlane([CENTRE]);
    const at = async (kind: "dpi" | "stretch", x: number) => {
      const { rgba } = await engine.printMap(0, kind);
      return [...rgba.subarray((64 * SIZE + x) * 4, (64 * SIZE + x) * 4 + 4)];
    };
    expect(await at("dpi", 2)).toEqual([0, 0, 0, 0]);
    expect(await at("dpi", 64)).toEqual([214, 48, 49, 255]);
    expect(await at("stretch", 64)).toEqual([32, 150, 96, 255]);
    await engine.setZones({ ...NO_ZONES, dpi: { least: 1, good: 2 } });
    expect(await at("dpi", 64)).toEqual([32, 150, 96, 255]);
  });
});

describe("zones that clip", () => {
  const texel = async (engine: EngineHost, x: number, y = 64) => [...(await engine.readTexels(0, x, y, 1, 1))];

  it("cut decals off at their edge, and change nothing within", async () => {
    const engine = await whitePlane([CENTRE]);
    const before = await engine.readTexels(0, 0, 0, SIZE / 2, SIZE);
    await engine.setZones(zones());
    expect(await engine.readTexels(0, 0, 0, SIZE / 2, SIZE)).toEqual(before);
    expect(await texel(engine, 63)).toEqual([10, 20, 200, 255]);
    expect(await texel(engine, 64)).toEqual([255, 255, 255, 255]);
  });

  it("let the bleed be printed, and what is uncovered when they are taken away", async () => {
    const engine = await whitePlane([CENTRE]);
    await engine.setZones(zones({ bleed: 1000 / 16 }));
    expect(await texel(engine, 71)).toEqual([10, 20, 200, 255]);
    expect(await texel(engine, 72)).toEqual([255, 255, 255, 255]);
    await engine.setZones(zones({ policy: "warn" }));
    expect(await texel(engine, 72)).toEqual([10, 20, 200, 255]);
    await engine.setZones(null);
    expect(await texel(engine, 72)).toEqual([10, 20, 200, 255]);
  });

  it("clip fills and groups as deep as designs may be, too", async () => {
    let nested: EngineLayer = fill("deep", [0, 0, 0, 1]);
    for (let depth = 0; depth < 15; depth++) nested = group(`g${depth}`, [nested]);
    const errors: Error[] = [];
    const engine = await whitePlane([]);
    engine.onError((error) => errors.push(error));
    await engine.setZones(zones());
    engine.setLayers([nested], 2);
    expect(await texel(engine, 10)).toEqual([0, 0, 0, 255]);
    expect(await texel(engine, 100)).toEqual([255, 255, 255, 255]);
    expect(errors).toEqual([]);
  });
});
