/** Programs read an error's field and value; its message is for people. */
import { afterEach, describe, expect, it } from "vitest";
import { writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { GltfSketch } from "../support/gltf-sketch.ts";
import { buildGlb, buildModel, plane } from "../support/model-builder.ts";
import { endHosts, startHost, texturedPlane } from "../support/painted-plane.ts";
import { solidPng } from "../support/png-file.ts";

afterEach(endHosts);

const refusalOf = (bytes: Uint8Array): Promise<unknown> =>
  startHost()
    .loadModel({ name: "m.glb", bytes })
    .then(
      () => "no error",
      (error: unknown) => error,
    );

type Lists = Readonly<Record<"accessors" | "bufferViews" | "nodes" | "materials", JsonObject[]>>;

/** A square (accessors: places, normals, coordinates, indices) whose JSON is changed. */
function square(change: (lists: Lists, json: JsonObject, primitive: JsonObject) => void): Uint8Array {
  const { json, binary } = buildModel({ meshes: [plane(1, 0)], materials: [{}] });
  const [{ primitives }] = json.meshes as unknown as [{ primitives: [JsonObject] }];
  change(json as unknown as Lists, json, primitives[0]);
  return writeGlb(json, binary);
}

/** A square of a joint, whose primitive is changed. */
function skinned(change: (model: GltfSketch, attributes: JsonObject) => JsonObject): Uint8Array {
  const model = new GltfSketch();
  const attributes: JsonObject = {
    POSITION: model.places([0, 0, 0, 1, 0, 0, 1, 1, 0]),
    JOINTS_0: model.values(Uint8Array.from({ length: 12 }), 4),
    WEIGHTS_0: model.values(
      Float32Array.from({ length: 12 }, () => 0.25),
      4,
    ),
  };
  const more = change(model, attributes);
  return model.glb({
    scenes: [{ nodes: [0, 1] }],
    nodes: [{ mesh: 0, skin: 0 }, {}],
    skins: [{ joints: [1] }],
    materials: [{}],
    meshes: [{ primitives: [{ attributes, material: 0, ...more }], weights: [1] }],
  });
}

const listAt = (list: JsonObject[], index: number): JsonObject => list[index] as JsonObject;

const CASES: readonly (readonly [what: string, bytes: () => Uint8Array, field: string, value: string])[] = [
  [
    "an accessor that is longer than its view",
    () => square(({ accessors }) => (listAt(accessors, 0).count = 5)),
    "accessors[0].count",
    "5",
  ],
  [
    "a stride that is shorter than an element",
    () => square(({ bufferViews }) => (listAt(bufferViews, 0).byteStride = 8)),
    "bufferViews[0].byteStride",
    "8",
  ],
  [
    "places of two numbers",
    () => square(({ accessors }) => (listAt(accessors, 0).type = "VEC2")),
    "accessors[0].type",
    "VEC2",
  ],
  [
    "indices that are fractions",
    () => square(({ accessors }) => (listAt(accessors, 3).componentType = 5126)),
    "accessors[3].componentType",
    "5126",
  ],
  [
    "indices that lie nowhere",
    () => square(({ accessors }) => delete listAt(accessors, 3).bufferView),
    "accessors[3].bufferView",
    "(absent)",
  ],
  [
    "normals that are fewer than the places",
    () => square(({ accessors }) => (listAt(accessors, 1).count = 3)),
    "meshes[0].primitives[0].attributes.NORMAL",
    "1",
  ],
  [
    "coordinates that are fewer than the places",
    () => square(({ accessors }) => (listAt(accessors, 2).count = 3)),
    "meshes[0].primitives[0].attributes.TEXCOORD_0",
    "2",
  ],
  [
    "an index that names no vertex",
    () => buildGlb({ meshes: [{ ...plane(1), indices: [0, 1, 9] }] }),
    "meshes[0].primitives[0].indices",
    "9",
  ],
  [
    "a place that is no number",
    () => buildGlb({ meshes: [{ ...plane(1), positions: [Number.NaN, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0] }] }),
    "meshes[0].primitives[0].attributes.POSITION",
    "(nan, nan, nan)",
  ],
  [
    "a node that two others have as their child",
    () => square((_, json) => (json.nodes = [{ children: [2] }, { children: [2] }, { mesh: 0 }])),
    "nodes[1].children[0]",
    "2",
  ],
  [
    "a node that is below itself",
    () => square((_, json) => (json.nodes = [{ children: [1] }, { children: [0], mesh: 0 }])),
    "nodes[0].children",
    "[1]",
  ],
  [
    "a scene of points alone",
    () => square((_, __, primitive) => Object.assign(primitive, { mode: 0 })),
    "scenes",
    '[{"nodes":[0]}]',
  ],
  [
    "a later version that it asks for",
    () => square((_, json) => (json.asset = { version: "2.1", minVersion: "2.1" })),
    "asset.minVersion",
    "2.1",
  ],
  [
    "sparse elements that are more than all",
    () =>
      square(({ accessors, bufferViews }) => {
        bufferViews.push({ buffer: 0, byteOffset: 0, byteLength: 48 });
        const view = bufferViews.length - 1;
        const indices = { bufferView: view, componentType: 5121 };
        listAt(accessors, 0).sparse = { count: 9, indices, values: { bufferView: view } };
      }),
    "accessors[0].sparse.count",
    "9",
  ],
  [
    "a sparse element beyond the end",
    () => {
      const model = new GltfSketch();
      const sparse = model.sparse([7], Float32Array.from([1, 1, 5]));
      const POSITION = model.places([0, 0, 0, 1, 0, 0, 1, 1, 0], { sparse });
      return model.glb({ materials: [{}], meshes: [{ primitives: [{ attributes: { POSITION }, material: 0 }] }] });
    },
    "accessors[0].sparse.indices",
    "7",
  ],
  [
    "sparse values that end early",
    () => {
      const model = new GltfSketch();
      const sparse = model.sparse([1, 2], Float32Array.from([1, 1, 5]));
      const POSITION = model.places([0, 0, 0, 1, 0, 0, 1, 1, 0], { sparse });
      return model.glb({ materials: [{}], meshes: [{ primitives: [{ attributes: { POSITION }, material: 0 }] }] });
    },
    "accessors[0].sparse.count",
    "2",
  ],
  [
    "a joint that the skin has not",
    () =>
      skinned((model, attributes) => {
        attributes.JOINTS_0 = model.values(
          Uint8Array.from({ length: 12 }, () => 3),
          4,
        );
        return {};
      }),
    "meshes[0].primitives[0].attributes.JOINTS_0",
    "3",
  ],
  [
    "joints of fewer vertices",
    () =>
      skinned((model, attributes) => {
        attributes.JOINTS_0 = model.values(Uint8Array.from({ length: 8 }), 4);
        return {};
      }),
    "meshes[0].primitives[0].attributes.JOINTS_0",
    "3",
  ],
  [
    "a morph of fewer vertices",
    () => skinned((model) => ({ targets: [{ POSITION: model.places([0, 0, 0, 1, 0, 0]) }] })),
    "meshes[0].primitives[0].targets",
    '[{"POSITION":3}]',
  ],
];

describe("a model that the core refuses", () => {
  it.each(CASES)("for %s is told by field, value and what to do", async (_, bytes, field, value) => {
    const error = await refusalOf(bytes());
    expect(error).toMatchObject({ subject: "m.glb", field, value, hint: expect.stringMatching(/./) });
  });

  it("for inverse matrices that are fewer than the joints is told by them", async () => {
    const model = new GltfSketch();
    const attributes: JsonObject = {
      POSITION: model.places([0, 0, 0, 1, 0, 0, 1, 1, 0]),
      JOINTS_0: model.values(Uint8Array.from({ length: 12 }), 4),
      WEIGHTS_0: model.values(
        Float32Array.from({ length: 12 }, () => 0.25),
        4,
      ),
    };
    const inverseBindMatrices = model.values(Float32Array.from([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]), 16);
    const bytes = model.glb({
      scenes: [{ nodes: [0, 1, 2] }],
      nodes: [{ mesh: 0, skin: 0 }, {}, {}],
      skins: [{ joints: [1, 2], inverseBindMatrices }],
      materials: [{}],
      meshes: [{ primitives: [{ attributes, material: 0 }] }],
    });
    expect(await refusalOf(bytes)).toMatchObject({ field: "skins[0].inverseBindMatrices", value: "3" });
  });
});

describe("a model's picture that cannot be decoded", () => {
  const BROKEN = solidPng(64, 64, [1, 2, 3, 255]).slice(0, 60);

  it("is told by its place in the file, its name and what to do", async () => {
    for (const [image, value] of [
      [{ bytes: BROKEN, mimeType: "image/png", name: "front" }, "front"],
      [{ bytes: BROKEN, mimeType: "image/png" }, "image/png"],
    ] as const) {
      const engine = startHost();
      await engine.loadModel({ name: "m.glb", bytes: buildGlb({ ...texturedPlane, images: [image] }) });
      await expect(engine.openTarget({ material: 0 })).rejects.toMatchObject({
        code: "bad-picture",
        field: "images[0]",
        value,
        reason: expect.any(String),
        hint: expect.stringMatching(/./),
      });
    }
  });

  it("is told by its address where it lies beside the model", async () => {
    const { json, binary } = buildModel({ ...texturedPlane, images: [{ bytes: BROKEN, mimeType: "image/png" }] });
    json.images = [{ uri: "tex/front.png" }];
    const engine = startHost();
    const resources = new Map([["tex/front.png", BROKEN]]);
    await engine.loadModel({ name: "m.glb", bytes: writeGlb(json, binary), resources });
    await expect(engine.openTarget({ material: 0 })).rejects.toMatchObject({
      code: "bad-picture",
      field: "images[0]",
      value: "tex/front.png",
    });
  });
});
