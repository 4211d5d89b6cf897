/** The demo's files, made once for all tests of a file, and the triangles of a model as a viewer places them at rest. */

import { type Document, WebIO } from "@gltf-transform/core";
import { generateDemo } from "../../scripts/demo/generate.ts";

export type DemoFiles = ReadonlyMap<string, Uint8Array>;

export async function makeDemoFiles(): Promise<DemoFiles> {
  const files = new Map<string, Uint8Array>();
  for await (const { path, bytes } of generateDemo()) files.set(path, bytes);
  return files;
}

export function demoFile(files: DemoFiles, path: string): Uint8Array {
  const bytes = files.get(path);
  if (!bytes) throw new Error(`the demo has no file ${path}: it has ${[...files.keys()].join(", ")}`);
  return bytes;
}

/** Attributes of all triangles of one material; the demo's meshes need no node transforms. */
export interface MaterialGeometry {
  readonly material: string;
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  /** Null for parts without a picture. */
  readonly uvs: Float32Array | null;
  readonly indices: ArrayLike<number>;
  /** Texels of the base colour picture; null without one. */
  readonly pictureSize: readonly [number, number] | null;
}

export async function readDemoModel(
  files: DemoFiles,
  id: string,
): Promise<{ document: Document; parts: MaterialGeometry[] }> {
  const document = await new WebIO().readBinary(demoFile(files, `${id}.glb`));
  const primitives = document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives());
  const parts = primitives.map((primitive): MaterialGeometry => {
    const floats = (name: string) => (primitive.getAttribute(name)?.getArray() as Float32Array | undefined) ?? null;
    const material = primitive.getMaterial();
    return {
      material: material?.getName() ?? "",
      positions: floats("POSITION") as Float32Array,
      normals: floats("NORMAL") as Float32Array,
      uvs: floats("TEXCOORD_0"),
      indices: primitive.getIndices()?.getArray() as Uint16Array,
      pictureSize: material?.getBaseColorTexture()?.getSize() ?? null,
    };
  });
  return { document, parts };
}

export type Vec3 = [number, number, number];

export const vectorAt = (array: ArrayLike<number>, vertex: number): Vec3 => [
  array[vertex * 3] as number,
  array[vertex * 3 + 1] as number,
  array[vertex * 3 + 2] as number,
];

/** Least and greatest corner of all parts, metres. */
export function modelBounds(parts: readonly MaterialGeometry[]): { min: Vec3; max: Vec3 } {
  const min: Vec3 = [Infinity, Infinity, Infinity];
  const max: Vec3 = [-Infinity, -Infinity, -Infinity];
  for (const { positions } of parts) {
    positions.forEach((value, index) => {
      const axis = (index % 3) as 0 | 1 | 2;
      min[axis] = Math.min(min[axis], value);
      max[axis] = Math.max(max[axis], value);
    });
  }
  return { min, max };
}
