/** The triangles of one material, from all meshes of a model, as they are unwrapped: in the file's own order. */

import type { Accessors } from "../accessors.ts";
import { isMirroring, type Linear, turned } from "../affine-map.ts";
import { badContainer, indexAt, isObject, type JsonObject, listOf, objectAt, textAt } from "../gltf-json.ts";
import { isOfTriangles, trianglesOf } from "../primitive-triangles.ts";
import type { TexturePlace } from "../texture-place.ts";
import type { ChartMesh } from "./chart-atlas.ts";
import { scaleOfMesh } from "./part-scale.ts";

/** One primitive of a mesh. */
export interface MaterialPart {
  /** The JSON to change. */
  readonly primitive: JsonObject;
  /** Three a triangle, into its attributes. */
  readonly indices: Uint32Array;
  readonly vertexCount: number;
  /** As the file has them. */
  readonly positions: Float64Array;
  /** Two numbers a vertex, in the old picture; null without. */
  readonly uvs: Float64Array | null;
  readonly scale: Linear;
}

export interface MaterialUses {
  /** Primitives of triangles. */
  readonly faces: { readonly mesh: number; readonly primitive: JsonObject }[];
  /** What names the material and is not unwrapped: primitives of points and lines, and variants of what has another one. */
  readonly others: JsonObject[];
}

/** Where a model uses a material; one past the last is that of primitives without one. */
export function usesOf(json: JsonObject, material: number, name: string): MaterialUses {
  const faces: MaterialUses["faces"] = [];
  const others: JsonObject[] = [];
  const implied = listOf(json, "materials", name).length;
  for (const [mesh, { primitives }] of listOf(json, "meshes", name).entries()) {
    if (!Array.isArray(primitives)) throw badContainer(name, `“meshes[${mesh}]” has no primitives`, `meshes[${mesh}]`);
    for (const primitive of primitives) {
      if (!isObject(primitive)) continue;
      if ((primitive.material ?? implied) !== material) {
        others.push(...variantsOf(primitive).filter((variant) => variant.material === material));
        continue;
      }
      const drawn = indexAt(objectAt(primitive, "attributes"), "POSITION") !== undefined;
      if (isOfTriangles(primitive) && drawn) faces.push({ mesh, primitive });
      else others.push(primitive);
    }
  }
  return { faces, others };
}

/** What KHR_materials_variants gives a primitive in place of its own material. */
function variantsOf(primitive: JsonObject): JsonObject[] {
  const { mappings } = objectAt(objectAt(primitive, "extensions"), "KHR_materials_variants") ?? {};
  return Array.isArray(mappings) ? mappings.filter(isObject) : [];
}

/**
 * @param json as `primitive`, with numbers as numbers
 * @param place where the material's picture lies on it
 */
export function readPart(
  json: JsonObject,
  { mesh, primitive }: { readonly mesh: number; readonly primitive: JsonObject },
  place: TexturePlace,
  accessors: Accessors,
  name: string,
): MaterialPart {
  const attributes = objectAt(primitive, "attributes") ?? {};
  const read = (key: string, type: string): Float64Array | null => {
    const index = indexAt(attributes, key);
    if (index === undefined) return null;
    if (textAt(accessors.at(index), "type") !== type) {
      throw badContainer(name, `“accessors[${index}]” is ${key} but no ${type}`, `accessors[${index}].type`);
    }
    return accessors.readNumbers(index);
  };
  const positions = read("POSITION", "VEC3") ?? new Float64Array();
  const vertexCount = positions.length / 3;
  const uvs = read(`TEXCOORD_${place.texCoord}`, "VEC2");
  if (uvs !== null && uvs.length !== 2 * vertexCount) {
    throw badContainer(name, `a TEXCOORD of “meshes[${mesh}]” has another length than POSITION`, `meshes[${mesh}]`);
  }
  for (let i = 0; uvs !== null && i < uvs.length; i += 2) {
    const [u, v] = place.apply(uvs[i] as number, uvs[i + 1] as number);
    // What is no number shows no place of the picture: any will do, and a colour of it leaves no hole.
    uvs[i] = Number.isFinite(u) ? u : 0;
    uvs[i + 1] = Number.isFinite(v) ? v : 0;
  }
  const indices = trianglesOf(primitive, vertexCount, accessors, name);
  return { primitive, indices, vertexCount, positions, uvs, scale: scaleOfMesh(json, mesh, accessors, name) };
}

/** xatlas takes triangles below about 1e-7 units of area for none, so parts come to it in this size. */
const EXTENT = 1000;

/** The parts in one scale for xatlas. */
export function chartMeshes(parts: readonly MaterialPart[]): ChartMesh[] {
  const placed = parts.map(({ positions, scale }) => everyThree(positions, scale));
  let extent = 0;
  for (const positions of placed) {
    for (let axis = 0; axis < 3; axis++) {
      let least = Number.POSITIVE_INFINITY;
      let most = Number.NEGATIVE_INFINITY;
      for (let i = axis; i < positions.length; i += 3) {
        least = Math.min(least, positions[i] as number);
        most = Math.max(most, positions[i] as number);
      }
      extent = Math.max(extent, most - least);
    }
  }
  const factor = extent > 0 ? EXTENT / extent : 1;
  return parts.map(({ indices, scale }, i) => ({
    positions: Float32Array.from(placed[i] as Float64Array, (value) => value * factor),
    indices,
    isMirrored: isMirroring(scale),
  }));
}

/** Vectors turned; what is no number would hang those who compare it. */
function everyThree(values: Float64Array, scale: Linear): Float64Array {
  const result = new Float64Array(values.length);
  for (let i = 0; i < values.length; i += 3) {
    const vector = turned(scale, values[i] as number, values[i + 1] as number, values[i + 2] as number);
    for (let axis = 0; axis < 3; axis++) {
      const value = vector[axis] as number;
      result[i + axis] = Number.isFinite(value) ? value : 0;
    }
  }
  return result;
}
