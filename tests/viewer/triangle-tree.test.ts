/** The tree against another one, three-mesh-bvh, on shapes whose triangles lie everywhere, side by side and in one plane. */
import { BufferAttribute, BufferGeometry, DoubleSide, PlaneGeometry, Ray, TorusKnotGeometry, Vector3 } from "three";
import { MeshBVH } from "three-mesh-bvh";
import { describe, expect, test } from "vitest";
import { type Triangles, TriangleTree } from "../../web/viewer/triangle-tree.ts";

const SHAPES: readonly (readonly [string, BufferGeometry])[] = [
  ["a knot", new TorusKnotGeometry(1, 0.3, 90, 16)],
  ["a sheet along the axes", new PlaneGeometry(2, 2, 12, 12)],
];

function treesOf(geometry: BufferGeometry): { triangles: Triangles; tree: TriangleTree; other: MeshBVH } {
  const positions = Float32Array.from(geometry.getAttribute("position").array);
  const index = Uint32Array.from(geometry.index?.array ?? []);
  const triangles = { positions, index };
  const copy = new BufferGeometry();
  copy.setAttribute("position", new BufferAttribute(positions.slice(), 3));
  copy.setIndex(new BufferAttribute(index, 1));
  return { triangles, tree: new TriangleTree(triangles), other: new MeshBVH(copy, { indirect: true }) };
}

/** Rays from all around at about the middle, and some along the axes. */
const RAYS = Array.from({ length: 300 }, (_, step) => {
  const origin = new Vector3(4 * Math.sin(step), 4 * Math.cos(step * 1.7), 4 * Math.sin(step * 2.3));
  const at = new Vector3(Math.sin(step * 3.1), Math.cos(step * 5.7), Math.sin(step * 7));
  if (step % 10 === 0) return new Ray(at.clone().setZ(3), new Vector3(0, 0, -1));
  return new Ray(origin, at.sub(origin).normalize());
});

describe.each(SHAPES)("on %s", (_name, geometry) => {
  const { triangles, tree, other } = treesOf(geometry);

  test("a ray first meets what it first meets in another tree", () => {
    const hits = RAYS.map((ray) => tree.raycastFirst(ray, 0, Number.POSITIVE_INFINITY)?.distance ?? null);
    const others = RAYS.map((ray) => other.raycastFirst(ray, DoubleSide)?.distance ?? null);
    expect(hits).toEqual(others);
    expect(hits.filter((hit) => hit !== null).length).toBeGreaterThan(30);
  });

  test("a ray meets all that it meets in another tree, from near to far", () => {
    const [near, far] = [3.2, 4.4];
    const distances = (hits: readonly { distance: number }[]): number[] =>
      hits.map(({ distance }) => distance).sort((a, b) => a - b);
    for (const ray of RAYS) {
      expect(distances(tree.raycast(ray, near, far))).toEqual(distances(other.raycast(ray, DoubleSide, near, far)));
    }
  });

  test("the nearest point is as near as in another tree, and none is beyond the reach", () => {
    for (const { origin } of RAYS) {
      const nearest = other.closestPointToPoint(origin)?.distance ?? 0;
      expect(tree.closest(origin, Number.POSITIVE_INFINITY)?.distance).toBeCloseTo(nearest, 12);
      expect(tree.closest(origin, nearest * 0.999)).toBeNull();
    }
  });

  test("a walk into every box meets every triangle once", () => {
    const met: number[] = [];
    tree.walk({ enters: () => true, meets: (_triangle, place) => met.push(place) < 0 });
    expect(met.sort((a, b) => a - b)).toEqual(Array.from({ length: triangles.index.length / 3 }, (_, place) => place));
  });

  test("boxes follow vertices that move", () => {
    const moved = treesOf(geometry);
    moved.triangles.positions.forEach((value, place) => {
      moved.triangles.positions[place] = value * 0.5 + (place % 3);
    });
    moved.tree.refit();
    const anew = new TriangleTree(moved.triangles);
    for (const { origin } of RAYS) {
      const far = Number.POSITIVE_INFINITY;
      expect(moved.tree.closest(origin, far)?.distance).toBeCloseTo(anew.closest(origin, far)?.distance ?? -1, 12);
    }
  });
});

test("a tree of nothing answers nothing", () => {
  const tree = new TriangleTree({ positions: new Float32Array(), index: new Uint32Array() });
  const [ray] = RAYS as [Ray];
  expect(tree.raycastFirst(ray, 0, 10)).toBeNull();
  expect(tree.raycast(ray, 0, 10)).toEqual([]);
  expect(tree.closest(ray.origin, 10)).toBeNull();
});

test("many triangles in one place are held, too", () => {
  const index = Uint32Array.from({ length: 300 }, (_, corner) => corner % 3);
  const tree = new TriangleTree({ positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0), index });
  expect(tree.raycast(new Ray(new Vector3(0.2, 0.2, 1), new Vector3(0, 0, -1)), 0, 10)).toHaveLength(100);
});
