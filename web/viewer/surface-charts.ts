/** The charts of a surface's materials as pieces of the surface: what lights up on the model when a chart is pointed at. */

import { gridKey } from "../engine/uv-charts.ts";
import type { RestingSurface } from "./resting-surface.ts";
import { UvCharts } from "./uv-charts.ts";
import { edgeKey, numberOf } from "./uv-edges.ts";
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
    for (let triangle = 0; triangle < materialOfTriangle.length; triangle++) {
      if (materialOfTriangle[triangle] === material) triangles.push(triangle);
    }
    const corners = new Float32Array(triangles.length * 6);
    let to = 0;
    for (const triangle of triangles) {
      for (let corner = 0; corner < 3; corner++) {
        const vertex = index[triangle * 3 + corner] as number;
        corners[to++] = uvs[vertex * 2] as number;
        corners[to++] = uvs[vertex * 2 + 1] as number;
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
    // Corners by numbers of their own, so that an edge is one number, too: with words for edges a model of 200,000 triangles held a
    // desktop's page for most of a second when the pointer came upon it first, now for a third of that.
    const corners = new Map<number, number>();
    const cornerOf = (vertex: number): number =>
      numberOf(corners, gridKey(uvs[vertex * 2] as number, uvs[vertex * 2 + 1] as number));
    const edges = new Map<number, number>();
    /** Of each edge, where it begins in `vertices`, and how many triangles have it. */
    const begins = new Uint32Array(vertices.length);
    const uses = new Uint32Array(vertices.length);
    for (const [place, member] of members.entries()) {
      const start = place * 3;
      for (let corner = 0; corner < 3; corner++) {
        vertices[start + corner] = index[(triangles[member] as number) * 3 + corner] as number;
      }
      for (let corner = 0; corner < 3; corner++) {
        const from = cornerOf(vertices[start + corner] as number);
        const edge = numberOf(edges, edgeKey(from, cornerOf(vertices[nextCorner(start + corner)] as number)));
        if (uses[edge] === 0) begins[edge] = start + corner;
        uses[edge] = (uses[edge] as number) + 1;
      }
    }
    const borders: number[] = [];
    for (let edge = 0; edge < edges.size; edge++) {
      const at = begins[edge] as number;
      if (uses[edge] === 1) borders.push(vertices[at] as number, vertices[nextCorner(at)] as number);
    }
    return { triangles: vertices, borders: Uint32Array.from(borders) };
  }
}

/** The next corner of the same triangle; places in a list of three vertices a triangle. */
const nextCorner = (at: number): number => (at % 3 === 2 ? at - 2 : at + 1);
