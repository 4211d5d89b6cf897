import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { type DecalLayer, emptyDesign, parseDesign, serialiseDesign } from "../../web/editor/document/index.ts";
import { migrateDesign } from "../../web/editor/document/parse-design.ts";
import { arbitraryDesign } from "./arbitrary-design.ts";

const planar = { kind: "planar", position: [0, 1.2, 0.1], rotation: [0, 0, 0, 1], size: [0.2, 0.2, 0.1] };
const logo = { logo: { type: "image/png", uri: "logo.png" } };

function design(layers: unknown, assets: unknown = logo): Record<string, unknown> {
  return { format: "texelcast-design", version: 1, assets, layers };
}
const stroke = (fields: object = {}) => design([{ type: "stroke", brush: {}, dabs: [planar], ...fields }]);
const decal = (fields: object = {}) => design([{ type: "decal", asset: "logo", projector: planar, ...fields }]);

/** The error that reading the value gives. */
function refusal(value: unknown, name = "shirt.json"): TexelcastError {
  try {
    parseDesign(value, name);
  } catch (error) {
    if (error instanceof TexelcastError) return error;
    throw error;
  }
  throw new Error("the design was read without complaint");
}

describe("reading a design", () => {
  it("gives a layer of type, asset and projector alone the defaults of the specification", () => {
    const [layer] = parseDesign(decal(), "shirt.json").layers;
    expect(layer).toEqual({
      id: "layer-1",
      type: "decal",
      name: "logo",
      material: 0,
      visible: true,
      asset: "logo",
      opacity: 1,
      blend: "normal",
      blendSpace: "srgb",
      lockAlpha: false,
      locked: false,
      mask: null,
      mirror: null,
      filter: "linear",
      wrap: "none",
      flipX: false,
      flipY: false,
      backfaces: false,
      angleFade: [70, 90],
      occlusion: "self",
      projector: planar,
    });
  });

  it("gives a stroke of brush and dabs alone the defaults of the specification", () => {
    const [layer] = parseDesign(stroke()).layers;
    expect(layer).toEqual({
      id: "layer-1",
      type: "stroke",
      name: "Stroke",
      material: 0,
      visible: true,
      brush: { tip: "round", color: "#000000", hardness: 1, flow: 1 },
      opacity: 1,
      blend: "normal",
      blendSpace: "srgb",
      lockAlpha: false,
      locked: false,
      mask: null,
      mirror: null,
      filter: "linear",
      wrap: "none",
      flipX: false,
      flipY: false,
      backfaces: false,
      angleFade: [70, 90],
      occlusion: "self",
      dabs: [{ ...planar, flow: 1 }],
    });
    const [print] = parseDesign(stroke({ brush: { tip: "picture", asset: "logo" }, dabs: [] })).layers;
    expect(print).toMatchObject({ brush: { tip: "picture", asset: "logo", color: null, flow: 1 }, dabs: [] });
  });

  it("reads the specification's own example, from text, with a byte order mark before it", () => {
    const text = JSON.stringify({ ...decal({ id: "a1", name: "Logo" }) });
    expect(parseDesign(`\ufeff${text}`).layers[0]).toMatchObject({ id: "a1", name: "Logo" });
  });

  it("takes a design without assets and layers for an empty one", () => {
    expect(parseDesign({ format: "texelcast-design", version: 1 })).toEqual(emptyDesign());
  });

  it("makes up ids by place, and goes round those that are taken", () => {
    const fill = { type: "fill", color: "#102030" };
    const read = parseDesign(design([fill, { ...fill, id: "layer-1" }, fill, { ...fill, id: "layer-3" }, fill]));
    expect(read.layers.map((layer) => layer.id)).toEqual(["layer-2", "layer-1", "layer-4", "layer-3", "layer-5"]);
    expect(new Set(read.layers.map((layer) => layer.id)).size).toBe(5);
  });

  it("accepts a hard angle: a fade that starts and ends at 90 degrees", () => {
    expect((parseDesign(decal({ angleFade: [90, 90] })).layers[0] as DecalLayer).angleFade).toEqual([90, 90]);
  });

  it("keeps a list of materials as it is", () => {
    expect(parseDesign(decal({ material: [3, 0] })).layers[0]?.material).toEqual([3, 0]);
    expect(serialiseDesign(parseDesign(decal({ material: [3, 0] })))).toContain('"material": [3, 0],');
  });

  it("does not share its defaults between layers", () => {
    const layers = parseDesign(design([decal().layers, decal().layers].flat())).layers as DecalLayer[];
    expect(layers[0]?.angleFade).not.toBe(layers[1]?.angleFade);
  });
});

describe("writing a design", () => {
  it("is undone by reading, for every design", () => {
    fc.assert(
      fc.property(arbitraryDesign, (original) => {
        expect(parseDesign(serialiseDesign(original))).toEqual(original);
      }),
      { numRuns: 200 },
    );
  });

  it("does not hang on the order of the object's keys", () => {
    const read = parseDesign(decal());
    const reversed = { ...read, layers: read.layers.map((layer) => reverseKeys(layer)) };
    expect(serialiseDesign(reversed as typeof read)).toBe(serialiseDesign(read));
  });

  it("puts coordinates on one line and leaves text alone that looks like a list", () => {
    const text = serialiseDesign(parseDesign(decal({ name: "[ 1,  2 ]" })));
    expect(text).toContain('"position": [0, 1.2, 0.1]');
    expect(text).toContain('"name": "[ 1,  2 ]"');
  });
});

const reverseKeys = (value: object): object => Object.fromEntries(Object.entries(value).reverse());

describe("refusing a design", () => {
  it("names file, place, value and what must stand there", () => {
    const error = refusal(decal({ projector: { ...planar, size: [1, -3, 1] } }));
    expect(error.code).toBe("bad-design");
    expect(error.subject).toBe("shirt.json");
    expect(error.field).toBe("layers[0].projector.size[1]");
    expect(error.value).toBe("-3");
    expect(error.message).toBe("layers[0].projector.size[1]: must be above 0, is -3");
  });

  it("tells all problems at once", () => {
    const { message } = refusal(
      design([
        { type: "decal", asset: "logo", opacity: 2, wrap: "mirror", projector: { ...planar, position: [0, 0] } },
      ]),
    );
    expect(message).toBe(
      "layers[0].opacity: must be a number from 0 to 1, is 2; " +
        'layers[0].wrap: must be one of "none", "repeat", is "mirror"; ' +
        "layers[0].projector.position: must be a list of 3 numbers, is [0, 0]",
    );
  });

  it("takes a hundred unknown fields of one object for enough of them", () => {
    const unknown = Object.fromEntries(Array.from({ length: 900 }, (_, at) => [`field${at}`, at]));
    const { message, field } = refusal({ format: "texelcast-design", version: 1, layers: [], ...unknown });
    expect(field).toBe("field0");
    expect(message.split("; ")).toHaveLength(21);
    expect(message).toMatch(/; and 80 more$/);
  });

  it("names every key that stands twice in one object: programs do not agree which of the two holds", () => {
    const error = refusal(
      '{"format":"texelcast-design","version":1,"assets":{"a\\"b":{"type":"image/png","uri":"a\\\\"},"a\\u0022b":{"type":"image/png",' +
        '"uri":"{"}},"layers":[{"type":"fill","color":"#000000"},{"type":"fill","color":"#000000","opacity":1,"mask":{"layers":[],' +
        '"invert":true,"invert":false},"opacity":0.5}]}',
    );
    expect(error.code).toBe("bad-design");
    expect(error.message).toBe(
      'assets["a\\"b"]: stands twice in one object; layers[1].mask.invert: stands twice in one object; ' +
        "layers[1].opacity: stands twice in one object",
    );
    expect(error.field).toBe('assets["a\\"b"]');
  });

  it("takes one key in several objects, and a text like a key, for nothing that stands twice", () => {
    const text =
      '{"format":"texelcast-design","version":1,"layers":[{"type":"fill","color":"#000000","name":"opacity"},' +
      '{"type":"fill","color":"#000000","name":"{\\"id\\":1,\\"id\\":2}\\\\","opacity":1}]}';
    expect(parseDesign(text).layers.map(({ name }) => name)).toEqual(["opacity", '{"id":1,"id":2}\\']);
  });

  it("stops telling after twenty problems and counts the rest", () => {
    const { message } = refusal(design(Array.from({ length: 1000 }, () => ({ type: "fill", color: "red" }))));
    expect(message.split("; ")).toHaveLength(21);
    expect(message).toMatch(/; and 980 more$/);
  });

  it("takes fifty layers without their picture for enough of them", () => {
    const lost = { type: "decal", asset: "nowhere", projector: planar };
    const { message } = refusal(design(new Array(900).fill(lost)));
    expect(message.split("; ")).toHaveLength(21);
    expect(message).toMatch(/; and 30 more$/);
  });

  it("refuses a stroke of a million dabs without reading them", () => {
    const error = refusal(stroke({ dabs: new Array(1_000_000).fill({}) }));
    expect(error.message).toBe("layers[0].dabs: must not hold more than 100000 dabs, is a list of 1000000");
  });

  it("tells of a hundred thousand faulty dabs as of one", () => {
    const { message } = refusal(stroke({ dabs: new Array(100_000).fill({ kind: "planar" }) }));
    expect(message).toMatch(
      /^layers\[0\]\.dabs\[0\]\.position: is missing: must be a list of 3 numbers; .*; and 299980 more$/,
    );
  });

  it.each<[string, unknown, string]>([
    ["text that is not JSON", "{ format:", "the design is not valid JSON: "],
    ["a list", [], "the design must be a JSON object, is []"],
    ["null", null, "the design must be a JSON object, is null"],
    ["another format", { format: "blend" }, 'format: must be "texelcast-design", is "blend"'],
    ["no format", {}, 'format: is missing: must be "texelcast-design"'],
    ["no version", { format: "texelcast-design" }, "version: is missing: must be 1"],
    ["a newer version", { format: "texelcast-design", version: 2 }, "version: must be 1, is 2"],
    ["a version as text", { format: "texelcast-design", version: "1" }, 'version: must be 1, is "1"'],
    ["an unknown field", { ...decal(), author: "me" }, "author: is not a known field (known here: format, version, "],
    ["a list in the place of a brush", stroke({ brush: [] }), "layers[0].brush: must be an object, is []"],
    ["an unknown layer field", decal({ blur: 3 }), "layers[0].blur: is not a known field (known here: type, id, "],
    [
      "an unknown projector field",
      decal({ projector: { ...planar, fov: 3 } }),
      "layers[0].projector.fov: is not a known",
    ],
    ["a field named constructor", decal({ constructor: 1 }), "layers[0].constructor: is not a known field"],
    [
      "a field of another layer type",
      design([{ type: "fill", color: "#000000", asset: "logo" }]),
      "layers[0].asset: is",
    ],
    ["layers that are no list", design({}), "layers: must be a list, is an object"],
    ["a layer that is no object", design(["decal"]), 'layers[0]: must be an object, is "decal"'],
    [
      "a stroke in a paint layer that is no object",
      design([{ type: "paint", strokes: [null] }]),
      "layers[0].strokes[0]: must be an object, is null",
    ],
    ["a layer without a type", design([{}]), 'layers[0].type: is missing: must be one of "decal", "text", "stroke"'],
    [
      "an unknown type",
      design([{ type: "logo" }]),
      'layers[0].type: must be one of "decal", "text", "stroke", "fill", "group", "paint", is "',
    ],
    ["no projector", design([{ type: "decal", asset: "logo" }]), "layers[0].projector: is missing"],
    [
      "an unknown projector",
      decal({ projector: { kind: "sphere" } }),
      'layers[0].projector.kind: must be one of "planar"',
    ],
    ["no asset", design([{ type: "decal", projector: planar }]), "layers[0].asset: is missing"],
    [
      "an asset that is not there",
      decal({ asset: "lago" }),
      'layers[0].asset: must name one of the design\'s assets (there are: "logo"), is "lago"',
    ],
    [
      "an asset named as a method is",
      decal({ asset: "toString" }),
      "layers[0].asset: must name one of the design's assets",
    ],
    [
      "a rotation of zeros",
      decal({ projector: { ...planar, rotation: [0, 0, 0, 0] } }),
      "layers[0].projector.rotation: must not be all zeros",
    ],
    [
      "a number beyond all bounds",
      `{"format":"texelcast-design","version":1,"assets":{"logo":{"type":"image/png","uri":"a"}},"layers":[{"type":"decal","asset":"logo","projector":{"kind":"planar","position":[1e999,0,0],"rotation":[0,0,0,1],"size":[1,1,1]}}]}`,
      "layers[0].projector.position[0]: must be a number from -1000000000 to 1000000000, is Infinity",
    ],
    [
      "a number that is none",
      decal({ opacity: Number.NaN }),
      "layers[0].opacity: must be a number from 0 to 1, is NaN",
    ],
    ["a number as text", decal({ opacity: "1" }), 'layers[0].opacity: must be a number from 0 to 1, is "1"'],
    [
      "a size that 32 bits cannot hold",
      decal({ projector: { ...planar, size: [1, 1, 1e-40] } }),
      "layers[0].projector.size[2]: must be at least 1e-9, is 1e-40",
    ],
    [
      "a field of view that is half a turn in 32 bits",
      decal({
        projector: {
          kind: "perspective",
          position: [0, 0, 1],
          rotation: [0, 0, 0, 1],
          fov: 179.9999999999,
          aspect: 1,
          near: 1,
          far: 2,
        },
      }),
      "layers[0].projector.fov: must be at most 179.99999 degrees, is 179.9999999999",
    ],
    [
      "an arc that 32 bits cannot hold",
      decal({
        projector: {
          kind: "cylindrical",
          position: [0, 0, 1],
          rotation: [0, 0, 0, 1],
          radius: 1,
          height: 1,
          arc: 1e-60,
          depth: 1,
        },
      }),
      "layers[0].projector.arc: must be above 0 degrees, is 1e-60",
    ],
    [
      "a fade that ends before it starts",
      decal({ angleFade: [80, 70] }),
      "layers[0].angleFade: must not end before it starts, is [80, 70]",
    ],
    [
      "a fade beyond 90 degrees",
      decal({ angleFade: [80, 100] }),
      "layers[0].angleFade[1]: must be a number from 0 to 90 degrees, is 100",
    ],
    [
      "a far end that lies before the near one",
      decal({
        projector: {
          kind: "perspective",
          position: [0, 0, 1],
          rotation: [0, 0, 0, 1],
          fov: 40,
          aspect: 1,
          near: 2,
          far: 1,
        },
      }),
      "layers[0].projector.far: must be above near, is 1",
    ],
    ["a material of half a number", decal({ material: 0.5 }), "layers[0].material: must be a glTF material index"],
    ["a material below zero", decal({ material: -1 }), "layers[0].material: must be a glTF material index"],
    [
      "a material by name",
      decal({ material: "body" }),
      'layers[0].material: must be a glTF material index: a whole number, 0 or above, or a list of such, is "body"',
    ],
    ["a list of no materials", decal({ material: [] }), "layers[0].material: must name one material at least, is []"],
    [
      "a list with half a material",
      decal({ material: [0, 0.5] }),
      "layers[0].material[1]: must be a glTF material index",
    ],
    [
      "a material twice",
      decal({ material: [2, 0, 2] }),
      "layers[0].material: must not name a material twice, is [2, 0, 2]",
    ],
    ["a flag that is no flag", decal({ visible: 1 }), "layers[0].visible: must be true or false, is 1"],
    ["null where a default could be", decal({ visible: null }), "layers[0].visible: must be true or false, is null"],
    ["an empty id", decal({ id: "" }), 'layers[0].id: must not be empty, is ""'],
    [
      "a colour by name",
      design([{ type: "fill", color: "red" }]),
      'layers[0].color: must be a colour as "#rrggbb" or "#rrggbbaa", is "red"',
    ],
    ["a fill without a colour", design([{ type: "fill" }]), "layers[0].color: is missing"],
    [
      "an asset of another type",
      design([], { logo: { type: "image/bmp", uri: "a" } }),
      "assets.logo.type: must be one of",
    ],
    ["a stroke without a brush", design([{ type: "stroke", dabs: [] }]), "layers[0].brush: is missing"],
    ["a stroke without dabs", design([{ type: "stroke", brush: {} }]), "layers[0].dabs: is missing"],
    [
      "an unknown tip",
      stroke({ brush: { tip: "flat" } }),
      'layers[0].brush.tip: must be one of "round", "picture", is "flat',
    ],
    ["a round tip of a picture", stroke({ brush: { asset: "logo" } }), "layers[0].brush.asset: is not a known field"],
    ["a picture tip without a picture", stroke({ brush: { tip: "picture" } }), "layers[0].brush.asset: is missing"],
    [
      "a picture tip that is not there",
      stroke({ brush: { tip: "picture", asset: "lago" } }),
      'layers[0].brush.asset: must name one of the design\'s assets (there are: "logo"), is "lago"',
    ],
    [
      "a brush too hard",
      stroke({ brush: { hardness: 2 } }),
      "layers[0].brush.hardness: must be a number from 0 to 1, is 2",
    ],
    ["a brush without colour", stroke({ brush: { color: null } }), "layers[0].brush.color: must be a colour as"],
    [
      "a dab that presses too hard",
      stroke({ dabs: [planar, { ...planar, flow: 1.5 }] }),
      "layers[0].dabs[1].flow: must be a number from 0 to 1, is 1.5",
    ],
    ["a dab of no kind", stroke({ dabs: [{}] }), 'layers[0].dabs[0].kind: is missing: must be one of "planar"'],
    ["an asset without an address", design([], { logo: { type: "image/png" } }), "assets.logo.uri: is missing"],
    ["assets in a list", design([], [1]), "assets: must be an object of named assets, is [1]"],
    [
      "a decal of a font",
      design(decal().layers, { logo: { type: "font/ttf", uri: "a" } }),
      'layers[0].asset: must name a picture, but that asset\'s type is "font/ttf"',
    ],
    ["a strange asset name", design([], { "my logo": 1 }), 'assets["my logo"]: must be an object, is 1'],
  ])("refuses %s", (_what, value, start) => {
    const error = refusal(value);
    expect(error.code).toBe("bad-design");
    expect(error.message.slice(0, start.length)).toBe(start);
    expect(error.hint).toBeTruthy();
  });

  it("refuses two layers of one id, naming both", () => {
    const fill = { type: "fill", color: "#000000", id: "a" };
    expect(refusal(design([fill, fill])).message).toBe(
      'layers[1].id: must be unique: layers[0] has the same id, is "a"',
    );
  });

  it("tells a newer program's file from a broken one", () => {
    expect(refusal({ format: "texelcast-design", version: 7 }).hint).toContain("update");
    expect(refusal({ format: "texelcast-design", version: -7 }).hint).not.toContain("update");
  });
});

describe("hostile designs", () => {
  it("cannot reach the prototypes of objects", () => {
    const text = `{"format":"texelcast-design","version":1,"assets":{"__proto__":{"type":"image/png","uri":"a"}}}`;
    expect(refusal(text).message).toContain('must not name an asset "__proto__"');
    const layer = `{"format":"texelcast-design","version":1,"layers":[{"type":"fill","color":"#000000","__proto__":{"polluted":1}}]}`;
    expect(refusal(layer).message).toContain("layers[0].__proto__: is not a known field");
  });

  it("names every unknown field, in one object too", () => {
    const { message } = refusal({ ...decal({ blur: 3, glow: 1 }), author: "me", year: 2026 });
    for (const field of ["layers[0].blur", "layers[0].glow", "author", "year"])
      expect(message).toContain(`${field}: is not a known field`);
    expect(({} as Record<string, unknown>).polluted).toBeUndefined();
  });

  it("may nest as deep as they like without harm", () => {
    const deep = `${"[".repeat(200_000)}${"]".repeat(200_000)}`;
    const text = `{"format":"texelcast-design","version":1,"layers":[{"type":"fill","color":${deep}}]}`;
    expect(refusal(text).message).toBe('layers[0].color: must be a colour as "#rrggbb" or "#rrggbbaa", is a list of 1');
  });

  it("nested deeper than any stack are refused by their depth, whichever list they hide in", () => {
    for (const wrap of [
      (inner: object) => ({ type: "group", layers: [inner] }),
      (inner: object) => ({ type: "fill", color: "#000000", mask: { layers: [inner] } }),
      (inner: object) => ({ type: "paint", strokes: [inner] }),
    ]) {
      let layer: object = { type: "fill", color: "#000000" };
      for (let level = 0; level < 200_000; level++) layer = wrap(layer);
      expect(refusal(design([layer])).message).toContain("more than 16 deep");
    }
  });

  it("name the whole path of what is wrong inside groups and masks", () => {
    const fill = { type: "fill", color: "#000000" };
    const inside = (layer: object) =>
      design([{ type: "group", layers: [fill, { ...fill, mask: { layers: [layer] } }] }]);
    expect(refusal(inside({ ...fill, opacity: 2 })).field).toBe("layers[0].layers[1].mask.layers[0].opacity");
    expect(refusal(inside({ type: "decal", asset: "no", projector: planar })).field).toBe(
      "layers[0].layers[1].mask.layers[0].asset",
    );
    const twice = design([
      { ...fill, id: "a" },
      { type: "group", layers: [{ ...fill, id: "a" }] },
    ]);
    expect(refusal(twice).message).toContain("layers[1].layers[0].id: must be unique: layers[0] has the same id");
    const stamp = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 };
    expect(refusal(decal({ projector: stamp, mirror: { axis: "x" } })).field).toBe("layers[0].mirror");
    expect(refusal(stroke({ dabs: [stamp], mirror: { axis: "x" } })).field).toBe("layers[0].mirror");
    const parts = { kind: "faces", faces: [0] };
    expect(refusal(design([{ ...fill, material: [0, 1], parts }])).field).toBe("layers[0].parts");
  });

  it("are refused by count before their items are looked at", () => {
    const many = new Array(2_000_000).fill(0);
    expect(refusal(design(many)).message).toBe(
      "layers: must not hold more than 10000 layers, those within others included, is a list of 2000000",
    );
    const long = refusal(decal({ projector: { ...planar, position: many } })).message;
    expect(long).toBe("layers[0].projector.position: must be a list of 3 numbers, is a list of 2000000");
  });

  it("never come back whole in the message", () => {
    const error = refusal(decal({ blend: "x".repeat(1_000_000) }));
    expect(error.message.length).toBeLessThan(500);
    expect(error.value?.length).toBeLessThan(100);
  });

  it("give a typed error or a design, whatever they are", () => {
    fc.assert(
      fc.property(
        fc.oneof(
          fc.jsonValue(),
          fc.record({ format: fc.constant("texelcast-design"), version: fc.constant(1), layers: fc.jsonValue() }),
        ),
        (value) => {
          try {
            expect(parseDesign(value).format).toBe("texelcast-design");
          } catch (error) {
            expect(error).toBeInstanceOf(TexelcastError);
          }
        },
      ),
      { numRuns: 300 },
    );
  });
});

describe("older versions", () => {
  it("are brought up step by step before they are checked", () => {
    const migrations = new Map([
      [-1, (old: Readonly<Record<string, unknown>>) => ({ ...old, version: 0, steps: [-1] })],
      [0, (old: Readonly<Record<string, unknown>>) => ({ ...old, version: 1, steps: [...(old.steps as number[]), 0] })],
    ]);
    expect(migrateDesign({ format: "texelcast-design", version: -1 }, "old.json", migrations)).toEqual({
      format: "texelcast-design",
      version: 1,
      steps: [-1, 0],
    });
  });
});
