import { createRequire } from "node:module";
import { Ajv2020 } from "ajv/dist/2020.js";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { designJsonSchema } from "../../scripts/schema/design-json-schema.ts";
import { LAYER_DEFAULTS, PICTURE_DEFAULTS, PROJECTED_DEFAULTS, parseDesign } from "../../web/editor/document/index.ts";
import { texelcast } from "../node/run-cli.ts";
import { arbitraryDesign } from "./arbitrary-design.ts";

const require = createRequire(import.meta.url);
const ajv = new Ajv2020({ strict: true, allErrors: false });
const accepts = ajv.compile(designJsonSchema());

const planar = { kind: "planar", position: [0, 1.2, 0.1], rotation: [0, 0, 0, 1], size: [0.2, 0.2, 0.1] };
const eye = {
  kind: "perspective",
  position: [0, 0, 1],
  rotation: [0, 0, 0, 1],
  fov: 40,
  aspect: 1,
  near: 0.1,
  far: 2,
};
const label = {
  kind: "cylindrical",
  position: [0, 0, 0],
  rotation: [0, 0, 0, 1],
  radius: 1,
  height: 1,
  arc: 90,
  depth: 1,
};
const stamp = { kind: "uv", center: [0.5, 0.5], size: [0.1, 0.1], angle: 0 };
const assets = { logo: { type: "image/png", uri: "logo.png" }, serif: { type: "font/ttf", uri: "serif.ttf" } };

const design = (layers: unknown, more: object = {}) => ({
  format: "texelcast-design",
  version: 1,
  assets,
  layers,
  ...more,
});
const decal = (fields: object = {}) => design([{ type: "decal", asset: "logo", projector: planar, ...fields }]);
const fill = (fields: object = {}) => design([{ type: "fill", color: "#102030", ...fields }]);

/** What the reader says of a document; "" where it reads it. */
function problemOf(value: unknown): string {
  try {
    parseDesign(value);
    return "";
  } catch (thrown) {
    return (thrown as Error).message;
  }
}
const isRead = (value: unknown): boolean => problemOf(value) === "";

/** What may stand wrongly anywhere: values at a bound's two sides, and of every other kind. */
const ODD_VALUES: readonly unknown[] = [
  ...[0, 1, -1, 0.5, 2 ** -150, 2 ** -149, 1e-9, 9e-10, 1e9, 1.1e9, 90, 91, 179.99999, 180 - 2 ** -17, 180, 360, 361],
  ...[10, 11, 65_535, 65_536, 0xffff_ffff, 2 ** 32, 1e-40, 1e300],
  ...["", "x", "#102030", "#1020304", "🎈".repeat(200), "🎈".repeat(201), "🎈".repeat(1001), "\udc00".repeat(201)],
  ...["constructor", "toString", "normal", "uv", "planar", "font/ttf", "round", "picture"],
  ...["texelcast:fonts/inter-700", "texelcast:fonts/comic-700"],
  ...[null, true, false, [], {}, [0], [0, 0], [0, 0, 0], [0, 0, 0, 1], [0, 0, 0, 0], [45, 30], ["a"], { kind: "uv" }],
  undefined,
];

/** What only the reader's code can see; the document tells the half of it and the schema's descriptions the other. */
const IN_WORDS =
  /must be unique|must name one of the design's assets|must name a picture,|must name a font,|must not end before it starts|must not be all zeros|must be a unit quaternion|must be above near|must be null|must not be where from is|must not fall back in offset/;

/** A copy with the value at one of its places changed, or taken away where the new one is undefined. */
function withOddValue(document: unknown, place: number, odd: unknown): unknown {
  const copy = structuredClone(document);
  const places: { readonly holder: Record<string, unknown>; readonly key: string }[] = [];
  const visit = (holder: unknown): void => {
    if (typeof holder !== "object" || holder === null) return;
    for (const [key, value] of Object.entries(holder)) {
      places.push({ holder: holder as Record<string, unknown>, key });
      visit(value);
    }
  };
  visit(copy);
  const { holder, key } = places[place % places.length] as (typeof places)[number];
  if (odd !== undefined) holder[key] = odd;
  else if (Array.isArray(holder)) holder.splice(Number(key), 1);
  else delete holder[key];
  return copy;
}

describe("the design document's JSON Schema", () => {
  it("is a valid schema of its draft", () => {
    const schema = designJsonSchema();
    expect(schema.$schema).toBe("https://json-schema.org/draft/2020-12/schema");
    expect(ajv.validateSchema(schema)).toBe(true);
  });

  it("accepts every design that can be written", () => {
    fc.assert(
      fc.property(arbitraryDesign, (value) => {
        expect(accepts(value) || accepts.errors).toBe(true);
        expect(isRead(value)).toBe(true);
      }),
      { numRuns: 200 },
    );
  });

  it.each([
    ["the narrowest field of view", decal({ projector: { ...eye, fov: 2 ** -149 } })],
    ["the widest field of view", decal({ projector: { ...eye, fov: 179.99999 } })],
    ["the narrowest arc", decal({ projector: { ...label, arc: 2 ** -149 } })],
    ["an id of 200 characters beyond the first plane", decal({ id: "🎈".repeat(200) })],
    ["a name of half characters", decal({ name: "\ud83c".repeat(1000) })],
    ["an asset named toString", design([], { assets: { toString: assets.logo } })],
    [
      "a font that comes along",
      design([], { assets: { serif: { type: "font/ttf", uri: "texelcast:fonts/inter-700" } } }),
    ],
  ])("accepts %s, as the reader does", (_what, value) => {
    expect(accepts(value) || accepts.errors).toBe(true);
    expect(isRead(value)).toBe(true);
  });

  it("judges any design with something put wrong as the reader does, but for what it tells in words", () => {
    fc.assert(
      fc.property(arbitraryDesign, fc.nat(), fc.constantFrom(...ODD_VALUES), (value, place, odd) => {
        const changed = withOddValue(value, place, odd);
        if (accepts(changed)) expect(problemOf(changed)).toSatisfy((told) => told === "" || IN_WORDS.test(told));
        else expect(isRead(changed)).toBe(false);
      }),
      { numRuns: 1000 },
    );
  });

  it("asks for no field that has a default, and tells each default", () => {
    for (const value of [
      { format: "texelcast-design", version: 1 },
      ...[planar, eye, label, stamp].map((projector) => decal({ projector })),
      design([{ type: "text", text: "Hello", font: "serif", projector: planar }]),
      fill(),
    ]) {
      expect(accepts(value) || accepts.errors).toBe(true);
      expect(isRead(value)).toBe(true);
    }
    const { decal: shape } = designJsonSchema().$defs as Record<string, { properties: Record<string, object> }>;
    for (const [field, value] of Object.entries({ ...LAYER_DEFAULTS, ...PROJECTED_DEFAULTS, ...PICTURE_DEFAULTS })) {
      expect(shape?.properties[field], field).toMatchObject({ default: value });
    }
  });

  it.each<[string, unknown]>([
    ["a list", []],
    ["another format", { format: "blend", version: 1 }],
    ["no version", { format: "texelcast-design" }],
    ["a newer version", { format: "texelcast-design", version: 2 }],
    ["an unknown field", { ...decal(), author: "me" }],
    ["a $schema field", { $schema: "design.schema.json", ...decal() }],
    ["an unknown layer field", decal({ opacty: 1 })],
    ["a field of another layer type", fill({ asset: "logo" })],
    ["an unknown projector field", decal({ projector: { ...planar, fov: 3 } })],
    ["layers that are no list", design({})],
    ["a layer that is no object", design(["decal"])],
    ["a layer without a type", design([{}])],
    ["an unknown layer type", design([{ type: "logo" }])],
    ["a decal without a projector", design([{ type: "decal", asset: "logo" }])],
    ["a decal without an asset", design([{ type: "decal", projector: planar }])],
    ["an unknown projector", decal({ projector: { ...planar, kind: "sphere" } })],
    ["a size of two numbers", decal({ projector: { ...planar, size: [1, 1] } })],
    ["a size of four numbers", decal({ projector: { ...planar, size: [1, 1, 1, 1] } })],
    ["a size below zero", decal({ projector: { ...planar, size: [1, -3, 1] } })],
    ["a size that 32 bits cannot hold", decal({ projector: { ...planar, size: [1, 1, 1e-40] } })],
    ["a position too far away", decal({ projector: { ...planar, position: [0, 2e9, 0] } })],
    ["a position of text", decal({ projector: { ...planar, position: ["0", 0, 0] } })],
    ["a field of view of half a turn", decal({ projector: { ...eye, fov: 180 } })],
    ["an arc above a whole turn", decal({ projector: { ...label, arc: 361 } })],
    ["an arc of nothing", decal({ projector: { ...label, arc: 0 } })],
    ["an arc that 32 bits take for nothing", decal({ projector: { ...label, arc: 2 ** -150 } })],
    ["a field of view that 32 bits take for nothing", decal({ projector: { ...eye, fov: 2 ** -150 } })],
    ["a field of view that 32 bits take for half a turn", decal({ projector: { ...eye, fov: 180 - 2 ** -17 } })],
    ["a stamp without an angle", decal({ projector: { kind: "uv", center: [0, 0], size: [1, 1] } })],
    ["an opacity above 1", decal({ opacity: 1.5 })],
    ["an opacity as text", decal({ opacity: "1" })],
    ["null where a default could be", decal({ visible: null })],
    ["an unknown blend mode", decal({ blend: "add" })],
    ["an unknown filter", decal({ filter: "cubic" })],
    ["a fade beyond 90 degrees", decal({ angleFade: [80, 100] })],
    ["a material of half a number", decal({ material: 0.5 })],
    ["a material below zero", decal({ material: -1 })],
    ["a material past the last", decal({ material: 65_536 })],
    ["a material by name", decal({ material: "body" })],
    ["a list of no materials", decal({ material: [] })],
    ["a list with half a material", decal({ material: [0, 0.5] })],
    ["a material twice", decal({ material: [0, 0] })],
    ["an empty id", decal({ id: "" })],
    ["an id of 201 characters", decal({ id: "x".repeat(201) })],
    ["an id of 201 characters beyond the first plane", decal({ id: "🎈".repeat(201) })],
    ["a colour by name", fill({ color: "red" })],
    ["a colour of four digits", fill({ color: "#1234" })],
    ["a fill without a colour", design([{ type: "fill" }])],
    ["assets in a list", design([], { assets: [1] })],
    ["an asset of another type", design([], { assets: { logo: { type: "image/bmp", uri: "a" } } })],
    ["an asset without an address", design([], { assets: { logo: { type: "image/png" } } })],
    ["an asset without a name", design([], { assets: { "": assets.logo } })],
    ["an asset named constructor", design([], { assets: { constructor: assets.logo } })],
    ["an asset named __proto__", design([], { assets: JSON.parse('{"__proto__":{"type":"image/png","uri":"a"}}') })],
    [
      "a font that comes along, as a picture",
      design([], { assets: { logo: { type: "image/png", uri: "texelcast:fonts/inter-700" } } }),
    ],
    [
      "a font that does not come along",
      design([], { assets: { serif: { type: "font/ttf", uri: "texelcast:fonts/comic-700" } } }),
    ],
    ["an outline of a word", design([{ type: "text", text: "a", font: "serif", projector: planar, outline: "red" }])],
    ["10,001 layers", design(new Array(10_001).fill({ type: "fill", color: "#000000" }))],
  ])("refuses %s, as the reader does", (_what, value) => {
    expect(accepts(value)).toBe(false);
    expect(isRead(value)).toBe(false);
  });

  it.each<[string, unknown, RegExp]>([
    ["a fade that ends before it starts", decal({ angleFade: [80, 70] }), /must not end before it starts/],
    [
      "a rotation of zeros",
      decal({ projector: { ...planar, rotation: [0, 0, 0, 0] } }),
      /must not be all zeros.*unit quaternion/,
    ],
    ["an eye whose far lies before its near", decal({ projector: { ...eye, far: 0.01 } }), /must be above near/],
    [
      "two layers of one id",
      design([fill({ id: "a" }).layers, fill({ id: "a" }).layers].flat()),
      /ids that occur twice/,
    ],
    ["an asset that is not there", decal({ asset: "lago" }), /assets that are not there/],
  ])("tells in words what it cannot check: %s", (_what, value, told) => {
    expect(accepts(value)).toBe(true);
    expect(isRead(value)).toBe(false);
    expect(JSON.stringify(designJsonSchema())).toMatch(told);
  });

  it("is what the build writes, the package exports and the command line prints", async () => {
    const file = require.resolve("texelcast/design.schema.json");
    expect(file).toMatch(/build[/\\]design\.schema\.json$/);
    expect(require(file)).toEqual(designJsonSchema());
    const { code, stdout, stderr } = await texelcast(["schema"]);
    expect({ code, stderr, schema: JSON.parse(stdout) }).toEqual({ code: 0, stderr: "", schema: designJsonSchema() });
  });
});
