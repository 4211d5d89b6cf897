import { describe, expect, it } from "vitest";
import { findingsOf } from "../../web/engine/print-findings.ts";
import type { LayerPrint } from "../../web/engine/print-report.ts";
import { NO_ZONES, type PrintZones } from "../../web/engine/print-zones.ts";
import { decal } from "../support/layers.ts";
import { LEFT_HALF, zones } from "../support/zones.ts";

/** A layer with nothing to find fault with. */
const SOUND: LayerPrint = {
  id: "logo",
  type: "decal",
  materials: [0],
  zones: [{ id: "left", share: 1 }],
  dpi: { least: 300, mean: 300 },
  stretch: { greatest: 0, mean: 0 },
  clipped: 0,
  hidden: 0,
  outsideZones: 0,
  inSafeMargin: 0,
  overlapTexels: 0,
  mirroredTexels: 0,
  areaCm2: 10,
};

const NONE = new Map();

/** What is found: "violation low-dpi", each with the zone that it is said to be in. */
function found(layer: Partial<LayerPrint>, file: PrintZones = zones()): string[] {
  const { violations, warnings } = findingsOf(file, ["m"], [{ ...SOUND, ...layer }], NONE, [], NONE);
  return [...violations.map(({ code }) => `violation ${code}`), ...warnings.map(({ code }) => `warning ${code}`)];
}

const LIMITS = zones({}, { dpi: { least: 150, good: 300 } });
const WARNS = zones({ policy: "warn" });

describe("a print's findings", () => {
  it("are none where nothing is wrong", () => {
    expect(found({})).toEqual([]);
    expect(found({}, NO_ZONES)).toEqual([]);
  });

  it.each<[string, string, Partial<LayerPrint>, Partial<LayerPrint>, PrintZones]>([
    [
      "density below the least",
      "violation low-dpi",
      { dpi: { least: 300, mean: 150 } },
      { dpi: { least: 300, mean: 149 } },
      zones({}, { dpi: { least: 150, good: 150 } }),
    ],
    [
      "density below the good",
      "warning low-dpi",
      { dpi: { least: 300, mean: 300 } },
      { dpi: { least: 300, mean: 299 } },
      LIMITS,
    ],
    [
      "density below the least at one spot",
      "warning low-dpi",
      { dpi: { least: 150, mean: 300 } },
      { dpi: { least: 149, mean: 300 } },
      LIMITS,
    ],
    [
      "a share outside of zones that clip",
      "warning outside-zones",
      { outsideZones: 0.01 },
      { outsideZones: 0.011 },
      zones(),
    ],
    [
      "a share outside of zones that warn",
      "violation outside-zones",
      { outsideZones: 0.01 },
      { outsideZones: 0.011 },
      WARNS,
    ],
    [
      "all of it outside of zones that clip",
      "violation nothing-printed",
      { outsideZones: 0 },
      { outsideZones: 1 },
      zones(),
    ],
    [
      "all of it outside of zones that warn",
      "violation outside-zones",
      { outsideZones: 0 },
      { outsideZones: 1 },
      WARNS,
    ],
    ["no printed area", "violation nothing-printed", { areaCm2: 1e-9 }, { areaCm2: 0 }, zones()],
    ["a share in the margin", "warning safe-margin", { inSafeMargin: 0.01 }, { inSafeMargin: 0.011 }, zones()],
    ["a share on no surface", "warning clipped", { clipped: 0.01 }, { clipped: 0.011 }, zones()],
    [
      "a share on no surface, what is hidden aside",
      "warning clipped",
      { clipped: 0.01, hidden: 0.01 },
      { clipped: 0.021, hidden: 0.01 },
      zones(),
    ],
    ["a hidden share", "warning hidden", { hidden: 0.01, clipped: 0.01 }, { hidden: 0.011, clipped: 0.011 }, zones()],
    [
      "mean stretch",
      "warning stretched",
      { stretch: { greatest: 90, mean: 25 } },
      { stretch: { greatest: 90, mean: 25.1 } },
      zones(),
    ],
    ["a texel that is shared", "warning appears-twice", { overlapTexels: 0 }, { overlapTexels: 1 }, zones()],
    ["a mirrored texel", "warning mirrored", { mirroredTexels: 0 }, { mirroredTexels: 1 }, zones()],
  ])("tell %s, %s alone, and only beyond the limit", (_what, told, within, beyond, file) => {
    expect(found(within, file)).toEqual([]);
    expect(found(beyond, file)).toEqual([told]);
  });

  it("round a density as they say it: what reads as the limit is not below it", () => {
    expect(found({ dpi: { least: 149.5, mean: 299.5 } }, LIMITS)).toEqual([]);
    expect(found({ dpi: { least: 149.4, mean: 299.5 } }, LIMITS)).toEqual(["warning low-dpi"]);
    expect(found({ dpi: { least: 149.5, mean: 299.4 } }, LIMITS)).toEqual(["warning low-dpi"]);
  });

  it("never say 0 % of something", () => {
    const { warnings } = findingsOf(zones(), ["m"], [{ ...SOUND, hidden: 0.0101, clipped: 0.0101 }], NONE, [], NONE);
    expect(warnings.map(({ value, message }) => [value, message.slice(0, 3)])).toEqual([[1, "1 %"]]);
  });

  it("have no say in what a fill covers beyond its zones, but where nothing of it is printed", () => {
    const everywhere = { type: "fill", dpi: null, stretch: null, outsideZones: 0.9, overlapTexels: 5 } as const;
    expect(found(everywhere)).toEqual([]);
    expect(found({ ...everywhere, areaCm2: 0 })).toEqual(["violation nothing-printed"]);
  });

  it("say nothing of zones where a file has none", () => {
    expect(found({ outsideZones: 0.9, zones: [] }, NO_ZONES)).toEqual([]);
  });

  it("name the zone that most of the layer lies in", () => {
    for (const shares of [
      [0.2, 0.7, 0.1],
      [0.7, 0.2, 0.1],
      [0.1, 0.2, 0.7],
    ]) {
      const list = shares.map((share, index) => ({ id: `zone-${index}`, share }));
      const { warnings } = findingsOf(zones(), ["m"], [{ ...SOUND, zones: list, mirroredTexels: 1 }], NONE, [], NONE);
      expect(warnings.map(({ zone }) => zone)).toEqual([`zone-${shares.indexOf(0.7)}`]);
    }
  });

  it("name each layer on a material that cannot be painted, once for each such material, and no other", () => {
    const sources = [
      decal("on-both", "ink", { material: [0, 1, 2] }),
      decal("on-sound", "ink", { material: 0 }),
      decal("on-bare", "ink", { material: 2 }),
    ];
    const unpaintable = new Map([
      [1, "it has no triangles"],
      [2, "it has no coordinates"],
    ]);
    const { violations } = findingsOf(NO_ZONES, ["a", "b", "c"], [], unpaintable, sources, NONE);
    expect(violations.map(({ code, layer, value }) => [code, layer, value])).toEqual([
      ["not-printable", "on-both", 1],
      ["not-printable", "on-both", 2],
      ["not-printable", "on-bare", 2],
    ]);
    expect(violations.map(({ message }) => message)).toContain("Material 2 cannot be printed: it has no coordinates.");
  });

  it("name zones of materials that the model does not have, and words without letters for them", () => {
    const file = { ...NO_ZONES, zones: [0, 1, 2].map((material) => ({ ...LEFT_HALF, id: `z${material}`, material })) };
    const missing = new Map([
      ["hello", []],
      ["cup", ["☕", "🫖"]],
    ]);
    const { violations } = findingsOf(file, ["a", "b"], [], NONE, [], missing);
    expect(violations.map(({ code, layer, zone, value }) => [code, layer, zone, value])).toEqual([
      ["zone-without-material", null, "z2", 2],
      ["missing-characters", "cup", null, 2],
    ]);
  });
});
