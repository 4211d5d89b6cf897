/**
 * A standing square of one metre in two halves, left and right, each of a material of its own or both of one. Either way a
 * point of the square has the same texture coordinates, those of the whole square: what a decal paints can be compared.
 */
import { buildGlb, type MeshParts } from "./model-builder.ts";

/** From `left` to `right` along x, -0.5 to 0.5; faces +Z, u to the right, v down. */
function strip(left: number, right: number, material: number): MeshParts {
  const u = (x: number): number => x + 0.5;
  return {
    positions: [left, -0.5, 0, right, -0.5, 0, right, 0.5, 0, left, 0.5, 0],
    normals: [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1],
    uvs: [u(left), 1, u(right), 1, u(right), 0, u(left), 0],
    indices: [0, 1, 2, 0, 2, 3],
    material,
  };
}

/** @param more meshes besides, of material 0 or 1 */
export function halvesGlb({ materials, more = [] }: { materials: 1 | 2; more?: readonly MeshParts[] }): Uint8Array {
  return buildGlb({
    meshes: [strip(-0.5, 0, 0), strip(0, 0.5, materials - 1), ...more],
    materials: [{ name: "Left" }, { name: "Right" }].slice(0, materials),
  });
}

/** A small square above the left half, of the right half's material, with the texture's top left corner to itself. */
export const ROOF: MeshParts = {
  positions: [-0.2, -0.1, 0.1, -0.05, -0.1, 0.1, -0.05, 0.1, 0.1, -0.2, 0.1, 0.1],
  normals: [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1],
  uvs: [0, 0.3, 0.3, 0.3, 0.3, 0, 0, 0],
  indices: [0, 1, 2, 0, 2, 3],
  material: 1,
};
