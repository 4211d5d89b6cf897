/**
 * Charts of a material: triangles that hang together by shared corners in the unfolded texture. Two charts that lie on the same
 * texels are one here, for a place of the texture cannot tell them apart.
 */

/** UVs nearer than this are the same corner: a quarter of a texel at the largest texture, 8192. */
const GRID = 8192 * 4;

/**
 * The chart of each triangle, named by the lowest index of its triangles.
 *
 * @param uvTriangles six numbers a triangle, as `Engine.uvTriangles` gives them
 */
export function chartsOf(uvTriangles: Float32Array): Uint32Array {
  const count = Math.floor(uvTriangles.length / 6);
  // A union-find forest: roots point at themselves, and the lower index always wins.
  const charts = Uint32Array.from({ length: count }, (_, triangle) => triangle);
  const rootOf = (triangle: number): number => {
    let at = triangle;
    while (charts[at] !== at) {
      const above = charts[at] as number;
      charts[at] = charts[above] as number;
      at = above;
    }
    return at;
  };
  const firstWith = new Map<number, number>();
  for (let triangle = 0; triangle < count; triangle++) {
    const own = uvTriangles.subarray(triangle * 6, triangle * 6 + 6);
    // By their own places too: a chart that crosses the texture's border would come apart there.
    const corners = [...broughtBack(own), ...own];
    for (let corner = 0; corner < 12; corner += 2) {
      const key = gridKey(corners[corner] as number, corners[corner + 1] as number);
      const first = firstWith.get(key) ?? triangle;
      firstWith.set(key, first);
      const [a, b] = [rootOf(first), rootOf(triangle)];
      charts[Math.max(a, b)] = Math.min(a, b);
    }
  }
  for (let triangle = 0; triangle < count; triangle++) charts[triangle] = rootOf(triangle);
  return charts;
}

/** A triangle's six numbers, moved as a whole into the repeat of the texture that its middle lies in. */
export function broughtBack(corners: Float32Array): number[] {
  const [u0, v0, u1, v1, u2, v2] = corners as unknown as [number, number, number, number, number, number];
  const u = Math.floor((u0 + u1 + u2) / 3);
  const v = Math.floor((v0 + v1 + v2) / 3);
  return [u0 - u, v0 - v, u1 - u, v1 - v, u2 - u, v2 - v];
}

/** The same for all corners that count as one. */
export function gridKey(u: number, v: number): number {
  return Math.round(u * GRID) * 2 ** 26 + Math.round(v * GRID);
}
