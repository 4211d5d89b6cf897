/** Small models made in code: GLBs whose geometry, UVs and textures a test knows exactly. */
import { writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";

export interface MeshParts {
  /** Three a vertex. */
  readonly positions: readonly number[];
  readonly normals?: readonly number[];
  /** Two a vertex. */
  readonly uvs?: readonly number[];
  readonly indices?: readonly number[];
  readonly material?: number;
}

export interface ModelParts {
  readonly meshes: readonly MeshParts[];
  readonly materials?: readonly JsonObject[];
  readonly textures?: readonly JsonObject[];
  readonly samplers?: readonly JsonObject[];
  readonly images?: readonly { readonly bytes: Uint8Array; readonly mimeType: string; readonly name?: string }[];
  /** More top-level members; they go over the ones that are made here. */
  readonly more?: JsonObject;
}

const FLOAT = 5126;
const UNSIGNED_INT = 5125;

/** The parts as JSON and BIN, for tests that want to change them before they become a file. */
export function buildModel(parts: ModelParts): { json: JsonObject; binary: Uint8Array } {
  const pieces: Uint8Array[] = [];
  const bufferViews: JsonObject[] = [];
  const accessors: JsonObject[] = [];
  let length = 0;
  const addView = (bytes: Uint8Array): number => {
    bufferViews.push({ buffer: 0, byteOffset: length, byteLength: bytes.length });
    pieces.push(bytes, new Uint8Array((4 - (bytes.length % 4)) % 4));
    length += Math.ceil(bytes.length / 4) * 4;
    return bufferViews.length - 1;
  };
  const addAccessor = (values: readonly number[], size: 1 | 2 | 3): number => {
    const array = size === 1 ? Uint32Array.from(values) : Float32Array.from(values);
    const bounds = size === 3 ? { min: extent(values, Math.min), max: extent(values, Math.max) } : {};
    accessors.push({
      bufferView: addView(new Uint8Array(array.buffer)),
      componentType: size === 1 ? UNSIGNED_INT : FLOAT,
      count: values.length / size,
      type: size === 1 ? "SCALAR" : `VEC${size}`,
      ...bounds,
    });
    return accessors.length - 1;
  };
  const primitives = parts.meshes.map((mesh): JsonObject => {
    const attributes: JsonObject = { POSITION: addAccessor(mesh.positions, 3) };
    if (mesh.normals !== undefined) attributes.NORMAL = addAccessor(mesh.normals, 3);
    if (mesh.uvs !== undefined) attributes.TEXCOORD_0 = addAccessor(mesh.uvs, 2);
    return {
      attributes,
      ...(mesh.indices !== undefined && { indices: addAccessor(mesh.indices, 1) }),
      ...(mesh.material !== undefined && { material: mesh.material }),
    };
  });
  const images = (parts.images ?? []).map(({ bytes, mimeType, name }): JsonObject => {
    return { bufferView: addView(bytes), mimeType, ...(name !== undefined && { name }) };
  });
  const binary = new Uint8Array(length);
  let at = 0;
  for (const piece of pieces) {
    binary.set(piece, at);
    at += piece.length;
  }
  const list = (key: string, items: readonly JsonObject[] | undefined): JsonObject =>
    items === undefined || items.length === 0 ? {} : { [key]: [...items] };
  const json: JsonObject = {
    asset: { version: "2.0", generator: "Texelcast's tests" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives }],
    ...list("materials", parts.materials),
    ...list("textures", parts.textures),
    ...list("samplers", parts.samplers),
    ...list("images", images),
    accessors,
    bufferViews,
    buffers: [{ byteLength: length }],
    ...parts.more,
  };
  return { json: structuredClone(json), binary };
}

export function buildGlb(parts: ModelParts): Uint8Array {
  const { json, binary } = buildModel(parts);
  return writeGlb(json, binary);
}

function extent(values: readonly number[], pick: (...numbers: number[]) => number): number[] {
  return [0, 1, 2].map((axis) => pick(...values.filter((_, i) => i % 3 === axis).map(Math.fround)));
}

/** The square [-size/2, size/2]² in the XY plane, facing +Z, its picture upright: u to the right, v down. */
export function plane(size = 1, material?: number): MeshParts {
  const h = size / 2;
  return {
    positions: [-h, -h, 0, h, -h, 0, h, h, 0, -h, h, 0],
    normals: [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1],
    uvs: [0, 1, 1, 1, 1, 0, 0, 0],
    indices: [0, 1, 2, 0, 2, 3],
    ...(material !== undefined && { material }),
  };
}

/** Unit cube; each face has its own cell of a 3 × 2 atlas, with a margin so that no texel belongs to two. */
export function cube(material?: number): MeshParts {
  const faces: readonly (readonly [normal: number[], right: number[]])[] = [
    [
      [0, 0, 1],
      [1, 0, 0],
    ],
    [
      [0, 0, -1],
      [-1, 0, 0],
    ],
    [
      [1, 0, 0],
      [0, 0, -1],
    ],
    [
      [-1, 0, 0],
      [0, 0, 1],
    ],
    [
      [0, 1, 0],
      [1, 0, 0],
    ],
    [
      [0, -1, 0],
      [1, 0, 0],
    ],
  ];
  const positions: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  const indices: number[] = [];
  const margin = 0.02;
  for (const [face, [normal, right]] of faces.entries()) {
    const up = cross(normal, right);
    const u0 = (face % 3) / 3;
    const v0 = Math.floor(face / 3) / 2;
    for (const [x, y] of [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ] as const) {
      for (let axis = 0; axis < 3; axis++) {
        positions.push(((normal[axis] ?? 0) + x * (right[axis] ?? 0) + y * (up[axis] ?? 0)) / 2);
      }
      normals.push(...normal);
      uvs.push(u0 + margin + ((x + 1) / 2) * (1 / 3 - 2 * margin), v0 + margin + ((1 - y) / 2) * (1 / 2 - 2 * margin));
    }
    indices.push(...[0, 1, 2, 0, 2, 3].map((i) => 4 * face + i));
  }
  return { positions, normals, uvs, indices, ...(material !== undefined && { material }) };
}

function cross(a: readonly number[], b: readonly number[]): number[] {
  const at = (v: readonly number[], i: number): number => v[i % 3] ?? 0;
  return [0, 1, 2].map((i) => at(a, i + 1) * at(b, i + 2) - at(a, i + 2) * at(b, i + 1));
}

/** Unit-radius sphere about the origin: longitude along u, latitude along v. */
export function sphere(segments = 64, rings = 32, material?: number): MeshParts {
  return grid(segments, rings, material, (u, v) => {
    const polar = v * Math.PI;
    const around = u * 2 * Math.PI;
    const normal = [Math.sin(polar) * Math.sin(around), Math.cos(polar), Math.sin(polar) * Math.cos(around)];
    return { position: normal, normal };
  });
}

/** Open cylinder of radius 1 and height 2 about the Y axis. */
export function cylinder(segments = 64, material?: number): MeshParts {
  return grid(segments, 1, material, (u, v) => {
    const around = u * 2 * Math.PI;
    const normal = [Math.sin(around), 0, Math.cos(around)];
    return { position: [normal[0] ?? 0, 1 - 2 * v, normal[2] ?? 0], normal };
  });
}

function grid(
  columns: number,
  rows: number,
  material: number | undefined,
  shape: (u: number, v: number) => { position: readonly number[]; normal: readonly number[] },
): MeshParts {
  const positions: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  const indices: number[] = [];
  for (let row = 0; row <= rows; row++) {
    for (let column = 0; column <= columns; column++) {
      const { position, normal } = shape(column / columns, row / rows);
      positions.push(...position);
      normals.push(...normal);
      uvs.push(column / columns, row / rows);
    }
  }
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const a = row * (columns + 1) + column;
      const b = a + columns + 1;
      indices.push(a, b, b + 1, a, b + 1, a + 1);
    }
  }
  return { positions, normals, uvs, indices, ...(material !== undefined && { material }) };
}
