/** The charts of a surface's materials as pieces of the surface: what lights up on the model when a chart is pointed at. */

import { gridKey } from "../engine/uv-charts.ts";
import type { RestingSurface } from "./resting-surface.ts";
import { UvCharts } from "./uv-charts.ts";
import type { TexturePlace } from "./viewer-api.ts";

/** A chart's triangles, three vertices of the surface each, and its border, two each. */
export interface SurfaceChart {
  readonly triangles: Uint32Array;
  readonly borders: Uint32Array;
}

interface MaterialCharts {
  readonly charts: UvCharts;
  /** Triangles of the surface, in the charts' order. */
  readonly triangles: readonly number[];
}

export class SurfaceCharts {
  readonly #surface: RestingSurface;
  readonly #materials = new Map<number, MaterialCharts>();
  readonly #found = new Map<string, SurfaceChart>();

  constructor(surface: RestingSurface) {
    this.#surface = surface;
  }

  /** The chart at a place of a texture; null beside all charts. The same chart is the same object. */
  at({ material, uv }: TexturePlace): SurfaceChart | null {
    const own = this.#chartsOf(material);
    const chart = own.charts.chartAt(uv);
    if (chart === null) {
      return null;
    }
    const key = `${material} ${chart}`;
    const known = this.#found.get(key) ?? this.#gather(own, chart);
    this.#found.set(key, known);
    return known;
  }

  #chartsOf(material: number): MaterialCharts {
    const known = this.#materials.get(material);
    if (known !== undefined) {
      return known;
    }
    const { materialOfTriangle, index, uvs } = this.#surface;
    const triangles: number[] = [];
    for (const [triangle, of] of materialOfTriangle.entries()) {
      if (of === material) {
        triangles.push(triangle);
      }
    }
    const corners = new Float32Array(triangles.length * 6);
    for (const [place, triangle] of triangles.entries()) {
      for (let corner = 0; corner < 3; corner++) {
        const vertex = index[triangle * 3 + corner] as number;
        corners.set(uvs.subarray(vertex * 2, vertex * 2 + 2), place * 6 + corner * 2);
      }
    }
    const made = { charts: new UvCharts(corners), triangles };
    this.#materials.set(material, made);
    return made;
  }

  #gather({ charts, triangles }: MaterialCharts, chart: number): SurfaceChart {
    const { index, uvs } = this.#surface;
    const members = charts.trianglesOf(chart);
    const vertices = new Uint32Array(members.length * 3);
    const ends = new Map<string, { readonly line: readonly [number, number]; uses: number }>();
    for (const [place, member] of members.entries()) {
      const corners = index.subarray((triangles[member] as number) * 3, (triangles[member] as number) * 3 + 3);
      vertices.set(corners, place * 3);
      for (let corner = 0; corner < 3; corner++) {
        const next = (corner + 1) % 3;
        const keys = [corner, next].map((at) => {
          const vertex = corners[at] as number;
          return gridKey(uvs[vertex * 2] as number, uvs[vertex * 2 + 1] as number);
        });
        const key = `${Math.min(...keys)} ${Math.max(...keys)}`;
        const known = ends.get(key);
        if (known === undefined) {
          ends.set(key, { line: [corners[corner] as number, corners[next] as number], uses: 1 });
        } else {
          known.uses += 1;
        }
      }
    }
    const borders = [...ends.values()].filter(({ uses }) => uses === 1).flatMap(({ line }) => line);
    return { triangles: vertices, borders: Uint32Array.from(borders) };
  }
}
