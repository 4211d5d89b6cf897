/**
 * A model whose bake can be worked out on paper: one level square, drawn by two triangles. Its corners map to the middle
 * half of the texture, so that a texel (u, v) lies at `planePosition(u, v)`, facing straight up.
 */
import { encodePng } from "../../web/engine/png-encoder.ts";

/** Metres, model space; also right for the gutter, where the plane goes on. */
export const planePosition = (u: number, v: number): [number, number, number] => [8 * (u - 0.5), 0.5, 4 * (v - 0.5)];

/** Turns a decal's box so that it shines straight down, with the top of its picture towards the top of the texture. */
export const FACING_DOWN = [-Math.SQRT1_2, 0, 0, Math.SQRT1_2];

export interface PlaneOptions {
  /** The base colour picture; without one the material has a plain colour. */
  readonly texture?: Uint8Array;
  readonly withoutUvs?: boolean;
  /** Changes the document before it is packed. */
  readonly edit?: (gltf: Record<string, unknown>) => void;
}

/** The plane as GLB, with an animation, extras and an extension that no program knows, all of which must survive. */
export function planeGlb(options: PlaneOptions = {}): Uint8Array {
  const { gltf, bin } = planeDocument(options);
  return packGlb(gltf, bin);
}

/** The plane's document and its one buffer. */
export function planeDocument({ texture, withoutUvs = false, edit }: PlaneOptions = {}): {
  gltf: Record<string, unknown>;
  bin: Uint8Array;
} {
  const floats = new Float32Array([
    ...[-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1],
    ...[0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0],
    ...[0.25, 0.25, 0.25, 0.75, 0.75, 0.75, 0.75, 0.25],
    ...[0, 1, 1, 1, 1, 1, 2, 1, 0],
  ]);
  const indices = new Uint16Array([0, 1, 2, 0, 2, 3]);
  const parts = [new Uint8Array(floats.buffer), new Uint8Array(indices.buffer), texture ?? new Uint8Array()];
  const bin = new Uint8Array(padded(parts.reduce((sum, part) => sum + part.length, 0)));
  parts.reduce((at, part) => {
    bin.set(part, at);
    return at + part.length;
  }, 0);
  const view = (byteOffset: number, byteLength: number) => ({ buffer: 0, byteOffset, byteLength });
  const gltf: Record<string, unknown> = {
    asset: { version: "2.0", generator: "the tests" },
    extensionsUsed: ["EXT_of_nobody"],
    extensions: { EXT_of_nobody: { kept: ["as", "it", "was"] } },
    extras: { owner: "a test" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name: "plane", scale: [2, 1, 1], translation: [0, 0.5, 0] }],
    animations: [
      {
        name: "hop",
        channels: [{ sampler: 0, target: { node: 0, path: "scale" } }],
        samplers: [{ input: 4, output: 5 }],
      },
    ],
    meshes: [
      {
        primitives: [
          {
            attributes: { POSITION: 0, NORMAL: 1, ...(withoutUvs ? {} : { TEXCOORD_0: 2 }) },
            indices: 3,
            material: 0,
          },
        ],
      },
    ],
    materials: [
      {
        name: "paint",
        pbrMetallicRoughness: {
          metallicFactor: 0,
          ...(texture === undefined ? { baseColorFactor: [1, 0, 0, 1] } : { baseColorTexture: { index: 0 } }),
        },
      },
      { name: "of no triangle" },
    ],
    ...(texture === undefined
      ? {}
      : { textures: [{ source: 0 }], images: [{ bufferView: 6, mimeType: "image/png", name: "ground" }] }),
    accessors: [
      { bufferView: 0, componentType: 5126, count: 4, type: "VEC3", min: [-1, 0, -1], max: [1, 0, 1] },
      { bufferView: 1, componentType: 5126, count: 4, type: "VEC3" },
      { bufferView: 2, componentType: 5126, count: 4, type: "VEC2" },
      { bufferView: 3, componentType: 5123, count: 6, type: "SCALAR" },
      { bufferView: 4, componentType: 5126, count: 2, type: "SCALAR", min: [0], max: [1] },
      { bufferView: 5, componentType: 5126, count: 2, type: "VEC3" },
    ],
    bufferViews: [
      ...[view(0, 48), view(48, 48), view(96, 32), view(164, 12), view(128, 8), view(136, 24)],
      ...(texture === undefined ? [] : [view(176, texture.length)]),
    ],
    buffers: [{ byteLength: bin.length }],
  };
  edit?.(gltf);
  return { gltf, bin };
}

const padded = (length: number): number => Math.ceil(length / 4) * 4;

/** A binary glTF 2.0 file: header, JSON chunk, binary chunk, each padded to four bytes. */
export function packGlb(gltf: object, bin: Uint8Array): Uint8Array {
  const json = new TextEncoder().encode(JSON.stringify(gltf));
  const total = 12 + 8 + padded(json.length) + 8 + padded(bin.length);
  const glb = new Uint8Array(total);
  const words = new DataView(glb.buffer);
  const binAt = 20 + padded(json.length);
  [0x46546c67, 2, total, padded(json.length), 0x4e4f534a].forEach((word, index) => {
    words.setUint32(4 * index, word, true);
  });
  glb.fill(0x20, 20, binAt).set(json, 20);
  words.setUint32(binAt, padded(bin.length), true);
  words.setUint32(binAt + 4, 0x004e4942, true);
  glb.set(bin, binAt + 8);
  return glb;
}

/** The document of a binary glTF file. */
export function readGlbJson(glb: Uint8Array): Record<string, unknown> {
  const length = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
  return JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length)));
}

/** A PNG of one colour. */
export function plainPng(
  width: number,
  height: number,
  rgba: readonly [number, number, number, number],
): Promise<Uint8Array> {
  const texels = new Uint8Array(width * height * 4);
  for (let at = 0; at < texels.length; at += 4) texels.set(rgba, at);
  return encodePng({ width, height, rgba: texels });
}
