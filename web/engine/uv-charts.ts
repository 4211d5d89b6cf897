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
  const join = (triangle: number, u: number, v: number): void => {
    const key = gridKey(u, v);
    const first = firstWith.get(key);
    if (first === undefined) {
      firstWith.set(key, triangle);
      return;
    }
    const a = rootOf(first);
    const b = rootOf(triangle);
    charts[Math.max(a, b)] = Math.min(a, b);
  };
  for (let triangle = 0; triangle < count; triangle++) {
    const start = triangle * 6;
    const [right, down] = repeatOf(uvTriangles, start);
    for (let at = start; at < start + 6; at += 2) {
      const u = uvTriangles[at] as number;
      const v = uvTriangles[at + 1] as number;
      join(triangle, u - right, v - down);
      // By their own places too: a chart that crosses the texture's border would come apart there.
      if (right !== 0 || down !== 0) join(triangle, u, v);
    }
  }
  for (let triangle = 0; triangle < count; triangle++) charts[triangle] = rootOf(triangle);
  return charts;
}

/** The repeat of the texture that the middle of a triangle lies in; its six numbers begin at `start`. */
export function repeatOf(corners: Float32Array, start: number): readonly [right: number, down: number] {
  const at = (place: number): number => corners[start + place] as number;
  return [Math.floor((at(0) + at(2) + at(4)) / 3), Math.floor((at(1) + at(3) + at(5)) / 3)];
}

/** The same for all corners that count as one. */
export function gridKey(u: number, v: number): number {
  return Math.round(u * GRID) * 2 ** 26 + Math.round(v * GRID);
}
