import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { parseDesign, parseZones } from "../../web/editor/document/index.ts";
import { readProjectFile, writeProjectFile } from "../../web/editor/document/project-file.ts";

const at = { position: [0, 0, 0], rotation: [0, 0, 0, 1] };
const planar = { kind: "planar", ...at, size: [1, 1, 1] };
const eye = { kind: "perspective", ...at, fov: 40, aspect: 1, near: 1, far: 2 };
const label = { kind: "cylindrical", ...at, radius: 1, height: 1, arc: 90, depth: 1 };
const triangle = [
  [0, 0],
  [1, 0],
  [0, 1],
];
const picture = { type: "image/png", uri: "logo.png" };
const font = { type: "font/ttf", uri: "serif.ttf" };

const list = <T>(length: number, make: (index: number) => T): T[] => Array.from({ length }, (_, index) => make(index));
const design = (layers: readonly object[], assets: object = { picture, font }) =>
  parseDesign({ format: "texelcast-design", version: 1, assets, layers });
const decal = (fields: object) => design([{ type: "decal", asset: "picture", projector: planar, ...fields }]);
const fill = (fields: object) => design([{ type: "fill", color: "#102030", ...fields }]);
const written = (fields: object) => design([{ type: "text", text: "a", font: "font", projector: planar, ...fields }]);
const stops = (count: number) => list(count, (index) => ({ offset: index / count, color: "#000000" }));
const stacked = (levels: number): object =>
  levels === 1 ? { type: "fill", color: "#102030" } : { type: "group", layers: [stacked(levels - 1)] };
const zones = (fields: object, more: object = {}) =>
  parseZones({
    texelcastZones: 1,
    zones: [{ id: "front", shape: { kind: "uv", polygon: triangle }, ...fields }],
    ...more,
  });
const target = (fields: object) => {
  const targets = [{ material: 0, size: 512, gutter: null, ...fields }];
  const model = { title: "Mug", demo: "mug", source: null };
  const content = { name: "Cup", design: design([]), assetBytes: () => Uint8Array.of(1), targets, model };
  return readProjectFile(writeProjectFile(content), "cup.texelcast");
};

/** A number as the engine has it, and the next one above it. */
const next32 = (value: number): number => {
  const bits = new DataView(new ArrayBuffer(4));
  bits.setFloat32(0, value);
  bits.setUint32(0, bits.getUint32(0) + 1);
  return bits.getFloat32(0);
};

/** As the documents under docs/ tell them, not as the code counts them: what is just allowed, and what is just not. */
const LIMITS: readonly (readonly [string, string, (value: number) => unknown, number, number])[] = [
  [
    "a design's assets",
    "assets",
    (n) => design([], Object.fromEntries(list(n, (i) => [`a${i}`, picture]))),
    10_000,
    10_001,
  ],
  ["a design's layers", "layers", (n) => design(list(n, () => ({ type: "fill", color: "#102030" }))), 10_000, 10_001],
  ["its levels", "layers[0]", (n) => design([stacked(n)]), 16, 17],
  ["an id's characters", "layers[0].id", (n) => fill({ id: "🎈".repeat(n) }), 200, 201],
  ["a name's characters", "layers[0].name", (n) => fill({ name: "🎈".repeat(n) }), 1000, 1001],
  ["a text's characters", "layers[0].text", (n) => written({ text: "🎈".repeat(n) }), 10_000, 10_001],
  ["a text's letter spacing, apart", "layers[0].letterSpacing", (n) => written({ letterSpacing: n }), 10, 10.001],
  ["a text's letter spacing, together", "layers[0].letterSpacing", (n) => written({ letterSpacing: n }), -1, -1.001],
  ["a text's curve", "layers[0].curve", (n) => written({ curve: n }), 360, 360.001],
  ["a text's curve the other way", "layers[0].curve", (n) => written({ curve: n }), -360, -360.001],
  [
    "a gradient's stops",
    "layers[0].gradient.stops",
    (n) => fill({ gradient: { kind: "radial", center: [0, 0, 0], radius: 1, stops: stops(n) } }),
    16,
    17,
  ],
  [
    "a gradient's fewest stops",
    "layers[0].gradient.stops",
    (n) => fill({ gradient: { kind: "radial", center: [0, 0, 0], radius: 1, stops: stops(n) } }),
    2,
    1,
  ],
  [
    "a chart's index",
    "layers[0].parts.charts[0]",
    (n) => fill({ parts: { kind: "charts", charts: [n] } }),
    2 ** 32 - 1,
    2 ** 32,
  ],
  ["a material's index", "layers[0].material", (n) => fill({ material: n }), 65_535, 65_536],
  ["an opacity", "layers[0].opacity", (n) => fill({ opacity: n }), 1, 1.001],
  [
    "a coordinate",
    "layers[0].projector.position[1]",
    (n) => decal({ projector: { ...planar, position: [0, n, 0] } }),
    -1e9,
    -1.001e9,
  ],
  [
    "a length, at its largest",
    "layers[0].projector.size[2]",
    (n) => decal({ projector: { ...planar, size: [1, 1, n] } }),
    1e9,
    1.001e9,
  ],
  [
    "a length, at its smallest",
    "layers[0].projector.size[0]",
    (n) => decal({ projector: { ...planar, size: [n, 1, 1] } }),
    1e-9,
    0.999e-9,
  ],
  [
    "a rotation's length, at its largest",
    "layers[0].projector.rotation",
    (n) => decal({ projector: { ...planar, rotation: [0, n, 0, 0] } }),
    1000,
    1000.1,
  ],
  [
    "a rotation's length, at its smallest",
    "layers[0].projector.rotation",
    (n) => decal({ projector: { ...planar, rotation: [0, n, 0, 0] } }),
    1e-3,
    0.99e-3,
  ],
  ["a fade's angle", "layers[0].angleFade[1]", (n) => decal({ angleFade: [70, n] }), 90, 90.001],
  [
    "a field of view that 32 bits tell from half a turn",
    "layers[0].projector.fov",
    (n) => decal({ projector: { ...eye, fov: n } }),
    180 - 2 ** -17 - 2 ** -44,
    180 - 2 ** -17,
  ],
  [
    "an angle that 32 bits tell from nothing",
    "layers[0].projector.arc",
    (n) => decal({ projector: { ...label, arc: n } }),
    2 ** -150 * (1 + 2 ** -52),
    2 ** -150,
  ],
  ["an arc", "layers[0].projector.arc", (n) => decal({ projector: { ...label, arc: n } }), 360, 360.001],
  [
    "a far end beyond the near one",
    "layers[0].projector.far",
    (n) => decal({ projector: { ...eye, far: n } }),
    1 + 2 ** -52,
    1,
  ],
  [
    "a gradient's end that 32 bits tell from its start",
    "layers[0].gradient.to",
    (n) => fill({ gradient: { kind: "linear", from: [1, 1, 1], to: [1, n, 1], stops: stops(2) } }),
    next32(1),
    1 + 2 ** -30,
  ],
  ["a zone's bleed in millimetres", "zones[0].bleed", (n) => zones({ bleed: n }), 10_000, 10_000.1],
  ["a zone's safe edge in millimetres", "zones[0].safe", (n) => zones({ safe: n }), 10_000, 10_000.1],
  [
    "a zone's corners",
    "zones[0].shape.polygon",
    (n) => zones({ shape: { kind: "uv", polygon: list(n, (i) => triangle[i % 3]) } }),
    1000,
    1001,
  ],
  [
    "a product's zones",
    "zones",
    (n) => zones({}, { zones: list(n, (i) => ({ id: `z${i}`, shape: { kind: "uv", polygon: triangle } })) }),
    100,
    101,
  ],
  ["a print's best dots an inch", "dpi.good", (n) => zones({}, { dpi: { good: n } }), 10_000, 10_001],
  ["a print's least dots an inch", "dpi.least", (n) => zones({}, { dpi: { least: n } }), 1, 0.999],
  ["a project's texture's texels", "targets[0].size", (n) => target({ size: n }), 8192, 8193],
  ["a project's smallest texture's texels", "targets[0].size", (n) => target({ size: n }), 1, 0],
  ["a project's gutter", "targets[0].gutter", (n) => target({ gutter: n }), 64, 65],
  ["a project's material's index", "targets[0].material", (n) => target({ material: n }), 65_535, 65_536],
];

describe("a limit", () => {
  it.each(LIMITS)(
    "of %s is itself allowed, and what lies beyond refused by its path",
    (_what, place, read, allowed, refused) => {
      expect(() => read(allowed)).not.toThrow();
      let error: unknown;
      try {
        read(refused);
      } catch (thrown) {
        error = thrown;
      }
      expect(error).toBeInstanceOf(TexelcastError);
      const { field, message } = error as TexelcastError;
      expect(`${field} ${message}`).toContain(place);
    },
  );
});
