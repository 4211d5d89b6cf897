/** Which materials lie where: for a search that need not see a material twice. */
import type { MeshBVH } from "three-mesh-bvh";

/** Materials from this one on have no bit of their own, but this one's together. */
export const SHARED_BIT = 31;

/** For each node of the tree, by its number, the materials of the triangles below it: a bit each. */
export function nodeMaterials(bvh: MeshBVH, materialOfTriangle: ArrayLike<number>): readonly number[] {
  const materials: number[] = [];
  /** The nodes from the root to the leaf that is looked at, by their depth; the root itself is never asked for. */
  const path: number[] = [];
  bvh.shapecast({
    intersectsBounds: (_box, _isLeaf, _score, depth, node) => {
      path[depth] = node;
      return true;
    },
    intersectsRange: (first, count, _contained, depth) => {
      let bits = 0;
      for (let place = first; place < first + count; place++) {
        bits |= 1 << Math.min(SHARED_BIT, materialOfTriangle[bvh.resolveTriangleIndex(place)] as number);
      }
      for (let level = depth; level > 0; level--) {
        const node = path[level] as number;
        materials[node] = (materials[node] ?? 0) | bits;
      }
      return false;
    },
  });
  return materials;
}
