/**
 * Which texels a set of UV triangles covers, by the top-left rule (spec.md, 2): a checker of its own, written apart
 * from the core's rasteriser so that both do not share a mistake.
 */

export interface Coverage {
  readonly width: number;
  readonly height: number;
  /** How many triangles cover the texel. */
  readonly counts: Uint16Array;
  /** Number of the chart that covers the texel; -1 for none. */
  readonly charts: Int32Array;
}

/**
 * `uvs`: two floats a vertex. `indices`: three a triangle. `chartOf`: the chart's number for each triangle.
 * Coordinates are 32-bit floats and sizes powers of two, so products of differences are exact in 64 bits for all but
 * sliver-thin cases, and both sides of an edge are decided by one and the same number.
 */
export function coverTexels(
  uvs: ArrayLike<number>,
  indices: ArrayLike<number>,
  chartOf: ArrayLike<number>,
  width: number,
  height: number,
): Coverage {
  const counts = new Uint16Array(width * height);
  const charts = new Int32Array(width * height).fill(-1);
  for (let triangle = 0; triangle * 3 < indices.length; triangle++) {
    const corner = (offset: number): [number, number] => {
      const vertex = indices[triangle * 3 + offset] as number;
      return [(uvs[vertex * 2] as number) * width, (uvs[vertex * 2 + 1] as number) * height];
    };
    let [a, b, c] = [corner(0), corner(1), corner(2)];
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area === 0) continue;
    if (area < 0) [b, c] = [c, b];
    const edges = [edgeTest(a, b), edgeTest(b, c), edgeTest(c, a)];
    const left = Math.max(0, Math.floor(Math.min(a[0], b[0], c[0]) - 0.5));
    const right = Math.min(width - 1, Math.ceil(Math.max(a[0], b[0], c[0])));
    const top = Math.max(0, Math.floor(Math.min(a[1], b[1], c[1]) - 0.5));
    const bottom = Math.min(height - 1, Math.ceil(Math.max(a[1], b[1], c[1])));
    for (let row = top; row <= bottom; row++) {
      for (let column = left; column <= right; column++) {
        if (!edges.every((isInside) => isInside(column + 0.5, row + 0.5))) continue;
        const texel = row * width + column;
        counts[texel] = (counts[texel] as number) + 1;
        charts[texel] = chartOf[triangle] as number;
      }
    }
  }
  return { width, height, counts, charts };
}

type Point = readonly [number, number];

/** Tells whether a point lies on the inner side of an edge of a triangle that runs clockwise as seen on the image. */
function edgeTest(from: Point, to: Point): (x: number, y: number) => boolean {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  // The inside lies to the right of the direction of travel: a top edge runs right, a left edge runs up.
  const ownsItsPoints = (dy === 0 && dx > 0) || dy < 0;
  // The same end first for both triangles of a shared edge: their numbers differ in sign alone.
  const swapped = from[0] > to[0] || (from[0] === to[0] && from[1] > to[1]);
  const [p, q] = swapped ? [to, from] : [from, to];
  const sign = swapped ? -1 : 1;
  return (x, y) => {
    const side = sign * ((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]));
    return side > 0 || (side === 0 && ownsItsPoints);
  };
}

/** The least distance, in texels, between texels of different charts; `limit` where none are nearer than that. */
export function leastChartDistance({ width, height, charts }: Coverage, limit: number): number {
  let least = limit;
  const chartAt = (x: number, y: number): number =>
    x < 0 || y < 0 || x >= width || y >= height ? -1 : (charts[y * width + x] as number);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const own = chartAt(x, y);
      const neighbours = [chartAt(x - 1, y), chartAt(x + 1, y), chartAt(x, y - 1), chartAt(x, y + 1)];
      const isBorder = own >= 0 && neighbours.some((neighbour) => neighbour !== own);
      // Looking up alone is enough: of two texels, the lower one meets the other.
      if (!isBorder) continue;
      for (let dy = -limit; dy <= 0; dy++) {
        for (let dx = -limit; dx <= limit; dx++) {
          const other = chartAt(x + dx, y + dy);
          if (other >= 0 && other !== own) least = Math.min(least, Math.hypot(dx, dy));
        }
      }
    }
  }
  return least;
}

/** Charts as the connected parts of the UV layout: triangles that share a UV corner belong together. */
export function chartNumbers(uvs: ArrayLike<number>, indices: ArrayLike<number>): Int32Array {
  return connectedParts(indices, (vertex) => `${uvs[vertex * 2]},${uvs[vertex * 2 + 1]}`);
}

/** The number of the part for each triangle; corners with the same key are one. */
export function connectedParts(indices: ArrayLike<number>, keyOf: (vertex: number) => string): Int32Array {
  const parents: number[] = [];
  const find = (node: number): number => {
    let root = node;
    while (parents[root] !== root) root = parents[root] as number;
    parents[node] = root;
    return root;
  };
  const nodes = new Map<string, number>();
  const nodeOf = (vertex: number): number => {
    const key = keyOf(vertex);
    const known = nodes.get(key);
    if (known !== undefined) return known;
    const node = parents.length;
    parents.push(node);
    nodes.set(key, node);
    return node;
  };
  for (let first = 0; first < indices.length; first += 3) {
    const root = find(nodeOf(indices[first] as number));
    for (let corner = 1; corner < 3; corner++) parents[find(nodeOf(indices[first + corner] as number))] = root;
  }
  return Int32Array.from({ length: indices.length / 3 }, (_, triangle) =>
    find(nodeOf(indices[triangle * 3] as number)),
  );
}
