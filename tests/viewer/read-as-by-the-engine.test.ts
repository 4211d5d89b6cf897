/** The page shows and picks by three.js what the engine paints by the core: both are to read a file as glTF 2.0 has it. */
import type { Texture } from "three";
import { afterEach, describe, expect, it } from "vitest";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { LiveTexture } from "../../web/viewer/live-texture.ts";
import { loadModelScene, type ModelScene } from "../../web/viewer/model-scene.ts";
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
    const renderer = { capabilities: { getMaxAnisotropy: () => 1 }, initTexture: () => undefined };
    const info = { width: 8, height: 8, mipLevels: 1 };
    const live = new LiveTexture(renderer as never, info as never, own).texture;
    for (const texture of [own, live, own.clone()]) {
      // As the renderer does before it draws.
      if (texture.matrixAutoUpdate) texture.updateMatrix();
      const { elements: m } = texture.matrix;
      const shown = [0, 1].map((row) => (m[3 + row] as number) + (m[6 + row] as number));
      expect(rounded(shown)).toEqual(rounded(painted.slice(0, 2)));
    }
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
