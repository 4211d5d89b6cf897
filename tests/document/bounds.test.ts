/** Where what a document may hold ends: the last value that is taken, and the first that is refused by its path. */
import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { parseDesign } from "../../web/editor/document/index.ts";
import { parseZones } from "../../web/editor/document/zones.ts";

const planar = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] };
const perspective = {
  ...{ kind: "perspective", position: [0, 0, 2], rotation: [0, 0, 0, 1] },
  ...{ fov: 30, aspect: 1, near: 0.5, far: 4 },
};
const cylindrical = {
  ...{ kind: "cylindrical", position: [0, 0, 0], rotation: [0, 0, 0, 1] },
  ...{ radius: 1, height: 1, arc: 90, depth: 0.1 },
};
const stop = (offset: number) => ({ offset, color: "#ffffff" });

type Make = (value: never) => unknown;
type Case = readonly [path: string, make: Make, taken: readonly unknown[], refused: readonly unknown[]];

const layer = (fields: object) => ({
  ...{
    format: "texelcast-design",
    version: 1,
    assets: { logo: { type: "image/png", uri: "logo.png" }, letters: { type: "font/ttf", uri: "own.ttf" } },
  },
  layers: [fields],
});
const decal = (fields: object) => layer({ type: "decal", asset: "logo", projector: planar, ...fields });
const thrown = (projector: object) => decal({ projector });
const text = (fields: object) => layer({ type: "text", text: "A", font: "letters", projector: planar, ...fields });
const stroke = (brush: object) => layer({ type: "stroke", brush, dabs: [planar] });
const fill = (fields: object) => layer({ type: "fill", color: "#ff0000", ...fields });
const linear = (fields: object) =>
  fill({ gradient: { kind: "linear", from: [0, 0, 0], to: [0, 1, 0], stops: [stop(0), stop(1)], ...fields } });
const letters = (count: number) => "é".repeat(count);

const LEAST = 2 ** -149;
const JUST_BELOW_180 = 180 - 2 ** -16;

const DESIGNS: readonly Case[] = [
  ["layers[0].opacity", (opacity) => decal({ opacity }), [0, 1], [-1e-9, 1 + 1e-9]],
  ["layers[0].id", (id) => decal({ id }), [letters(200)], ["", letters(201)]],
  ["layers[0].name", (name) => decal({ name }), ["", letters(1000)], [letters(1001)]],
  ["layers[0].material", (material) => decal({ material }), [0, 65_535, [0, 65_535]], [-1, 65_536, 0.5]],
  ["layers[0].angleFade", (end) => decal({ angleFade: [60, end] }), [60, 90], [59.999]],
  ["layers[0].projector.size[1]", (high) => thrown({ ...planar, size: [1, high, 1] }), [1e-9, 1e9], [0, 9e-10, 1.1e9]],
  ["layers[0].projector.position[0]", (x) => thrown({ ...planar, position: [x, 0, 0] }), [-1e9, 1e9], [-1.1e9, 1.1e9]],
  ["layers[0].projector.rotation", (w) => thrown({ ...planar, rotation: [0, 0, 0, w] }), [1e-3, -1e3], [0, 9e-4, 1001]],
  [
    "layers[0].projector.fov",
    (fov) => thrown({ ...perspective, fov }),
    [LEAST, JUST_BELOW_180],
    [0, 2 ** -150, 180 - 2 ** -17, 180],
  ],
  ["layers[0].projector.far", (far) => thrown({ ...perspective, far }), [0.500001], [0.5, 0.4]],
  ["layers[0].projector.arc", (arc) => thrown({ ...cylindrical, arc }), [LEAST, 360], [0, 2 ** -150, 360.001]],
  ["layers[0].text", (count) => text({ text: letters(count) }), [0, 10_000], [10_001]],
  ["layers[0].letterSpacing", (letterSpacing) => text({ letterSpacing }), [-1, 10], [-1.001, 10.001]],
  ["layers[0].curve", (curve) => text({ curve }), [-360, 360], [-360.1, 360.1]],
  ["layers[0].brush.hardness", (hardness) => stroke({ hardness }), [0, 1], [-0.001, 1.001]],
  ["layers[0].brush.flow", (flow) => stroke({ flow }), [0, 1], [-0.001, 1.001]],
  ["layers[0].gradient.stops[1].offset", (end) => linear({ stops: [stop(0), stop(end)] }), [0, 1], [1.001]],
  [
    "layers[0].gradient.stops",
    (count) => linear({ stops: Array.from({ length: count }, () => stop(0.5)) }),
    [2, 16],
    [1, 17],
  ],
  ["layers[0].gradient.to", (x) => linear({ to: [x, 0, 0] }), [1e-9], [0, 1e-60]],
  [
    "layers[0].parts.faces[0]",
    (face) => fill({ parts: { kind: "faces", faces: [face] } }),
    [0, 0xffff_ffff],
    [-1, 0x1_0000_0000, 0.5],
  ],
];

const zones = (fields: object, more: object = {}) => ({
  ...{ texelcastZones: 1, ...more },
  zones: [{ id: "front", shape: { kind: "uv", polygon: ring(3) }, ...fields }],
});
function ring(corners: number): number[][] {
  return Array.from({ length: corners }, (_, at) => {
    const angle = (2 * Math.PI * at) / corners;
    return [0.5 + 0.4 * Math.cos(angle), 0.5 + 0.4 * Math.sin(angle)];
  });
}

const ZONES: readonly Case[] = [
  ["zones[0].safe", (safe) => zones({ safe }), [0, 10_000], [-0.1, 10_000.1]],
  ["zones[0].bleed", (bleed) => zones({ bleed }), [0, 10_000], [-0.1, 10_000.1]],
  ["zones[0].shape.polygon", (count) => zones({ shape: { kind: "uv", polygon: ring(count) } }), [3, 1000], [2, 1001]],
  ["dpi.least", (least) => zones({}, { dpi: { least, good: 10_000 } }), [1, 10_000], [0.9, 10_000.1]],
  ["printScale", (printScale) => zones({}, { printScale }), [1e-9, 1e9], [0, 1.1e9]],
  [
    "zones",
    (count) => ({
      texelcastZones: 1,
      zones: Array.from({ length: count }, (_, at) => ({ ...zones({}).zones[0], id: `${at}` })),
    }),
    [0, 100],
    [101],
  ],
];

/** The path that is refused; null where it is taken. */
function refusedAt(parse: (source: unknown) => unknown, source: unknown): string | null {
  try {
    parse(source);
    return null;
  } catch (error) {
    if (error instanceof TexelcastError) return error.field ?? "";
    throw error;
  }
}

describe.each([
  ["a design", DESIGNS, (source: unknown) => parseDesign(source, "shirt.json")],
  ["a zones file", ZONES, (source: unknown) => parseZones(source, "mug.zones.json")],
] as const)("%s", (_, cases, parse) => {
  it.each(cases)("takes %s up to its bounds and refuses it beyond", (path, make, taken, refused) => {
    for (const value of taken) expect(refusedAt(parse, make(value as never)), `${value}`).toBeNull();
    for (const value of refused) expect(refusedAt(parse, make(value as never)), `${value}`).toBe(path);
  });
});
