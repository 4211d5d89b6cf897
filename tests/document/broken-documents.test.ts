import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { parseDesign } from "../../web/editor/document/index.ts";
import { parseZones } from "../../web/editor/document/zones.ts";

const planar = { kind: "planar", position: [0, 1, 0], rotation: [0, 0, 0, 1], size: [0.2, 0.2, 0.1] };
const cylindrical = {
  kind: "cylindrical",
  position: [0, 1, 0],
  rotation: [0, 0, 0, 1],
  radius: 1,
  height: 1,
  arc: 90,
  depth: 0.1,
};
const perspective = {
  kind: "perspective",
  position: [0, 1, 0],
  rotation: [0, 0, 0, 1],
  fov: 30,
  aspect: 1,
  near: 0.1,
  far: 2,
};
const stops = [
  { offset: 0, color: "#000000" },
  { offset: 1, color: "#ffffff80" },
];
const linear = { kind: "linear", from: [0, 0, 0], to: [0, 1, 0], stops };
const radial = { kind: "radial", center: [0, 0, 0], radius: 1, stops };

/** Every field that a design may have, each once at least. */
const DESIGN = {
  format: "texelcast-design",
  version: 1,
  assets: { logo: { type: "image/png", uri: "logo.png" }, sans: { type: "font/ttf", uri: "sans.ttf" } },
  layers: [
    {
      id: "a",
      type: "decal",
      name: "Logo",
      material: 0,
      visible: true,
      opacity: 1,
      blend: "normal",
      blendSpace: "srgb",
      lockAlpha: false,
      locked: false,
      asset: "logo",
      filter: "linear",
      wrap: "none",
      flipX: false,
      flipY: false,
      backfaces: false,
      angleFade: [70, 90],
      occlusion: "self",
      projector: planar,
      mirror: { axis: "x", offset: 0, readable: true },
      mask: { layers: [{ type: "fill", color: "#000000", gradient: radial }], invert: false, linked: true },
    },
    {
      type: "text",
      text: "Hello",
      font: "sans",
      fontSize: 0.1,
      letterSpacing: 0,
      align: "left",
      curve: 0,
      color: "#000000",
      outline: { color: "#ffffff", width: 0.1 },
      projector: cylindrical,
    },
    { type: "decal", asset: "logo", projector: perspective },
    { type: "decal", asset: "logo", projector: { kind: "uv", center: [0, 0], size: [1, 1], angle: 0 } },
    { type: "stroke", brush: { tip: "round", color: "#000000", hardness: 1, flow: 1 }, dabs: [{ ...planar, flow: 1 }] },
    { type: "fill", color: "#000000", gradient: linear, parts: { kind: "charts", charts: [0] } },
    {
      type: "group",
      isolated: true,
      layers: [
        {
          type: "paint",
          strokes: [{ type: "stroke", brush: { tip: "picture", asset: "logo", color: null }, dabs: [cylindrical] }],
        },
      ],
    },
  ],
};

const ZONES = {
  texelcastZones: 1,
  printScale: 1,
  dpi: { least: 150, good: 300 },
  zones: [
    {
      id: "front",
      name: "Front",
      material: 0,
      shape: {
        kind: "uv",
        polygon: [
          [0, 0],
          [1, 0],
          [1, 1],
        ],
      },
      safe: 1,
      bleed: 1,
      policy: "clip",
    },
    { id: "back", shape: { kind: "box", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] } },
  ],
};

/** Not there at all. */
const GONE = Symbol("gone");
const STRANGE: readonly unknown[] = [
  GONE,
  null,
  true,
  -1,
  0.5,
  1e300,
  Number.NaN,
  Number.POSITIVE_INFINITY,
  "",
  "NaN",
  "x".repeat(10_000),
  [],
  [null],
  {},
  { any: 1 },
];

type Step = string | number;

function placesIn(value: unknown, path: readonly Step[] = []): (readonly Step[])[] {
  if (typeof value !== "object" || value === null) return [];
  const keys: Step[] = Array.isArray(value) ? [...value.keys()] : Object.keys(value);
  return keys.flatMap((key) => {
    const place = [...path, key];
    return [place, ...placesIn((value as Record<Step, unknown>)[key], place)];
  });
}

function withValue(document: object, path: readonly Step[], value: unknown): unknown {
  const copy = structuredClone(document);
  let parent = copy as Record<Step, unknown>;
  for (const key of path.slice(0, -1)) parent = parent[key] as Record<Step, unknown>;
  const last = path.at(-1) ?? "";
  if (value !== GONE) parent[last] = structuredClone(value);
  else if (Array.isArray(parent)) parent.splice(last as number, 1);
  else delete parent[last];
  return copy;
}

/** One fault: its path, and what must be there. */
const FAULT = /^[a-zA-Z][\w.[\]" ]*: (is missing: )?(must |is not a known field \(known here: ).+$/s;
/** Words of the library that checks, or of JavaScript. */
const RAW = /Invalid|Expected|received|undefined|\[object|of null|is not a function/;

function faultsOf(document: object, parse: (source: unknown, name: string) => unknown): string[] {
  const faults: string[] = [];
  for (const place of placesIn(document)) {
    for (const value of STRANGE) {
      try {
        parse(withValue(document, place, value), "broken.json");
      } catch (error) {
        const isClear =
          error instanceof TexelcastError &&
          error.subject === "broken.json" &&
          error.field !== undefined &&
          error.hint !== undefined &&
          error.message.length < 2000 &&
          error.message.split("; ").every((fault) => FAULT.test(fault)) &&
          !RAW.test(error.message);
        if (!isClear) faults.push(`${place.join(".")} = ${String(value).slice(0, 20)}: ${String(error).slice(0, 300)}`);
      }
    }
  }
  return faults;
}

describe("a document with a wrong value somewhere", () => {
  it("is a design that is read, or refused by each field's path and what must stand there", () => {
    expect(() => parseDesign(DESIGN)).not.toThrow();
    expect(faultsOf(DESIGN, parseDesign)).toEqual([]);
  });

  it("is a zones file that is read, or refused by each field's path and what must stand there", () => {
    expect(() => parseZones(ZONES)).not.toThrow();
    expect(faultsOf(ZONES, parseZones)).toEqual([]);
  });

  it("names the stops of a gradient that fall back, with their offsets", () => {
    const falling = [0.5, 0.4, 0.6, 0.1].map((offset) => ({ offset, color: "#000000" }));
    const fill = { type: "fill", color: "#000000", gradient: { ...linear, stops: falling } };
    expect(() => parseDesign({ format: "texelcast-design", version: 1, layers: [fill] })).toThrow(
      "layers[0].gradient.stops[1].offset: must not fall back in offset from one stop to the next, is 0.4; " +
        "layers[0].gradient.stops[3].offset: must not fall back in offset from one stop to the next, is 0.1",
    );
  });

  it("says of a fill's colour that is missing that it stands beside a gradient, too", () => {
    const fill = { type: "fill", gradient: linear };
    expect(() => parseDesign({ format: "texelcast-design", version: 1, layers: [fill] })).toThrow(
      'layers[0].color: is missing: must be a colour as "#rrggbb" or "#rrggbbaa", which shows where there is no gradient, and is kept beside one',
    );
  });
});
