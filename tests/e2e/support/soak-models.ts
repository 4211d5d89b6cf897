/** Models that a long random use of the page is tried on: each has a trait that a plain box has not. */
import { writeGlb } from "../../../web/engine/gltf-container.ts";
import { buildModel, type MeshParts } from "../../support/model-builder.ts";
import { paintPng } from "../../support/png-file.ts";
import type { TestFile } from "./editor-page.ts";
import { file } from "./test-files.ts";

/** The six sides of a box, each from its lower left, as seen from outside: where it is, and which way its right and its top are. */
const SIDES = [
  { at: [-1, -1, 1], right: [2, 0, 0], up: [0, 2, 0] },
  { at: [1, -1, -1], right: [-2, 0, 0], up: [0, 2, 0] },
  { at: [1, -1, 1], right: [0, 0, -2], up: [0, 2, 0] },
  { at: [-1, -1, -1], right: [0, 0, 2], up: [0, 2, 0] },
  { at: [-1, 1, 1], right: [2, 0, 0], up: [0, 0, -2] },
  { at: [-1, -1, -1], right: [2, 0, 0], up: [0, 0, 2] },
] as const;

/**
 * A box about a middle.
 *
 * @param half half an edge, metres
 * @param cell where a side lies in the texture: its left, top, right and bottom; left and right changed over mirrors it
 */
function box(
  middle: readonly number[],
  half: number,
  material: number,
  cell: (side: number) => readonly [number, number, number, number],
): MeshParts {
  const positions: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  const indices: number[] = [];
  for (const [side, { at, right, up }] of SIDES.entries()) {
    const [left, top, far, bottom] = cell(side);
    const first = positions.length / 3;
    for (const [across, along] of [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ] as const) {
      for (const axis of [0, 1, 2] as const) {
        positions.push((middle[axis] ?? 0) + half * (at[axis] + across * right[axis] + along * up[axis]));
      }
      normals.push(
        (right[1] * up[2] - right[2] * up[1]) / 4,
        (right[2] * up[0] - right[0] * up[2]) / 4,
        (right[0] * up[1] - right[1] * up[0]) / 4,
      );
      uvs.push(across ? far : left, along ? top : bottom);
    }
    indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
  }
  return { positions, normals, uvs, indices, material };
}

/** Each side has a sixth of the texture. */
const apart = (side: number): readonly [number, number, number, number] => {
  const [left, top] = [(side % 3) / 3, side < 3 ? 0 : 0.5];
  return [left + 0.01, top + 0.01, left + 0.32, top + 0.49];
};

/** Opposite sides have the same texels, one of them as in a mirror. */
const mirrored = (side: number): readonly [number, number, number, number] => {
  const [left, top, right, bottom] = apart(side - (side % 2));
  return side % 2 === 0 ? [left, top, right, bottom] : [right, top, left, bottom];
};

const glb = (name: string, meshes: readonly MeshParts[], names: readonly string[]): TestFile => {
  const bytes = paintPng(64, 64, (x, y) => [60 + 2 * x, 90 + y, 160, 255]);
  const { json, binary } = buildModel({
    meshes,
    materials: names.map((each, at) =>
      at % 2 === 0 ? { name: each } : { name: each, pbrMetallicRoughness: { baseColorTexture: { index: 0 } } },
    ),
    ...(names.length > 1 && { textures: [{ source: 0 }], images: [{ bytes, mimeType: "image/png" }] }),
  });
  return file(`${name}.glb`, writeGlb(json, binary));
};

const NAMES = Array.from({ length: 10 }, (_, at) => `Part ${at}`);

export const SOAK_MODELS: Readonly<Record<string, () => TestFile>> = {
  /** Ten materials, every other one with a small picture. */
  ten: () =>
    glb(
      "ten",
      NAMES.map((_, at) => box([(at % 5) - 2, Math.floor(at / 5) - 0.5, 0], 0.4, at, apart)),
      NAMES,
    ),
  mirrored: () => glb("mirrored", [box([0, 0, 0], 0.5, 0, mirrored)], ["Mirrored"]),
  /** A millimetre. */
  tiny: () => glb("tiny", [box([0, 0, 0], 0.0005, 0, apart)], ["Tiny"]),
  /** A kilometre, and far from where lengths begin. */
  huge: () => glb("huge", [box([2000, 0, -3000], 500, 0, apart)], ["Huge"]),
};
