import { describe, expect, it } from "vitest";
import { gltfFault } from "../../web/engine/gltf-fault.ts";
import type { JsonObject, JsonValue } from "../../web/engine/gltf-json.ts";

/** The field at fault; null where the file is sound. */
const faultIn = (json: object): string | null =>
  gltfFault({ asset: { version: "2.0" }, ...json } as JsonObject, "m.glb")?.field ?? null;

const buffers = [{ byteLength: 1024 }];
const bufferViews = [{ buffer: 0, byteLength: 512 }];
const numbers = { bufferView: 0, componentType: 5126, count: 1, type: "SCALAR" };
const accessorOf = (fields: object, view: object = {}) => ({
  buffers,
  bufferViews: [{ ...bufferViews[0], ...view }],
  accessors: [{ ...numbers, ...fields }],
});
const sparse = (componentType: JsonValue) =>
  accessorOf({ sparse: { count: 1, indices: { bufferView: 0, componentType }, values: { bufferView: 0 } } });
const primitive = (mode: JsonValue) => ({
  ...accessorOf({}),
  meshes: [{ primitives: [{ attributes: { POSITION: 0 }, mode }] }],
});
const LIGHTS = "KHR_lights_punctual";

type Listed = string | number;

/** What the standard lists for a member, and the file that has it there. */
const LISTED: readonly (readonly [string, readonly Listed[], (value: Listed) => object])[] = [
  [
    "accessors[0].componentType",
    [5120, 5121, 5122, 5123, 5125, 5126],
    (componentType) => accessorOf({ componentType }),
  ],
  ["accessors[0].type", ["SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"], (type) => accessorOf({ type })],
  ["accessors[0].sparse.indices.componentType", [5121, 5123, 5125], sparse],
  ["meshes[0].primitives[0].mode", [0, 1, 2, 3, 4, 5, 6], primitive],
  ["samplers[0].magFilter", [9728, 9729], (magFilter) => ({ samplers: [{ magFilter }] })],
  ["samplers[0].minFilter", [9728, 9729, 9984, 9985, 9986, 9987], (minFilter) => ({ samplers: [{ minFilter }] })],
  ["samplers[0].wrapS", [33071, 33648, 10497], (wrapS) => ({ samplers: [{ wrapS }] })],
  ["samplers[0].wrapT", [33071, 33648, 10497], (wrapT) => ({ samplers: [{ wrapT }] })],
  ["materials[0].alphaMode", ["OPAQUE", "MASK", "BLEND"], (alphaMode) => ({ materials: [{ alphaMode }] })],
  ["cameras[0].type", ["perspective", "orthographic"], (type) => ({ cameras: [{ type }] })],
  [
    `extensions.${LIGHTS}.lights[0].type`,
    ["directional", "point", "spot"],
    (type) => ({ extensions: { [LIGHTS]: { lights: [{ type }] } } }),
  ],
];

const isListed = (listed: readonly Listed[], value: Listed): boolean => listed.includes(value);
/** Every listed value of any member, and the numbers beside them. */
const CANDIDATES: Listed[] = LISTED.flatMap<Listed>(([, listed]) =>
  listed.flatMap<Listed>((value) =>
    typeof value === "number" ? [value - 1, value, value + 1] : [value, value.toLowerCase()],
  ),
);

describe("what glTF lists for a member", () => {
  it.each(LISTED)("is all that %s may be, and none of it is refused", (field, listed, fileWith) => {
    const taken = new Set(CANDIDATES.filter((value) => faultIn(fileWith(value)) !== field));
    expect(taken).toEqual(new Set(CANDIDATES.filter((value) => isListed(listed, value))));
    for (const value of listed) expect(faultIn(fileWith(value)), String(value)).toBeNull();
  });

  it("for a stride is each multiple of four from 4 to 252, and nothing else", () => {
    const strides = Array.from({ length: 300 }, (_, index) => index - 10);
    const taken = strides.filter((byteStride) => faultIn(accessorOf({}, { byteStride })) === null);
    expect(taken).toEqual(Array.from({ length: 63 }, (_, index) => 4 * (index + 1)));
  });
});

describe("numbers in a buffer", () => {
  const SIZES = [
    [5120, 1],
    [5121, 1],
    [5122, 2],
    [5123, 2],
    [5125, 4],
    [5126, 4],
  ] as const;

  it.each(SIZES)(
    "of type %i begin at multiples of their size, %i, and nowhere else, in the view as in the buffer",
    (componentType, size) => {
      for (let offset = 0; offset <= 16; offset += 1) {
        const isSound = offset % size === 0;
        expect(faultIn(accessorOf({ componentType, byteOffset: offset }))).toBe(
          isSound ? null : "accessors[0].byteOffset",
        );
        const inBuffer = accessorOf({ componentType }, { byteOffset: offset });
        expect(faultIn(inBuffer)).toBe(isSound ? null : "bufferViews[0].byteOffset");
      }
    },
  );

  it.each(SIZES)("of type %i, of %i bytes, are shares of one only where they are short", (componentType, size) => {
    const told = faultIn(accessorOf({ componentType, normalized: true }));
    expect(told).toBe(size < 4 ? null : "accessors[0].normalized");
    expect(faultIn(accessorOf({ componentType, normalized: false }))).toBeNull();
  });
});

describe("the number of one of a file's things", () => {
  it("is from 0 to one less than there are, wherever one is named", () => {
    const named: readonly (readonly [string, (index: number) => object])[] = [
      ["scene", (scene) => ({ scenes: [{}, {}], scene })],
      ["scenes[0].nodes[0]", (node) => ({ nodes: [{}, {}], scenes: [{ nodes: [node] }] })],
      ["nodes[0].children[0]", (node) => ({ nodes: [{ children: [node] }, {}] })],
      [
        "nodes[0].camera",
        (camera) => ({ cameras: [{ type: "perspective" }, { type: "perspective" }], nodes: [{ camera }] }),
      ],
      ["textures[0].sampler", (sampler) => ({ samplers: [{}, {}], textures: [{ sampler }] })],
      ["textures[0].source", (source) => ({ images: [{ uri: "a" }, { uri: "b" }], textures: [{ source }] })],
      [
        "bufferViews[0].buffer",
        (buffer) => ({ buffers: [...buffers, ...buffers], bufferViews: [{ buffer, byteLength: 4 }] }),
      ],
      ["skins[0].skeleton", (skeleton) => ({ nodes: [{}, {}], skins: [{ joints: [0], skeleton }] })],
      [
        `nodes[0].extensions.${LIGHTS}.light`,
        (light) => ({
          extensions: { [LIGHTS]: { lights: [{ type: "spot" }, { type: "point" }] } },
          nodes: [{ extensions: { [LIGHTS]: { light } } }],
        }),
      ],
    ];
    for (const [field, fileWith] of named) {
      const faults = [-1, 0, 1, 2, 0.5].map((index) => faultIn(fileWith(index)));
      expect(faults).toEqual([field, null, null, field, field]);
    }
  });
});
