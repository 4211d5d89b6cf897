/** Charts laid into one texture: where each pattern lies, and the primitive that comes of joining them. */

import type { Chart } from "./chart.ts";
import { packRectangles } from "./skyline-packer.ts";
import type { Vec2, Vec3 } from "./vector.ts";

export interface AtlasSize {
  /** Texels. */
  readonly width: number;
  readonly height: number;
  /** Texels kept free between charts and along the border. */
  readonly spacing: number;
}

export interface PlacedChart {
  readonly chart: Chart;
  /** Texels of the top left corner of the pattern's bounding rectangle. */
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly texelsPerMetre: number;
  /** The pattern's own coordinates of that corner, metres. */
  readonly flatMin: Vec2;
  readonly flatMax: Vec2;
}

export interface Atlas extends AtlasSize {
  readonly charts: readonly PlacedChart[];
}

/** Attributes of a triangle list; positions in metres, UVs with v down in [0, 1]. */
export interface Geometry {
  readonly positions: Float32Array<ArrayBuffer>;
  readonly normals: Float32Array<ArrayBuffer>;
  readonly uvs: Float32Array<ArrayBuffer>;
  readonly indices: Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;
}

export function layOutCharts(charts: readonly Chart[], size: AtlasSize): Atlas {
  const bounds = charts.map((chart) => flatBounds(chart.flat));
  const items = charts.map((chart, index) => {
    const { min, max } = bounds[index] as { min: Vec2; max: Vec2 };
    const density = chart.density ?? 1;
    return { name: chart.name, width: (max[0] - min[0]) * density, height: (max[1] - min[1]) * density };
  });
  const { scale, places } = packRectangles(items, size);
  return {
    ...size,
    charts: charts.map((chart, index) => {
      const { min, max } = bounds[index] as { min: Vec2; max: Vec2 };
      const place = places.get(chart.name) as { x: number; y: number };
      const texelsPerMetre = scale * (chart.density ?? 1);
      return {
        chart,
        ...place,
        width: (max[0] - min[0]) * texelsPerMetre,
        height: (max[1] - min[1]) * texelsPerMetre,
        texelsPerMetre,
        flatMin: min,
        flatMax: max,
      };
    }),
  };
}

export function placedChart(atlas: Atlas, name: string): PlacedChart {
  const found = atlas.charts.find((placed) => placed.chart.name === name);
  if (!found) throw new RangeError(`placedChart: the atlas has no chart named "${name}"`);
  return found;
}

/** Where a point of a chart's pattern lies on the texture, texels. */
function flatToTexel(placed: PlacedChart, flat: Vec2): Vec2 {
  return [
    placed.x + (flat[0] - placed.flatMin[0]) * placed.texelsPerMetre,
    placed.y + (flat[1] - placed.flatMin[1]) * placed.texelsPerMetre,
  ];
}

/** The same in [0, 1]. */
export function flatToUv(atlas: Atlas, placed: PlacedChart, flat: Vec2): Vec2 {
  const [x, y] = flatToTexel(placed, flat);
  return [x / atlas.width, y / atlas.height];
}

/** All charts of an atlas as one triangle list. */
export function joinAtlas(atlas: Atlas): Geometry {
  return joinGeometry(
    atlas.charts.map((placed) => placed.chart),
    (chart, vertex) => flatToUv(atlas, placedChart(atlas, chart.name), chart.flat[vertex] as Vec2),
  );
}

/** Charts as one triangle list, with UVs by a function of chart and vertex. */
export function joinGeometry(charts: readonly Chart[], uvOf: (chart: Chart, vertex: number) => Vec2): Geometry {
  const positions: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  const indices: number[] = [];
  for (const chart of charts) {
    const first = positions.length / 3;
    for (let vertex = 0; vertex < chart.positions.length; vertex++) {
      positions.push(...(chart.positions[vertex] as Vec3));
      normals.push(...(chart.normals[vertex] as Vec3));
      uvs.push(...uvOf(chart, vertex));
    }
    for (const [a, b, c] of chart.triangles) indices.push(a + first, b + first, c + first);
  }
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    uvs: new Float32Array(uvs),
    // 65535 itself restarts primitives and is no valid index.
    indices: positions.length / 3 <= 65535 ? new Uint16Array(indices) : new Uint32Array(indices),
  };
}

function flatBounds(flat: readonly Vec2[]): { min: Vec2; max: Vec2 } {
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of flat) {
    minX = Math.min(minX, x);
    minY = Math.min(minY, y);
    maxX = Math.max(maxX, x);
    maxY = Math.max(maxY, y);
  }
  return { min: [minX, minY], max: [maxX, maxY] };
}
