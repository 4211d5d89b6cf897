/** The page shows and picks by three.js what the engine paints by the core: both are to read a file as glTF 2.0 has it. */
import { RepeatWrapping, type Texture } from "three";
import { afterEach, describe, expect, it } from "vitest";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { LiveTexture } from "../../web/viewer/live-texture.ts";
import { loadModelScene, type ModelScene, meshesOf, positionsOf as positionsIn } from "../../web/viewer/model-scene.ts";
import { gatherRestingSurface, type RestingSurface } from "../../web/viewer/resting-surface.ts";
import { GltfSketch } from "../support/gltf-sketch.ts";
import { buildGlb, plane } from "../support/model-builder.ts";
import { endHosts, startHost, texturedPlane } from "../support/painted-plane.ts";
import { letThreeReadPictures } from "../support/three-in-node.ts";

afterEach(endHosts);

letThreeReadPictures();

const CORNERS = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0];
const PLACES = [0, 1, 2, 0, 2, 3];

interface Shown {
  readonly scene: ModelScene;
  readonly surface: RestingSurface;
  /** Two numbers a corner, three corners a triangle. */
  readonly painted: readonly number[];
}

async function open(bytes: Uint8Array): Promise<Shown> {
  const host = startHost();
  const info = await host.loadModel({ name: "m.glb", bytes });
  await host.openTarget({ material: 0, width: 8, height: 8 });
  const scene = await loadModelScene(info);
  return { scene, surface: gatherRestingSurface(scene), painted: [...(await host.uvTriangles(0))] };
}

function cornersOf({ index }: RestingSurface, values: Float32Array, size: number): number[] {
  return [...index].flatMap((vertex) => [...values.subarray(vertex * size, (vertex + 1) * size)]);
}

const rounded = (numbers: readonly number[]): number[] => numbers.map((number) => Math.round(number * 1e5) / 1e5 + 0);

/** A square by a sketch's accessors; each corner lies where its texture coordinates say. */
function square(
  places: (model: GltfSketch) => number,
  more: (model: GltfSketch) => JsonObject = () => ({}),
): Uint8Array {
  const model = new GltfSketch();
  const uvs = model.values(Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1]), 2);
  const attributes = { POSITION: places(model), TEXCOORD_0: uvs };
  const indices = model.values(Uint16Array.from(PLACES), 1);
  const { weights, ...primitive } = more(model);
  return model.glb({
    materials: [{}],
    meshes: [{ primitives: [{ attributes, indices, material: 0, ...primitive }], ...(weights && { weights }) }],
  });
}

function liveTextureLike(own: Texture): Texture {
  const renderer = { initTexture: () => undefined };
  const info = { width: 8, height: 8, mipLevels: 1 };
  return new LiveTexture(renderer as never, info as never, own).texture;
}

const positionsOf = ({ surface }: Shown): number[] => rounded([...surface.positions]);

describe("a texture that is turned and scaled unevenly", () => {
  const transform = { offset: [0.25, -0.5], rotation: 0.7, scale: [2, 0.5] };
  const turned = buildGlb({
    ...texturedPlane,
    meshes: [plane(1, 0)],
    materials: [
      {
        pbrMetallicRoughness: {
          baseColorTexture: { index: 0, extensions: { KHR_texture_transform: transform } },
        },
      },
    ],
    more: { extensionsUsed: ["KHR_texture_transform"] },
  });

  it("is picked at the texels that the engine paints: scaled before it is turned", async () => {
    const { surface, painted } = await open(turned);
    expect(rounded(cornersOf(surface, surface.uvs, 2))).toEqual(rounded(painted));
    const [c, s] = [Math.cos(0.7), Math.sin(0.7)];
    // The plane's first corner has (0, 1), its second (1, 1).
    expect(rounded(painted.slice(0, 4))).toEqual(
      rounded([s * 0.5 + 0.25, c * 0.5 - 0.5, c * 2 + s * 0.5 + 0.25, -s * 2 + c * 0.5 - 0.5]),
    );
  });

  it("is shown so, and so is the one that is painted in its place", async () => {
    const { scene, painted } = await open(turned);
    const own = scene.materials.get(0)?.[0]?.map as Texture;
    for (const texture of [own, liveTextureLike(own), own.clone()]) {
      // As the renderer does before it draws.
      if (texture.matrixAutoUpdate) texture.updateMatrix();
      const { elements: m } = texture.matrix;
      const shown = [0, 1].map((row) => (m[3 + row] as number) + (m[6 + row] as number));
      expect(rounded(shown)).toEqual(rounded(painted.slice(0, 2)));
    }
  });
});

describe("a texture that its sampler holds at the edge or mirrors", () => {
  const REPEAT = 10497;
  const CLAMP = 33071;
  const MIRROR = 33648;
  /** Two planes, each of a material of its own, that share one texture. */
  const shared = (wrapS: number, wrapT: number, us: readonly [number, number]): Uint8Array => {
    const { images } = texturedPlane;
    const textures = [{ source: 0, sampler: 0 }];
    const beside = { ...plane(1, 1), uvs: [0, 1, 1, 1, 1, 0, 0, 0] };
    const beyond = { ...plane(1, 0), uvs: [us[0], 1, us[1], 1, us[1], 0, us[0], 0] };
    const material = { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } };
    const materials = [material, material];
    return buildGlb({ meshes: [beyond, beside], materials, textures, samplers: [{ wrapS, wrapT }], images });
  };
  const wrapsOf = ({ wrapS, wrapT }: Texture): number[] =>
    [wrapS, wrapT].map((wrap) => [REPEAT, CLAMP, MIRROR][wrap - RepeatWrapping] as number);

  it.each([
    [CLAMP, MIRROR, [0.5, 1.5], [REPEAT, MIRROR]],
    [MIRROR, CLAMP, [1, 2], [REPEAT, CLAMP]],
    [CLAMP, CLAMP, [-0.25, 0.75], [REPEAT, CLAMP]],
    // What is beyond is no texel.
    [CLAMP, MIRROR, [-0.0001, 1.0001], [CLAMP, MIRROR]],
    [MIRROR, CLAMP, [0, 1], [MIRROR, CLAMP]],
  ] as const)("by %i and %i is painted as it repeats where coordinates go beyond: %j", async (s, t, us, expected) => {
    const { scene } = await open(shared(s, t, us));
    const [own, other] = [0, 1].map((index) => scene.materials.get(index)?.[0]?.map as Texture);
    const painted = [own, other].map((like) => liveTextureLike(like as Texture));
    expect(painted.map(wrapsOf)).toEqual([expected, [s, t]]);
    // Until it is painted it is the file's.
    expect([own, other].map((like) => wrapsOf(like as Texture))).toEqual([
      [s, t],
      [s, t],
    ]);
  });
});

describe("a vertex of more than four joints", () => {
  const QUARTERS = [0.25, 0.25, 0.25, 0.25];

  it("is placed by all of them, as it rests; the file's other sets of coordinates and its morph are kept", async () => {
    const model = new GltfSketch();
    const attributes = {
      POSITION: model.places(CORNERS),
      NORMAL: model.values(Float32Array.from([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]), 3),
      TEXCOORD_0: model.values(Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1]), 2),
      JOINTS_0: model.values(Uint8Array.from([0, 1, 2, 3].flatMap(() => [0, 1, 0, 0])), 4),
      WEIGHTS_0: model.values(Float32Array.from([0, 1, 2, 3].flatMap(() => [0.25, 0.25, 0, 0])), 4),
      JOINTS_1: model.values(Uint8Array.from([0, 1, 2, 3].flatMap(() => [2, 0, 0, 0])), 4),
      WEIGHTS_1: model.values(Float32Array.from([0, 1, 2, 3].flatMap(() => [0.5, 0, 0, 0])), 4),
    };
    const targets = [{ POSITION: model.places([1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0]) }];
    const indices = model.values(Uint16Array.from(PLACES), 1);
    const bytes = model.glb({
      scenes: [{ nodes: [0, 1, 2, 3] }],
      nodes: [
        { mesh: 0, skin: 0 },
        { translation: [1, 0, 0] },
        { rotation: [0, 0, Math.SQRT1_2, Math.SQRT1_2] },
        { translation: [0, 0, 4], scale: [2, 2, 2] },
      ],
      skins: [{ joints: [1, 2, 3] }],
      materials: [{}],
      meshes: [{ primitives: [{ attributes, indices, targets, material: 0 }], weights: [2] }],
    });
    const shown = await open(bytes);
    // Half of it twice as large and 4 higher, a quarter moved by 1, a quarter turned by 90 degrees.
    const expected = [0, 1, 2, 3].flatMap((i) => {
      const [x, y] = [(CORNERS[i * 3] as number) + 2, CORNERS[i * 3 + 1] as number];
      return [(x + 1) / 4 - y / 4 + x, y / 4 + x / 4 + y, 2];
    });
    expect(positionsOf(shown)).toEqual(rounded(expected));
    expect(rounded([...shown.surface.normals.subarray(0, 3)])).toEqual([0, 0, 1]);
  });

  it("is placed so in each node that shows its mesh by joints of its own", async () => {
    const model = new GltfSketch();
    const attributes = {
      POSITION: model.places(CORNERS),
      TEXCOORD_0: model.values(Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1]), 2),
      JOINTS_0: model.values(Uint8Array.from([0, 1, 2, 3].flatMap(() => [0, 0, 0, 0])), 4),
      WEIGHTS_0: model.values(Float32Array.from([0, 1, 2, 3].flatMap(() => QUARTERS.map((quarter) => quarter / 2))), 4),
      JOINTS_1: model.values(Uint8Array.from([0, 1, 2, 3].flatMap(() => [1, 1, 1, 1])), 4),
      WEIGHTS_1: model.values(Float32Array.from([0, 1, 2, 3].flatMap(() => QUARTERS.map((quarter) => quarter / 2))), 4),
    };
    const indices = model.values(Uint16Array.from(PLACES), 1);
    const bytes = model.glb({
      scenes: [{ nodes: [0, 1, 2, 3, 4] }],
      nodes: [{ mesh: 0, skin: 0 }, { mesh: 0, skin: 1 }, {}, { translation: [0, 0, 2] }, { translation: [0, 0, 6] }],
      skins: [{ joints: [2, 3] }, { joints: [2, 4] }],
      materials: [{}],
      meshes: [{ primitives: [{ attributes, indices, material: 0 }] }],
    });
    const heights = positionsOf(await open(bytes)).filter((_, i) => i % 3 === 2);
    expect(heights).toEqual([1, 1, 1, 1, 3, 3, 3, 3]);
  });
});

describe("places of vertices", () => {
  it("are shown where a sparse list replaces some that lie apart", async () => {
    const bytes = square((model) => {
      const apart = Float32Array.from([0, 1, 2, 3].flatMap((i) => [...CORNERS.slice(i * 3, i * 3 + 3), 99]));
      const bufferView = model.view(new Uint8Array(apart.buffer), { byteStride: 16 });
      const sparse = model.sparse([2], Float32Array.from([1, 1, 5]));
      return model.accessor({ bufferView, componentType: 5126, count: 4, type: "VEC3", sparse });
    });
    expect(positionsOf(await open(bytes))).toEqual([0, 0, 0, 1, 0, 0, 1, 1, 5, 0, 1, 0]);
  });

  it("are shown where their bytes end with the last of them, and the gap behind it is left out", async () => {
    const bytes = square((model) => {
      const apart = Float32Array.from([0, 1, 2, 3].flatMap((i) => [...CORNERS.slice(i * 3, i * 3 + 3), 99]));
      const bufferView = model.view(new Uint8Array(apart.buffer, 0, 15 * 4), { byteStride: 16 });
      return model.accessor({ bufferView, componentType: 5126, count: 4, type: "VEC3" });
    });
    expect(positionsOf(await open(bytes))).toEqual(CORNERS);
  });
});

describe("a list of indices that is zeros but for a sparse few", () => {
  it("is of the triangles that the engine paints", async () => {
    const model = new GltfSketch();
    const attributes = {
      POSITION: model.places(CORNERS),
      TEXCOORD_0: model.values(Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1]), 2),
    };
    const sparse = {
      count: 4,
      indices: { bufferView: model.view(Uint8Array.from([1, 2, 4, 5])), componentType: 5121 },
      values: { bufferView: model.view(new Uint8Array(Uint16Array.from([1, 2, 2, 3]).buffer)) },
    };
    const indices = model.accessor({ componentType: 5123, count: 6, type: "SCALAR", sparse });
    const primitives = [{ attributes, indices, material: 0 }];
    const { surface, painted } = await open(model.glb({ materials: [{}], meshes: [{ primitives }] }));
    expect([...surface.index]).toEqual(PLACES);
    expect(rounded(cornersOf(surface, surface.uvs, 2))).toEqual(rounded(painted));
  });
});

describe("places of vertices that lie apart", () => {
  it("are shown where one is cut in two by the grid of the gaps", async () => {
    const bytes = square((model) => {
      // Two numbers of something else come first, and each place is followed by two of its own.
      const apart = Float32Array.from([
        9,
        9,
        9,
        ...[0, 1, 2, 3].flatMap((i) => [...CORNERS.slice(i * 3, i * 3 + 3), 99]),
      ]);
      const bufferView = model.view(new Uint8Array(apart.buffer), { byteStride: 16 });
      return model.accessor({ bufferView, byteOffset: 12, componentType: 5126, count: 4, type: "VEC3" });
    });
    expect(positionsOf(await open(bytes))).toEqual(CORNERS);
  });
});

describe("a morph target that moves only the places or only the normals", () => {
  it("leaves the others as they are, where another target moves those", async () => {
    const bytes = square(
      (model) => model.places(CORNERS),
      (model) => {
        const lifted = model.places([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
        const normals = model.values(Float32Array.from([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]), 3);
        const tilted = model.values(Float32Array.from([1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0]), 3);
        const uvs = model.values(Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1]), 2);
        return {
          attributes: { POSITION: model.places(CORNERS), NORMAL: normals, TEXCOORD_0: uvs },
          targets: [{ POSITION: lifted }, { NORMAL: tilted }],
          weights: [0.5, 1],
        };
      },
    );
    const shown = await open(bytes);
    expect(positionsOf(shown)).toEqual([0, 0, 0.5, 1, 0, 0.5, 1, 1, 0.5, 0, 1, 0.5]);
    expect(rounded([...shown.surface.normals.subarray(0, 3)])).toEqual(rounded([Math.SQRT1_2, 0, Math.SQRT1_2]));
  });
});

describe("a node whose matrix skews", () => {
  const SKEW = [1, 0.25, 0, 0, 0.5, -1, 0, 0, 0, 0.2, 1, 0, 5, 6, 7, 1];
  const skewed = (x: number, y: number): number[] => [x + 0.5 * y + 5, 0.25 * x - y + 6, 7];
  /** The square below nodes of these members; the last is the mesh's own. */
  const below = (nodes: readonly JsonObject[]): Uint8Array => {
    const model = new GltfSketch();
    const attributes = {
      POSITION: model.places(CORNERS),
      NORMAL: model.values(Float32Array.from([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]), 3),
      TEXCOORD_0: model.values(Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1]), 2),
    };
    const indices = model.values(Uint16Array.from(PLACES), 1);
    const last = nodes.length - 1;
    return model.glb({
      nodes: nodes.map((node, i) => (i < last ? { ...node, children: [i + 1] } : { ...node, mesh: 0 })),
      materials: [{}],
      meshes: [{ primitives: [{ attributes, indices, material: 0 }] }],
    });
  };
  const expected = [0, 1, 2, 3].flatMap((i) => skewed(CORNERS[i * 3] as number, CORNERS[i * 3 + 1] as number));

  it("is shown and picked where the engine bakes it, also above the mesh", async () => {
    for (const nodes of [[{ matrix: SKEW }], [{ matrix: SKEW }, {}], [{}, { matrix: SKEW }]]) {
      const shown = await open(below(nodes));
      expect(positionsOf(shown)).toEqual(rounded(expected));
      const found = rounded([...positionsIn(shown.scene)]);
      expect(found).toEqual(rounded(expected));
      const { boundsMin, boundsMax } = await startHost().loadModel({ name: "m.glb", bytes: below(nodes) });
      const along = (axis: number): number[] => found.filter((_, i) => i % 3 === axis);
      expect(rounded(boundsMin)).toEqual([0, 1, 2].map((axis) => Math.min(...along(axis))));
      expect(rounded(boundsMax)).toEqual([0, 1, 2].map((axis) => Math.max(...along(axis))));
    }
  });

  it("stands there when it is drawn first, with all the parts of its mesh", async () => {
    const model = new GltfSketch();
    const attributes = { POSITION: model.places(CORNERS) };
    const indices = model.values(Uint16Array.from(PLACES), 1);
    const bytes = model.glb({
      nodes: [{ mesh: 0, matrix: SKEW }],
      materials: [{}],
      meshes: [
        {
          primitives: [
            { attributes, indices, material: 0 },
            { attributes, indices },
          ],
        },
      ],
    });
    const { root } = await loadModelScene(await startHost().loadModel({ name: "m.glb", bytes }));
    // As the renderer does before it draws.
    root.updateMatrixWorld();
    expect(meshesOf(root).map(({ matrixWorld }) => rounded(matrixWorld.elements))).toEqual([SKEW, SKEW]);
  });

  it("faces where the engine says that it faces", async () => {
    const { surface } = await open(below([{ matrix: SKEW }]));
    // The inverse transpose of the square's own turn: across both of its edges.
    const [a, b] = [
      [1, 0.25, 0],
      [0.5, -1, 0],
    ] as const;
    const [nx, ny, nz] = [...surface.normals.subarray(0, 3)] as [number, number, number];
    for (const edge of [a, b]) expect(nx * edge[0] + ny * edge[1] + nz * edge[2]).toBeCloseTo(0, 6);
  });

  it("stands where one that only moves, turns, mirrors and scales stands: by what it is made of", async () => {
    const turned = [0, 2, 0, 0, -3, 0, 0, 0, 0, 0, -1, 0, 1, 2, 3, 1];
    const { scene } = await open(below([{ matrix: turned }, { scale: [2, 3, 4], rotation: [0, 0, 0.6, 0.8] }]));
    const own: boolean[] = [];
    scene.root.traverse(({ matrixAutoUpdate }) => own.push(matrixAutoUpdate));
    expect(own).not.toContain(false);
  });
});
