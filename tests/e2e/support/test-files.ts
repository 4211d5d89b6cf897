/** Files that the tests hand to the page: made here, or the project's own demos. */
import { randomBytes } from "node:crypto";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { writeGlb } from "../../../web/engine/gltf-container.ts";
import { buildModel, type MeshParts } from "../../support/model-builder.ts";
import { paintPng } from "../../support/png-file.ts";
import type { TestFile } from "./editor-page.ts";

const DEMO = new URL("../../../build/public/demo/", import.meta.url);

export const file = (name: string, bytes: Uint8Array | string, mimeType = "application/octet-stream"): TestFile => ({
  name,
  mimeType,
  buffer: Buffer.from(bytes),
});

export const demoFile = (path: string): TestFile =>
  file(path.slice(path.lastIndexOf("/") + 1), readFileSync(fileURLToPath(new URL(path, DEMO))));

/** A standing square of one metre that faces +Z and has the whole texture to itself. */
const SQUARE: MeshParts = {
  positions: [-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0],
  normals: [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1],
  uvs: [0, 1, 1, 1, 1, 0, 0, 0],
  indices: [0, 1, 2, 0, 2, 3],
  material: 0,
};

export function squareGlb(): TestFile {
  const { json, binary } = buildModel({ meshes: [SQUARE], materials: [{ name: "Board" }] });
  return file("square.glb", writeGlb(json, binary));
}

/** The square in a file with so many bytes more, which nothing in it uses and no browser packs smaller. */
export function heavyGlb(name: string, bytes: number): TestFile {
  const { json, binary } = buildModel({ meshes: [SQUARE], materials: [{ name: "Board" }] });
  return file(name, writeGlb(json, Buffer.concat([binary, randomBytes(bytes)])));
}

/** Two of the squares side by side, each of a material of its own, 0 at the left. */
export function twoSquaresGlb(): TestFile {
  const moved = (x: number, material: number): MeshParts => ({
    ...SQUARE,
    positions: SQUARE.positions.map((value, index) => (index % 3 === 0 ? value + x : value)),
    material,
  });
  const materials = [{ name: "Left" }, { name: "Right" }];
  const { json, binary } = buildModel({ meshes: [moved(-0.55, 0), moved(0.55, 1)], materials });
  return file("squares.glb", writeGlb(json, binary));
}

/** The square with its left and right halves apart in the texture: a tenth lies free between their charts. */
export function seamedGlb(): TestFile {
  const half = (left: number, u: number): MeshParts => ({
    ...SQUARE,
    positions: [left, -0.5, 0, left + 0.5, -0.5, 0, left + 0.5, 0.5, 0, left, 0.5, 0],
    uvs: [u, 1, u + 0.45, 1, u + 0.45, 0, u, 0],
  });
  const { json, binary } = buildModel({ meshes: [half(-0.5, 0), half(0, 0.55)], materials: [{ name: "Board" }] });
  return file("seamed.glb", writeGlb(json, binary));
}

export function glbWithoutUvs(): TestFile {
  const { positions, indices } = SQUARE;
  const parts = { meshes: [{ positions, ...(indices && { indices }), material: 0 }], materials: [{ name: "Bare" }] };
  const { json, binary } = buildModel(parts);
  return file("bare.glb", writeGlb(json, binary));
}

/** The two squares, the right one without texture coordinates. */
export function halfBareGlb(): TestFile {
  const { uvs: _, ...bare } = SQUARE;
  const right = {
    ...bare,
    positions: SQUARE.positions.map((value, i) => (i % 3 === 0 ? value + 1.1 : value)),
    material: 1,
  };
  const materials = [{ name: "Paper" }, { name: "Rubber" }];
  const { json, binary } = buildModel({ meshes: [SQUARE, right], materials });
  return file("half-bare.glb", writeGlb(json, binary));
}

/** The square with a texture coordinate that its file does not mean. */
export function glbWithBrokenUvs(name: string, broken: number): TestFile {
  const { uvs = [], ...others } = SQUARE;
  const { json, binary } = buildModel({
    meshes: [{ ...others, uvs: [broken, ...uvs.slice(1)] }],
    materials: [{ name: "Broken" }],
  });
  return file(name, writeGlb(json, binary));
}

/** Teal with a white corner at the top left, so that a picture upside down is told. */
export const BOARD_SIZE = 64;
export const boardPicture = (): TestFile =>
  file(
    "board.png",
    paintPng(BOARD_SIZE, BOARD_SIZE, (x, y) => (x < 8 && y < 8 ? [255, 255, 255, 255] : [20, 120, 130, 255])),
    "image/png",
  );

/** The square as .gltf with its buffer and picture beside it. */
export function squareGltf(): TestFile[] {
  const { json, binary } = buildModel({
    meshes: [SQUARE],
    materials: [{ name: "Board", pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0 }],
    more: { images: [{ uri: "textures/board.png" }], buffers: [] },
  });
  const gltf = { ...json, buffers: [{ uri: "square%20data.bin", byteLength: binary.length }] };
  return [
    file("square.gltf", JSON.stringify(gltf), "model/gltf+json"),
    file("square data.bin", binary),
    boardPicture(),
  ];
}

/** Red, with a hole: what lies below must show through. */
export const ringPicture = (): TestFile =>
  file(
    "ring.png",
    paintPng(64, 64, (x, y) => (Math.hypot(x - 31.5, y - 31.5) < 16 ? [0, 0, 0, 0] : [220, 30, 40, 255])),
    "image/png",
  );
