/** A primitive written with a further set of texture coordinates: all else of each corner stays as it was, byte for byte. */

import type { Accessors, Elements } from "../accessors.ts";
import { indexAt, isObject, type JsonObject, objectAt } from "../gltf-json.ts";
import type { MaterialPart } from "./material-parts.ts";

/**
 * Gives the part's vertices their new coordinates as the set `texCoord` (and as those before it that it lacks: glTF counts
 * them without gaps). A vertex whose corners lie in several charts becomes several. Throws "bad-container" for an attribute or a
 * target that has not as many elements as there are vertices.
 * @param corners two numbers a corner of its triangles, 0 to 1
 */
export function writePart(part: MaterialPart, corners: Float32Array, texCoord: number, accessors: Accessors): void {
  const { primitive, indices, vertexCount } = part;
  // It draws nothing, and glTF knows no accessor without elements.
  if (indices.length === 0) return;
  const { origins, uvs, placed } = splitVertices(indices, corners);
  const attributes = objectAt(primitive, "attributes") ?? {};
  const moved = new Map<number, number>();
  const move = (index: number): number => {
    let found = moved.get(index);
    if (found === undefined) {
      found = accessors.addLike(index, picked(accessors.read(index, vertexCount), origins));
      accessors.replace(index);
      moved.set(index, found);
    }
    return found;
  };
  primitive.attributes = movedAttributes(attributes, move);
  if (Array.isArray(primitive.targets)) {
    primitive.targets = primitive.targets.map((target) => (isObject(target) ? movedAttributes(target, move) : target));
  }
  const set = accessors.addUvs(uvs);
  const written = objectAt(primitive, "attributes") as JsonObject;
  for (let i = 0; i < texCoord; i++) written[`TEXCOORD_${i}`] ??= set;
  written[`TEXCOORD_${texCoord}`] = set;
  const listed = indexAt(primitive, "indices");
  if (listed !== undefined) accessors.replace(listed);
  primitive.indices = accessors.addIndices(placed, origins.length);
  // Strips and fans have become single triangles.
  delete primitive.mode;
}

function movedAttributes(attributes: JsonObject, move: (index: number) => number): JsonObject {
  return Object.fromEntries(
    Object.entries(attributes).map(([key, index]) => [key, typeof index === "number" ? move(index) : index]),
  );
}

function picked({ elementBytes, bytes }: Elements, origins: readonly number[]): Elements {
  const chosen = new Uint8Array(origins.length * elementBytes);
  for (const [i, origin] of origins.entries()) {
    chosen.set(bytes.subarray(origin * elementBytes, (origin + 1) * elementBytes), i * elementBytes);
  }
  return { count: origins.length, elementBytes, bytes: chosen };
}

/** Vertices in the order in which corners name them: one for each place of a former one. */
function splitVertices(indices: Uint32Array, corners: Float32Array) {
  const copies = new Map<number, number[]>();
  const origins: number[] = [];
  const uvs: number[] = [];
  const placed = new Uint32Array(indices.length);
  for (const [corner, origin] of indices.entries()) {
    const u = corners[2 * corner] as number;
    const v = corners[2 * corner + 1] as number;
    let own = copies.get(origin);
    if (own === undefined) {
      own = [];
      copies.set(origin, own);
    }
    let vertex = own.find((copy) => uvs[2 * copy] === u && uvs[2 * copy + 1] === v);
    if (vertex === undefined) {
      vertex = origins.length;
      origins.push(origin);
      uvs.push(u, v);
      own.push(vertex);
    }
    placed[corner] = vertex;
  }
  return { origins, uvs: Float32Array.from(uvs), placed };
}
