/** A part of a model as a Mesh of OpenUSD. */
import { cross } from "../affine-map.ts";
import type { TexturePlace } from "../texture-place.ts";
import type { PosedPart } from "./posed-parts.ts";
import type { UsdMaterial } from "./usd-material.ts";
import { block, tuplesText, tupleText } from "./usd-text.ts";

/** Numbers in a row, `size` a vertex. */
interface Attribute {
  readonly values: Float64Array;
  readonly size: number;
}

/** @param binding path of the material's prim */
export function usdMesh(part: PosedPart, material: UsdMaterial, binding: string, prim: string): string[] {
  const uvs = [...material.uvs].map(([primvar, place]) => [primvar, placedUvs(part, place)] as const);
  const { positions, normals } = part;
  // Without normals faces are flat (glTF 2.0, 3.7.2.1): no two of them share a vertex then.
  const order = normals === null ? part.triangles : null;
  const text = ({ values, size }: Attribute): string =>
    tuplesText(order === null ? values : picked(values, size, order), size);
  const triangles = order === null ? part.triangles : order.map((_, corner) => corner);
  const vertexWise = (declaration: string, list: string): string[] => [
    `${declaration} = ${list} (`,
    '    interpolation = "vertex"',
    ")",
  ];
  const lines = [
    `uniform bool doubleSided = ${material.isDoubleSided ? 1 : 0}`,
    `float3[] extent = [${extentOf(positions).map(tupleText).join(", ")}]`,
    `int[] faceVertexCounts = [${new Array(triangles.length / 3).fill("3").join(", ")}]`,
    `int[] faceVertexIndices = [${triangles.join(", ")}]`,
    `rel material:binding = <${binding}>`,
    ...vertexWise("normal3f[] normals", tuplesText(normals ?? flatNormals(positions, part.triangles), 3)),
    `point3f[] points = ${text({ values: positions, size: 3 })}`,
    ...uvs.flatMap(([primvar, values]) => vertexWise(`texCoord2f[] primvars:${primvar}`, text({ values, size: 2 }))),
    'uniform token subdivisionScheme = "none"',
  ];
  return [`def Mesh "${prim}" (`, '    prepend apiSchemas = ["MaterialBindingAPI"]', ...block(")", lines)];
}

function picked(values: Float64Array, size: number, order: Uint32Array): Float64Array {
  const all = new Float64Array(order.length * size);
  for (const [i, vertex] of order.entries()) {
    for (let c = 0; c < size; c++) all[i * size + c] = values[vertex * size + c] as number;
  }
  return all;
}

/** Three times each, one for each corner. */
function flatNormals(positions: Float64Array, triangles: Uint32Array): Float64Array {
  const normals = new Float64Array(3 * triangles.length);
  for (let i = 0; i < triangles.length; i += 3) {
    const side = (to: number): number[] =>
      [0, 1, 2].map((axis) => {
        const at = (corner: number): number => positions[3 * (triangles[i + corner] as number) + axis] as number;
        return at(to) - at(0);
      });
    const [x, y, z] = cross(side(1), side(2));
    const length = Math.sqrt(x * x + y * y + z * z);
    const normal = length === 0 ? [0, 0, 1] : [x / length, y / length, z / length];
    for (let corner = 0; corner < 3; corner++) normals.set(normal, 3 * (i + corner));
  }
  return normals;
}

/** OpenUSD counts v from the bottom. A part without the set shows one place of its picture, as in glTF viewers. */
function placedUvs(part: PosedPart, place: TexturePlace): Float64Array {
  const values = new Float64Array((part.positions.length / 3) * 2);
  const given = part.uvs(place.texCoord);
  for (let i = 0; i < values.length; i += 2) {
    const [u, v] = place.apply(given?.[i] ?? 0, given?.[i + 1] ?? 0);
    values[i] = u;
    values[i + 1] = 1 - v;
  }
  return values;
}

function extentOf(positions: Float64Array): number[][] {
  const least = [0, 1, 2].map((axis) => positions[axis] ?? 0);
  const most = [...least];
  for (let i = 0; i < positions.length; i++) {
    const [axis, value] = [i % 3, positions[i] as number];
    if (value < (least[axis] as number)) least[axis] = value;
    if (value > (most[axis] as number)) most[axis] = value;
  }
  return [least, most];
}
