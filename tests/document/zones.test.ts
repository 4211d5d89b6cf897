import { Ajv2020 } from "ajv/dist/2020.js";
import { describe, expect, it } from "vitest";
import { zonesJsonSchema } from "../../scripts/schema/zones-json-schema.ts";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { parseZones } from "../../web/editor/document/zones.ts";

const triangle = [
  [0.1, 0.1],
  [0.9, 0.1],
  [0.5, 0.9],
];
const zone = (fields: object = {}) => ({ id: "front", shape: { kind: "uv", polygon: triangle }, ...fields });
const file = (zones: unknown, more: object = {}) => ({ texelcastZones: 1, zones, ...more });

const accepts = new Ajv2020({ strict: true }).compile(zonesJsonSchema());

function refusal(source: unknown): TexelcastError {
  try {
    parseZones(source, "mug.zones.json");
  } catch (error) {
    if (error instanceof TexelcastError) return error;
    throw error;
  }
  throw new Error("The zones were not refused.");
}

describe("a zones file", () => {
  it("gets a default for each field that it leaves out", () => {
    expect(parseZones(JSON.stringify(file([zone()])))).toEqual({
      texelcastZones: 1,
      printScale: 1,
      dpi: { least: 150, good: 300 },
      zones: [
        {
          id: "front",
          name: "front",
          material: 0,
          shape: { kind: "uv", polygon: triangle },
          safe: 0,
          bleed: 0,
          policy: "clip",
        },
      ],
    });
  });

  it("may have a box of model space for a zone, unturned where it names no rotation", () => {
    const shape = { kind: "box", position: [0, 1, 0], size: [1, 2, 3] };
    expect(parseZones(file([zone({ shape })])).zones[0]?.shape).toEqual({ ...shape, rotation: [0, 0, 0, 1] });
  });

  it.each<[string, unknown, string, string]>([
    ["another version", file([], { texelcastZones: 2 }), "texelcastZones", "must be 1"],
    ["a field that is not known", file([zone({ colour: 1 })]), "zones[0].colour", "is not a known field"],
    ["a negative bleed", file([zone({ bleed: -1 })]), "zones[0].bleed", "must be a number from 0"],
    [
      "a corner outside the texture",
      file([zone({ shape: { kind: "uv", polygon: [...triangle, [2, 0]] } })]),
      "zones[0].shape.polygon[3][0]",
      "from 0 to 1",
    ],
    [
      "two corners alone",
      file([zone({ shape: { kind: "uv", polygon: triangle.slice(1) } })]),
      "zones[0].shape.polygon",
      "three corners",
    ],
    [
      "corners on one line",
      file([
        zone({
          shape: {
            kind: "uv",
            polygon: [
              [0, 0],
              [0.5, 0.5],
              [1, 1],
            ],
          },
        }),
      ]),
      "zones[0].shape.polygon",
      "must enclose an area",
    ],
    ["a policy of its own", file([zone({ policy: "cut" })]), "zones[0].policy", '"clip", "warn"'],
    ["two zones of one id", file([zone(), zone()]), "zones", "two zones of one id"],
    ["a reserved id", file([zone({ id: "__proto__" })]), "zones[0].id", "must not be"],
    ["a print scale of 0", file([], { printScale: 0 }), "printScale", "above 0"],
    ["a least DPI above the good one", file([], { dpi: { least: 300, good: 100 } }), "dpi", "above its"],
    ["no zones", { texelcastZones: 1 }, "zones", "is missing"],
  ])("is refused with %s, by the path and the value", (_what, source, field, message) => {
    const error = refusal(source);
    expect(error).toMatchObject({ code: "bad-zones", subject: "mug.zones.json", field });
    expect(error.message).toContain(message);
  });

  it("is refused where it is not JSON", () => {
    expect(refusal("{ zones").message).toContain("not valid JSON");
  });

  it("is refused with a key that stands twice in one object, by its path", () => {
    const twice = '{"texelcastZones":1,"dpi":{"least":100,"least":50},"zones":[]}';
    expect(refusal(twice)).toMatchObject({ code: "bad-zones", subject: "mug.zones.json", field: "dpi.least" });
    expect(refusal(twice).message).toBe("dpi.least: stands twice in one object");
    expect(parseZones('\ufeff{"texelcastZones":1,"zones":[]}').zones).toEqual([]);
  });

  it("is accepted by its published JSON Schema as by its reader", () => {
    expect(accepts(file([zone()]))).toBe(true);
    expect(accepts(file([zone({ bleed: -1 })]))).toBe(false);
    expect(accepts(file([zone({ colour: 1 })]))).toBe(false);
  });
});
